// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in broken joints; see the header.
#include "gas/joint_gas.h"

#include <algorithm>
#include <cmath>

#include "explosive/require.h"

namespace muckpile {

JointGas::JointGas(const Parameters& parameters) : p_(parameters), flow_(parameters.flow) {
  explosive_detail::require_positive("residual_aperture", "m", p_.residual_aperture);
  explosive_detail::require_not_negative("ambient_pressure", "Pa", p_.ambient);
}

void JointGas::set_network(const FacetNetwork& network) {
  const std::size_t count = network.blocks().size();
  cells_.assign(count, {});
  reached_.assign(count, 0);
  changes_.assign(count, {});
  points_.assign(count, {});
  cracks_.clear();
  owned_.resize(count);
  for (std::size_t b = 0; b < count; ++b) owned_[b] = network.blocks()[b].owned ? 1 : 0;
  touches_.assign(count, 0);
  for (const BoundaryFace& face : network.faces()) {
    int& code = touches_[static_cast<std::size_t>(face.block)];
    if (face.hole < 0) {
      code |= 1;
    } else if (code < 2) {  // of a block on two crushed zones the first counts
      code += 2 * (face.hole + 1);
    }
  }
}

JointGas::Crack JointGas::crack_of(const FacetNetwork& network, std::size_t f) const {
  const FacetEnds facet = network.ends(f);
  const FacetNetwork::OpenJoint open = network.open_joint(f);
  const auto i = static_cast<std::size_t>(facet.i), j = static_cast<std::size_t>(facet.j);
  const bool joint = facet.kind == FacetKind::joint;
  const int hole_i = touches_[i] / 2 - 1, hole_j = touches_[j] / 2 - 1;
  const double aperture = p_.residual_aperture + open.opening;
  const double width = 2.0 * std::sqrt(open.area / M_PI);
  return {.facet = f,
          .i = i,
          .j = j,
          .joint = joint,
          .wide = open.wide,
          .hole = joint && hole_i == hole_j ? hole_i : -1,
          .surfaces = joint && (touches_[i] & touches_[j] & 1) != 0,
          .passage = flow_.passage(aperture, width),
          .area = aperture * width,
          .volume = (joint ? 0.5 : 1.0) * open.area * aperture};
}

/// Blocks with gas, those beside them, and those on a chamber. Copies may have got gas on their own
/// rank, which is not known here yet: all of them count.
void JointGas::mark_reached(const FacetNetwork& network, const std::vector<char>& fed) {
  const auto holds = [&](std::size_t b) {
    const int hole = touches_[b] / 2 - 1;
    return !owned(b) || cells_[b].content.mass > 0.0 ||
           (hole >= 0 && fed[static_cast<std::size_t>(hole)] != 0);
  };
  std::fill(reached_.begin(), reached_.end(), 0);
  for (const std::size_t f : open_to_gas_) {
    const FacetEnds facet = network.ends(f);
    const auto i = static_cast<std::size_t>(facet.i), j = static_cast<std::size_t>(facet.j);
    const bool joint = facet.kind == FacetKind::joint;
    const bool any = holds(i) || (joint && holds(j));
    if (any) reached_[i] = 1;
    if (any && joint) reached_[j] = 1;
  }
}

void JointGas::measure(const FacetNetwork& network, const std::vector<char>& fed) {
  open_to_gas_.clear();
  for (std::size_t f = 0; f < network.facet_count(); ++f) {
    if (network.states()[f] != FacetState::intact && network.memory()[f].gas)
      open_to_gas_.push_back(f);
  }
  mark_reached(network, fed);
  for (GasCell& cell : cells_) cell.volume = cell.ways = 0.0;
  chamber_ways_.assign(fed.size(), 0.0);
  cracks_.clear();
  for (const std::size_t f : open_to_gas_) {
    const FacetEnds facet = network.ends(f);
    const bool joint = facet.kind == FacetKind::joint;
    if (reached_[static_cast<std::size_t>(facet.i)] == 0 &&
        (!joint || reached_[static_cast<std::size_t>(facet.j)] == 0)) {
      continue;
    }
    const Crack crack = crack_of(network, f);
    cracks_.push_back(crack);
    const double ways = (joint ? crack.way() : 0.0) + (crack.hole >= 0 ? crack.end() : 0.0) +
                        (crack.surfaces ? crack.end() : 0.0);
    for (std::size_t b : {crack.i, crack.j}) {
      if (b == crack.j && !joint) continue;
      cells_[b].volume += crack.volume;
      cells_[b].ways += ways;
      if (crack.hole >= 0 && owned(b))
        chamber_ways_[static_cast<std::size_t>(crack.hole)] += crack.end();
    }
  }
}

double JointGas::pressure(const GasCell& cell) const {
  if (!(cell.content.mass > 0.0) || !(cell.volume > 0.0)) return 0.0;
  return cell.content.entropy / cell.content.mass *
         std::pow(cell.content.mass / cell.volume, flow_.gamma());
}

void JointGas::press(FacetNetwork& network) {
  const std::span<double> pressure_of = network.gas_pressure();
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    points_[b] = point(b);
    pressure_of[b] = std::max(0.0, points_[b].pressure - p_.ambient);
  }
}

GasPoint JointGas::point(std::size_t b) const {
  const GasCell& cell = cells_[b];
  return {pressure(cell), cell.volume > 0.0 ? cell.content.mass / cell.volume : 0.0};
}

