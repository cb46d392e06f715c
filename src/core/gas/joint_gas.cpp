// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in broken joints: where gas can be, how much room it has, what it presses; see the header.
// Scope: apertures are joint_gas_apertures.cpp, flow and heat joint_gas_flow.cpp.
#include "gas/joint_gas.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "args/require.h"
#include "math/byte_lanes.h"

namespace muckpile {
namespace {

/// to[k] = of(from[k]), in a form that the compiler vectorises.
template <class Of>
void transform_all(const std::vector<double>& from, std::vector<double>& to, const Of& of) {
  const double* source = from.data();
  double* const __restrict into = to.data();
  for (std::size_t k = 0, count = to.size(); k < count; ++k) into[k] = of(source[k]);
}

constexpr double kFinestSpacing = 0.01;  // of cracks [m]
/// Of what a block presses, the atmosphere at least: one whose pressure has changed by less from
/// one look at all blocks to the next is calm, until it has changed by more (docs/theory/gas.md).
constexpr double kCalm = 0.005;
/// Of its energy gas pays at most that share in full for a step; of more it keeps some.
constexpr double kPaysInFull = 0.5;

}  // namespace

JointGas::JointGas(const Parameters& parameters)
    : p_(parameters),
      joint_(parameters.joint),
      flow_(parameters.flow),
      heat_(parameters.heat),
      outside_(flow_.head({parameters.ambient, 0.0})) {
  require_positive("gas_constant", "J/(kg K)", p_.gas_constant);
  require_not_negative("ambient_pressure", "Pa", p_.ambient);
  if (!(p_.open_gas >= 1.0)) refuse_value("open_gas", ">= 1", "", p_.open_gas);
  if (p_.crack_spacing != 0.0 && !(p_.crack_spacing >= kFinestSpacing))
    refuse_value("crack_spacing", "0 or >= " + number_text(kFinestSpacing), "m", p_.crack_spacing);
  if (heat_.acts()) rock_ = heat_.rock();
  if (p_.calm_every < 1) refuse_value("calm_every", ">= 1", "", p_.calm_every);
}

void JointGas::set_rooms(const JointRooms& rooms) {
  const std::size_t count = rooms.blocks().size();
  cells_.assign(count, {});
  reached_.assign(count, 0);
  holds_.assign(count, 0);
  left_out_.assign(count, 0);
  calm_.assign(count, 0);
  left_out_since_.assign(rooms.facet_count(), kFlows);
  changes_.assign(count, {});
  rooms_.assign(count, {});
  reservoirs_.assign(count, {});
  for (auto* numbers : {&density_, &pressure_, &root_, &gauge_, &seen_, &owed_cooling_, &ways_now_})
    numbers->assign(count, 0.0);
  cracks_.clear();
  crack_facets_.clear();
  ending_.clear();
  wide_.clear();
  ends_.clear();
  keeps_.assign(rooms.facet_count(), Keeps::unknown);
  open_to_gas_.clear();
  seen_gives_.assign(rooms.facet_count(), 0.0);
  seen_points_.assign(rooms.facet_count(), kUnseen);
  look_at_all();
  owned_.resize(count);
  for (std::size_t b = 0; b < count; ++b) owned_[b] = rooms.blocks()[b].owned ? 1 : 0;
  touches_.assign(count, 0);
  for (const BoundaryFace& face : rooms.faces()) {
    int& code = touches_[static_cast<std::size_t>(face.block)];
    if (face.hole < 0) {
      code |= 1;
    } else if (code < 2) {  // of a block on two crushed zones the first counts
      code += 2 * (face.hole + 1);
    }
  }
}

/// A joint whose law knows its apertures is a crack of the rock itself.
double JointGas::cracks_of(const JointRooms& rooms, std::size_t f) const {
  if (p_.crack_spacing == 0.0 || rooms.law_has_apertures(f)) return 1.0;
  const auto size = [&](int b) {
    return std::cbrt(rooms.blocks()[static_cast<std::size_t>(b)].volume);
  };
  const FacetEnds facet = rooms.ends(f);
  const bool joint = facet.kind == FacetKind::joint;
  const double way = joint ? 0.5 * (size(facet.i) + size(facet.j)) : size(facet.i);
  return std::max(1.0, way / p_.crack_spacing);
}

JointGas::End JointGas::end_of(const JointRooms& rooms, std::size_t f) const {
  const FacetEnds facet = rooms.ends(f);
  const auto i = static_cast<std::size_t>(facet.i), j = static_cast<std::size_t>(facet.j);
  const bool joint = facet.kind == FacetKind::joint, mirror = facet.kind == FacetKind::mirror;
  const int of_i = touches_[i], of_j = mirror ? of_i : joint ? touches_[j] : 0;
  return {.i = static_cast<std::uint32_t>(i),
          .j = static_cast<std::uint32_t>(j),
          .hole = of_i / 2 == of_j / 2 ? of_i / 2 - 1 : -1,
          .joint = joint,
          .mirror = mirror,
          .surfaces = (of_i & of_j & 1) != 0};
}

void JointGas::look_at_all() {
  for (auto* flags : {&calm_, &left_out_}) std::fill(flags->begin(), flags->end(), 0);
  for (auto* numbers : {&seen_, &owed_cooling_, &owed_})
    std::fill(numbers->begin(), numbers->end(), 0.0);
  for (Change& change : changes_) change.film = 0.0;
  for (Rooms& rooms : rooms_) rooms.gives = 0.0;
  std::fill(left_out_since_.begin(), left_out_since_.end(), kFlows);
  std::fill(seen_points_.begin(), seen_points_.end(), kUnseen);
  step_ = p_.calm_every - 1;
  clock_ = 0.0;
  listed_ = false;
}

/// Which blocks are left out of the coming step. All ranks find the same, as they do pressures.
/// Blocks on a chamber that feeds them are never calm, nor are empty ones, which gas may reach.
void JointGas::find_calm(const std::vector<char>& fed) {
  const bool looked_at_all = step_ == 0;
  step_ = (step_ + 1) % p_.calm_every;
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    const double pressed = std::max(p_.ambient, pressure_[b]);
    const int hole = touches_[b] / 2 - 1;
    const bool is_fed = hole >= 0 && fed[static_cast<std::size_t>(hole)] != 0;
    const bool steady =
        !is_fed && pressure_[b] > 0.0 && std::abs(pressed - seen_[b]) <= kCalm * pressed;
    calm_[b] = steady && (looked_at_all || calm_[b] != 0) ? 1 : 0;
    if (looked_at_all) seen_[b] = pressed;
  }
}

