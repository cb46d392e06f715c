// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in broken joints: flow between blocks, from chambers and into the open, and heat between gas
// and walls. Scope: see joint_gas.h; measure() and press() have been called.
#include <algorithm>
#include <cmath>

#include "gas/joint_gas.h"
#include "math/prefetch.h"

namespace muckpile {

void JointGas::exchange(std::size_t c, double dt) {
  const std::uint32_t i = cracks_[c].i, j = cracks_[c].j;
  // Without a branch: which side has more is hard to foresee.
  const std::uint32_t back =
      reservoirs_[j].head.pressure > reservoirs_[i].head.pressure ? i ^ j : 0u;
  const std::size_t from = i ^ back, to = j ^ back;
  const Reservoir &donor = reservoirs_[from], &taker = reservoirs_[to];
  if (!(donor.head.pressure > taker.head.pressure)) return;
  const double flux = flow_.flux(donor.head, taker.head, passage_[c]);
  const double most = way_of(c) * equalising_mass(donor, donor.room, taker.head, taker.room);
  const double mass = std::min(flux * area_[c] * dt, most);
  move(from, -mass, donor.enthalpy);
  move(to, mass, donor.enthalpy);
  note_film(from, c, mass);
  note_film(to, c, mass);
}

/// Between the blocks of all joints.
void JointGas::exchange_all(double dt) {
  constexpr std::size_t kAhead = 16;
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    if (c + kAhead < cracks_.size()) {
      prefetch(&reservoirs_[cracks_[c + kAhead].i]);
      prefetch(&reservoirs_[cracks_[c + kAhead].j]);
    }
    if (cracks_[c].joint) exchange(c, dt + owed_[c]);
  }
}

/// What leaves takes its enthalpy along, so all of the energy is gone before all of the mass.
JointGas::Reservoir JointGas::inlet_of(const GasChamber& chamber) const {
  if (!(chamber.gas.pressure > 0.0)) return {};
  const double share = chamber.energy_share > 0.0 ? chamber.energy_share : 1.0 / flow_.gamma();
  return {flow_.head(chamber.gas), chamber.gas.density * share,
          chamber.mass / chamber.gas.density / chamber.ways, chamber.enthalpy};
}

/// From the chamber into block b, or back; returns what block b got. Half of the crack is its own.
GasFlow JointGas::feed(std::size_t b, std::size_t c, const Reservoir& inlet, double dt) {
  const Reservoir& gas = reservoirs_[b];
  if (!(inlet.head.pressure > 0.0) || !(gas.room > 0.0)) return {};
  const bool in = inlet.head.pressure > gas.head.pressure;
  const Reservoir &up = in ? inlet : gas, &down = in ? gas : inlet;
  const double most = end_of(c) * equalising_mass(up, up.room, down.head, down.room);
  const double mass =
      std::min(flow_.flux(up.head, down.head, passage_[c]) * 0.5 * area_[c] * dt, most);
  note_film(b, c, 2.0 * mass);
  return move(b, in ? mass : -mass, up.enthalpy);
}

/// From block b into the atmosphere; returns what left it.
GasFlow JointGas::vent(std::size_t b, std::size_t c, double dt) {
  const Reservoir& gas = reservoirs_[b];
  if (!(gas.head.pressure > p_.ambient)) return {};
  const double most =
      end_of(c) * gas.outflow * gas.room * (1.0 - p_.ambient * gas.head.inverse_pressure);
  const double mass =
      std::min(flow_.flux(gas.head, outside_, passage_[c]) * 0.5 * area_[c] * dt, most);
  note_film(b, c, 2.0 * mass);
  move(b, -mass, gas.enthalpy);
  return {mass, mass * gas.enthalpy};
}