/// What would have to flow for the pressure of both to be the same [kg].
double JointGas::equalising_mass(const GasPoint& from, double from_volume, double thinning,
                                 double to_volume) {
  return from.density * (1.0 - thinning) * from_volume * to_volume / (from_volume + to_volume);
}

void JointGas::move(std::size_t b, double mass, double entropy_per_mass) {
  changes_[b].mass += mass;
  changes_[b].entropy += mass * entropy_per_mass;
}

void JointGas::exchange(const Crack& crack, double dt) {
  std::size_t from = crack.i, to = crack.j;
  if (points_[to].pressure > points_[from].pressure) std::swap(from, to);
  const GasPoint& donor = points_[from];
  const GasCell &source = cells_[from], &sink = cells_[to];
  if (!(donor.pressure > points_[to].pressure) || !(sink.volume > 0.0)) return;
  const CrackFlow::Fall fall = flow_.fall(donor.pressure, points_[to].pressure);
  const double way = crack.way();
  const double mass = std::min(flow_.flux(donor, fall, crack.passage) * crack.area * dt,
                               equalising_mass(donor, source.volume * way / source.ways,
                                               fall.thinning, sink.volume * way / sink.ways));
  const double entropy = source.content.entropy / source.content.mass;
  move(from, -mass, entropy);
  move(to, mass, entropy);
}

/// From the chamber into block b, or back; returns the mass.
double JointGas::feed(std::size_t b, const Crack& crack, const GasChamber& chamber, double dt) {
  const GasPoint& gas = points_[b];
  const GasCell& cell = cells_[b];
  if (!(chamber.gas.pressure > 0.0) || !(cell.volume > 0.0)) return 0.0;
  const bool in = chamber.gas.pressure > gas.pressure;
  const GasPoint& donor = in ? chamber.gas : gas;
  const CrackFlow::Fall fall = flow_.fall(donor.pressure, in ? gas.pressure : chamber.gas.pressure);
  const double room = chamber.mass / chamber.gas.density * crack.end() / chamber.ways;
  const double most =
      equalising_mass(donor, room, fall.thinning, cell.volume * crack.end() / cell.ways);
  const double mass =
      std::min(flow_.flux(donor, fall, crack.passage) * 0.5 * crack.area * dt, most);
  const double entropy = in ? donor.pressure / std::pow(donor.density, flow_.gamma())
                            : cell.content.entropy / cell.content.mass;
  move(b, in ? mass : -mass, entropy);
  return in ? mass : -mass;
}

/// From block b into the atmosphere; returns the mass.
double JointGas::vent(std::size_t b, const Crack& crack, double dt) {
  const GasPoint& gas = points_[b];
  const GasCell& cell = cells_[b];
  if (!(gas.pressure > p_.ambient)) return 0.0;
  const CrackFlow::Fall fall = flow_.fall(gas.pressure, p_.ambient);
  const double share = cell.content.mass * crack.end() / cell.ways;
  const double mass = std::min(flow_.flux(gas, fall, crack.passage) * 0.5 * crack.area * dt,
                               share * (1.0 - fall.thinning));
  move(b, -mass, cell.content.entropy / cell.content.mass);
  return mass;
}

JointGas::Flows JointGas::flow(FacetNetwork& network, std::span<const GasChamber> chambers,
                               double dt) {
  Flows flows{std::vector<double>(chambers.size(), 0.0), 0.0};
  std::fill(changes_.begin(), changes_.end(), Change{});
  for (const Crack& crack : cracks_) {
    if (crack.joint) exchange(crack, dt);
    if (crack.wide) network.release_gas(crack.facet);
    for (std::size_t b : {crack.i, crack.j}) {
      if (!owned(b)) continue;  // the ground neither
      if (crack.hole >= 0) {
        const auto hole = static_cast<std::size_t>(crack.hole);
        flows.from_hole[hole] += feed(b, crack, chambers[hole], dt);
      }
      if (crack.surfaces) flows.vented += vent(b, crack, dt);
      if (crack.wide) changes_[b].lost_volume += crack.volume;
    }
  }
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    if (!owned(b)) continue;
    GasContent& content = cells_[b].content;
    content.mass += changes_[b].mass;
    content.entropy += changes_[b].entropy;
    if (changes_[b].lost_volume == 0.0) continue;
    const double kept = std::max(0.0, 1.0 - changes_[b].lost_volume / cells_[b].volume);
    // The last joint takes all: no rounding is left behind.
    const GasContent rest =
        kept < 1e-12 ? GasContent{} : GasContent{kept * content.mass, kept * content.entropy};
    flows.vented += content.mass - rest.mass;
    content = rest;
  }
  return flows;
}

double JointGas::mass() const {
  double sum = 0.0;
  for (std::size_t b = 0; b < cells_.size(); ++b) sum += owned(b) ? cells_[b].content.mass : 0.0;
  return sum;
}

double JointGas::greatest_pressure() const {
  double greatest = 0.0;
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    if (owned(b)) greatest = std::max(greatest, pressure(cells_[b]));
  }
  return greatest;
}

double JointGas::blocks_with_gas() const {
  double count = 0.0;
  for (std::size_t b = 0; b < cells_.size(); ++b)
    count += owned(b) && cells_[b].content.mass > 0.0 ? 1.0 : 0.0;
  return count;
}

}  // namespace muckpile