/// Whether cracks_ is still right. A list depends on which facets are broken, and on which blocks
/// have gas, or are copies, which may have got gas on their own rank, or lie on a chamber.
bool JointGas::list_holds(const JointRooms& rooms, const std::vector<char>& fed) {
  const auto intact = static_cast<std::size_t>(
      std::count(rooms.states().begin(), rooms.states().end(), FacetState::intact));
  bool same = listed_ && intact == intact_ && fed == fed_;
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    const char left_out = step_ != 0 ? calm_[b] : 0;
    same = same && left_out == left_out_[b];
    left_out_[b] = left_out;
    const int hole = touches_[b] / 2 - 1;
    const bool holds = !owned(b) || cells_[b].content.mass > 0.0 ||
                       (hole >= 0 && fed[static_cast<std::size_t>(hole)] != 0);
    same = same && holds == (holds_[b] != 0);
    holds_[b] = holds ? 1 : 0;
  }
  intact_ = intact;
  fed_ = fed;
  return same;
}

void JointGas::find_ends(const JointRooms& rooms) {
  ends_.reserve(rooms.facet_count());
  bundles_.resize(rooms.facet_count());
  for (std::size_t f = 0; f < rooms.facet_count(); ++f) {
    ends_.push_back(end_of(rooms, f));
    bundles_[f] = cracks_of(rooms, f);
  }
}

/// Adds facets that have broken since the last time to open_to_gas_, which stays in order.
void JointGas::note_broken(const JointRooms& rooms) {
  const std::size_t known = open_to_gas_.size(), facets = rooms.facet_count();
  for (std::size_t first = 0; first < facets; first += kByteLanes) {
    const std::size_t count = std::min(kByteLanes, facets - first);
    const unsigned intact =
        lanes_equal(load_bytes<kByteLanes>(rooms.states().data() + first, count,
                                           static_cast<std::uint8_t>(FacetState::intact)),
                    static_cast<std::uint8_t>(FacetState::intact));
    const unsigned unknown =
        lanes_equal(load_bytes<kByteLanes>(keeps_.data() + first, count,
                                           static_cast<std::uint8_t>(Keeps::nothing)),
                    static_cast<std::uint8_t>(Keeps::unknown));
    for (unsigned fresh = unknown & ~intact; fresh != 0; fresh &= fresh - 1) {
      const std::size_t f = first + static_cast<std::size_t>(std::countr_zero(fresh));
      keeps_[f] = rooms.keeps_gas(f) ? Keeps::gas : Keeps::nothing;
      if (keeps_[f] == Keeps::gas) open_to_gas_.push_back(static_cast<std::uint32_t>(f));
    }
  }
  std::ranges::inplace_merge(open_to_gas_,
                             open_to_gas_.begin() + static_cast<std::ptrdiff_t>(known));
}

/// Blocks with gas and those beside them.
void JointGas::mark_reached() {
  std::fill(reached_.begin(), reached_.end(), 0);
  for (const std::uint32_t f : open_to_gas_) {
    const End& end = ends_[f];
    if (holds_[end.i] == 0 && (!end.joint || holds_[end.j] == 0)) continue;
    reached_[end.i] = 1;
    if (end.joint) reached_[end.j] = 1;
  }
}