JointGas::Flows JointGas::flow(std::span<const GasChamber> chambers, double dt) {
  Flows flows{std::vector<GasFlow>(chambers.size()), std::vector<double>(chambers.size()), {}};
  for (Change& change : changes_) change.flow = {};
  exchange_all(dt);
  std::vector<Reservoir> inlets;
  for (const GasChamber& chamber : chambers) inlets.push_back(inlet_of(chamber));
  for (const std::uint32_t c : ending_) {
    const Crack& crack = cracks_[c];
    const double time = dt + owed_[c];  // [s]
    each_block(crack, [&](std::size_t b) {
      if (!owned(b)) return;
      if (crack.hole >= 0) {
        const auto hole = static_cast<std::size_t>(crack.hole);
        const GasFlow got = feed(b, c, inlets[hole], time);
        flows.from_hole[hole] += got;
        flows.out_of_hole[hole] += std::max(0.0, got.mass);
      }
      if (crack.surfaces) flows.vented += vent(b, c, time);
    });
  }
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    if (!owned(b)) continue;
    cells_[b].content.mass += changes_[b].flow.mass;
    cells_[b].content.energy += changes_[b].flow.energy;
  }
  std::fill(owed_.begin(), owed_.end(), 0.0);
  clock_ += dt;
  return flows;
}

/// Most blocks have the same, and calm ones one that is several times as long.
const RockLayers::Step& JointGas::cooling_step(double dt) {
  RockLayers::Step& last = cooling_steps_[last_cooling_];
  if (last.length() == dt) return last;
  last_cooling_ = 1 - last_cooling_;
  RockLayers::Step& other = cooling_steps_[last_cooling_];
  if (other.length() != dt) other = RockLayers::Step(rock_, dt);
  return other;
}

/// The gas and its walls change at once: no step is too long. What has broken since the last time
/// is cold, and shares in the warmth of the rest.
void JointGas::cool_block(std::size_t b, double dt) {
  GasContent& gas = cells_[b].content;
  const double film = changes_[b].film, wall = rooms_[b].walls;
  if (!(wall > 0.0) || (gas.heat == 0.0 && !(film > 0.0))) return;
  if (wall > gas.wall) {
    for (double& excess : gas.rock) excess *= gas.wall / wall;
    gas.wall = wall;
  }
  const RockLayers::Step& step = cooling_step(dt);
  if (!(gas.mass > 0.0) || !(film > 0.0)) {
    step.take(0.0, gas.rock);
    return;
  }
  const double capacity = gas.mass * cv();  // [J/K]
  const double warmer = gas.energy / capacity - heat_.rock_temperature();
  const double before = wall * dt * (1.0 / film + 1.0 / capacity);
  const double heat = step.take_from(warmer, before, gas.rock) * wall * dt;
  gas.energy -= heat;
  gas.heat += heat;
  spent_.heat += heat;
}

void JointGas::cool(double dt) {
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    owed_cooling_[b] += dt;
    if (left_out(b)) continue;
    if (heat_.acts() && owned(b)) cool_block(b, owed_cooling_[b]);
    changes_[b].film = owed_cooling_[b] = 0.0;
  }
}

JointGas::Opened JointGas::open_wide() {
  Opened opened;
  std::vector<double> lost_volume;
  for (const auto [c, gone, volume, broken] : wide_) {
    bool pushes = false;
    each_block(cracks_[c], [&](std::size_t b) { pushes = pushes || gauge_[b] > 0.0; });
    if (pushes && !gone) continue;
    lost_volume.resize(cells_.size(), 0.0);
    opened.joints.push_back(cracks_[c].facet);
    keeps_[cracks_[c].facet] = Keeps::nothing;
    listed_ = false;
    each_block(cracks_[c], [&, volume, broken](std::size_t b) {
      lost_volume[b] += volume;
      rooms_[b].broken -= broken;
    });
  }
  if (!opened.joints.empty())
    std::erase_if(open_to_gas_, [&](std::uint32_t f) { return keeps_[f] == Keeps::nothing; });
  for (std::size_t b = 0; b < lost_volume.size(); ++b) {
    if (!owned(b) || lost_volume[b] == 0.0) continue;
    GasContent& gas = cells_[b].content;
    const double kept = std::max(0.0, 1.0 - lost_volume[b] / cells_[b].volume);
    GasContent rest = gas;
    rest.mass *= kept;
    rest.energy *= kept;
    rest.volume *= kept;
    rest.broken = rooms_[b].broken;
    // The last joint takes all: no rounding is left behind.
    if (kept < 1e-12) rest.mass = rest.energy = rest.volume = rest.broken = rest.pressed = 0.0;
    opened.vented += {gas.mass - rest.mass, gas.energy - rest.energy};
    opened.could_do += work_to_ambient(pressure(cells_[b]), (1.0 - kept) * cells_[b].volume);
    gas = rest;
  }
  return opened;
}

}  // namespace muckpile