void JointGas::list_cracks(const JointRooms& rooms) {
  if (ends_.empty()) find_ends(rooms);
  note_broken(rooms);
  mark_reached();
  cracks_.clear();
  owed_.clear();
  crack_facets_.clear();
  ending_.clear();
  for (const std::uint32_t f : open_to_gas_) {
    const End& end = ends_[f];
    double& since = left_out_since_[f];
    const bool flowed = since == kFlows;
    if (reached_[end.i] == 0 && (!end.joint || reached_[end.j] == 0)) {
      since = kFlows;
      seen_points_[f] = kUnseen;
      continue;
    }
    if (left_out(end.i) && (!end.joint || left_out(end.j))) {
      if (flowed) since = clock_;
      continue;
    }
    if (end.hole >= 0 || end.surfaces)
      ending_.push_back(static_cast<std::uint32_t>(cracks_.size()));
    cracks_.push_back({end, f});
    owed_.push_back(flowed ? 0.0 : clock_ - since);
    since = kFlows;
    add_facet(crack_facets_, f);
  }
  for (auto* numbers : {&area_, &passage_, &film_}) numbers->resize(cracks_.size());
  listed_ = true;
}

/// What gas pays that has pressed for the step, as the last press() told, while its blocks moved
/// apart by dV [m3]: p dV, which is what they have got, whatever has flowed meanwhile. Of what
/// takes more than a share of its energy it keeps some, as it does not press to the end of such a
/// step.
JointGas::Paid JointGas::paid(const GasContent& gas, double moved) const {
  const double own = (flow_.gamma() - 1.0) * gas.energy / gas.volume;
  const double pressed = gas.pressed > 0.0 ? gas.pressed + p_.ambient : std::min(own, p_.ambient);
  const double full = kPaysInFull * gas.energy, rest = gas.energy - full;
  double work = pressed * moved;
  if (work > full) work = full - rest * std::expm1((full - work) / rest);
  return {work, gas.pressed > 0.0 ? work * p_.ambient / pressed : work};
}

/// The gas of owned blocks follows its joints and pays for what its blocks have moved. Room of
/// closed joints comes and goes without work; where faces that touch give way there is work without
/// room. Below the pressure of the atmosphere gas presses on no block: what it does then the
/// atmosphere gets.
void JointGas::expand() {
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    if (!owned(b) || left_out(b)) continue;
    GasContent& gas = cells_[b].content;
    const double opened = cells_[b].volume - (rooms_[b].broken - gas.broken) - gas.volume;
    const double moved = opened + rooms_[b].gives;
    if (gas.energy > 0.0 && gas.volume > 0.0 && cells_[b].volume > 0.0 && moved != 0.0) {
      const auto [work, on_air] = paid(gas, moved);
      spent_.work += work;
      spent_.swept_volume += moved;
      spent_.air_work += on_air;
      gas.energy -= work;
    }
    gas.volume = cells_[b].volume;
    gas.broken = rooms_[b].broken;
    rooms_[b].gives = 0.0;
  }
}

double JointGas::pressure(const GasCell& cell) const {
  if (!(cell.content.mass > 0.0) || !(cell.volume > 0.0)) return 0.0;
  return (flow_.gamma() - 1.0) * cell.content.energy / cell.volume;
}

double JointGas::work_to_ambient(double pressure, double volume) const {
  if (!(pressure > p_.ambient) || !(p_.ambient > 0.0)) return 0.0;
  const double grows = std::pow(pressure / p_.ambient, 1.0 / flow_.gamma());
  const double work = (pressure - p_.ambient * grows) * volume / (flow_.gamma() - 1.0);
  return work - p_.ambient * (grows - 1.0) * volume;
}

std::span<const double> JointGas::press() {
  refresh();
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    gauge_[b] = std::max(0.0, reservoirs_[b].head.pressure - p_.ambient);
    cells_[b].content.pressed = gauge_[b];
  }
  return gauge_;
}

std::span<double> JointGas::press_as_before() {
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    gauge_[b] = cells_[b].content.pressed;
    cells_[b].volume = cells_[b].content.volume;  // until the next measure()
  }
  return gauge_;
}

void JointGas::refresh() {
  find_pressures();
  const double to_enthalpy = flow_.gamma() / (flow_.gamma() - 1.0);
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    const GasPoint gas{pressure_[b], pressure_[b] > 0.0 ? density_[b] : 0.0};
    reservoirs_[b] = {CrackFlow::head(gas, root_[b]), gas.density / flow_.gamma(),
                      cells_[b].ways > 0.0 ? cells_[b].volume / cells_[b].ways : 0.0,
                      to_enthalpy * pressure_[b] / density_[b]};
  }
}

/// Number by number, so that powers are vectorised.
void JointGas::find_pressures() {
  const CrackFlow flow = flow_;  // which no store can change
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    const GasCell& cell = cells_[b];
    const bool holds = cell.content.mass > 0.0 && cell.volume > 0.0;
    density_[b] = holds ? cell.content.mass / cell.volume : 1.0;
    pressure_[b] = pressure(cell);
  }
  transform_all(pressure_, root_, [flow](double p) { return flow.root_of(p); });
}

GasFlow JointGas::contained() const {
  GasFlow sum;
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    if (owned(b)) sum += {cells_[b].content.mass, cells_[b].content.energy};
  }
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
