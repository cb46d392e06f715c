// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in broken joints; see the header.
#include "gas/joint_gas.h"

#include <algorithm>
#include <cmath>

#include "args/require.h"

namespace muckpile {
namespace {

/// to[k] = of(a[k], b[k]), in a form that the compiler vectorises.
template <class Of>
void transform_all(const std::vector<double>& a, const std::vector<double>& b,
                   std::vector<double>& to, const Of& of) {
  const double *from = a.data(), *and_from = b.data();
  double* const __restrict into = to.data();
  for (std::size_t k = 0, count = to.size(); k < count; ++k) into[k] = of(from[k], and_from[k]);
}

}  // namespace

JointGas::JointGas(const Parameters& parameters)
    : p_(parameters), flow_(parameters.flow), outside_(flow_.head({parameters.ambient, 0.0})) {
  require_positive("residual_aperture", "m", p_.residual_aperture);
  require_not_negative("ambient_pressure", "Pa", p_.ambient);
}

void JointGas::set_network(const FacetNetwork& network) {
  const std::size_t count = network.blocks().size();
  cells_.assign(count, {});
  reached_.assign(count, 0);
  holds_.assign(count, 0);
  changes_.assign(count, {});
  reservoirs_.assign(count, {});
  for (auto* numbers : {&density_, &entropy_per_mass_, &pressure_, &root_, &gauge_})
    numbers->assign(count, 0.0);
  cracks_.clear();
  crack_facets_.clear();
  ending_.clear();
  wide_.clear();
  ends_.clear();
  keeps_.assign(network.facet_count(), Keeps::unknown);
  listed_ = false;
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

JointGas::End JointGas::end_of(const FacetNetwork& network, std::size_t f) const {
  const FacetEnds facet = network.ends(f);
  const auto i = static_cast<std::size_t>(facet.i), j = static_cast<std::size_t>(facet.j);
  const bool joint = facet.kind == FacetKind::joint;
  const int hole_i = touches_[i] / 2 - 1, hole_j = touches_[j] / 2 - 1;
  return {.i = static_cast<std::uint32_t>(i),
          .j = static_cast<std::uint32_t>(j),
          .hole = joint && hole_i == hole_j ? hole_i : -1,
          .joint = joint,
          .surfaces = joint && (touches_[i] & touches_[j] & 1) != 0};
}

/// Whether cracks_ is still right. A list depends on which facets are broken, and on which blocks
/// have gas, or are copies, which may have got gas on their own rank, or lie on a chamber.
bool JointGas::list_holds(const FacetNetwork& network, const std::vector<char>& fed) {
  const auto intact = static_cast<std::size_t>(
      std::count(network.states().begin(), network.states().end(), FacetState::intact));
  bool same = listed_ && intact == intact_ && fed == fed_;
  for (std::size_t b = 0; b < cells_.size(); ++b) {
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

/// Blocks with gas and those beside them.
void JointGas::mark_reached(const FacetNetwork& network) {
  open_to_gas_.clear();
  for (std::size_t f = 0; f < network.facet_count(); ++f) {
    if (network.states()[f] == FacetState::intact) continue;
    if (keeps_[f] == Keeps::unknown)
      keeps_[f] = network.traces()[f].gas ? Keeps::gas : Keeps::nothing;
    if (keeps_[f] == Keeps::gas) open_to_gas_.push_back(static_cast<std::uint32_t>(f));
  }
  std::fill(reached_.begin(), reached_.end(), 0);
  for (const std::uint32_t f : open_to_gas_) {
    const End& end = ends_[f];
    if (holds_[end.i] == 0 && (!end.joint || holds_[end.j] == 0)) continue;
    reached_[end.i] = 1;
    if (end.joint) reached_[end.j] = 1;
  }
}

void JointGas::list_cracks(const FacetNetwork& network) {
  if (ends_.empty()) {
    ends_.reserve(network.facet_count());
    for (std::size_t f = 0; f < network.facet_count(); ++f) ends_.push_back(end_of(network, f));
  }
  mark_reached(network);
  cracks_.clear();
  crack_facets_.clear();
  ending_.clear();
  for (const std::uint32_t f : open_to_gas_) {
    const End& end = ends_[f];
    if (reached_[end.i] == 0 && (!end.joint || reached_[end.j] == 0)) continue;
    if (end.hole >= 0 || end.surfaces)
      ending_.push_back(static_cast<std::uint32_t>(cracks_.size()));
    cracks_.push_back({end, f, -1.0, 0.0, 0.0, 0.0});
    add_facet(crack_facets_, f);
  }
  aperture_.resize(cracks_.size());
  width_.resize(cracks_.size());
  passage_.resize(cracks_.size());
  listed_ = true;
}

void JointGas::measure_crack(std::size_t c, const OpenJoint& open) {
  Crack& crack = cracks_[c];
  const double smooth = p_.residual_aperture + open.opening;
  const JointApertures apertures = open.by_law.value_or(JointApertures{smooth, smooth});
  aperture_[c] = apertures.hydraulic;
  if (open.area != crack.broken) {  // another point has broken
    crack.broken = open.area;
    width_[c] = 2.0 * std::sqrt(open.area / M_PI);
  }
  crack.area = aperture_[c] * width_[c];
  crack.volume = (crack.joint ? 0.5 : 1.0) * open.area * apertures.mechanical;
  if (open.wide) wide_.push_back(static_cast<std::uint32_t>(c));
}

/// To the volumes and ways of its blocks, and to the ways out of its hole.
void JointGas::count_crack(const Crack& crack) {
  const double ways = (crack.joint ? crack.way : 0.0) + (crack.hole >= 0 ? crack.end() : 0.0) +
                      (crack.surfaces ? crack.end() : 0.0);
  each_block(crack, [&](std::size_t b) {
    cells_[b].volume += crack.volume;
    cells_[b].ways += ways;
    if (crack.hole >= 0 && owned(b))
      chamber_ways_[static_cast<std::size_t>(crack.hole)] += crack.end();
  });
}

void JointGas::measure(const FacetNetwork& network, const std::vector<char>& fed) {
  if (!list_holds(network, fed)) list_cracks(network);
  wide_.clear();
  network.open_joints(crack_facets_, openings_);
  for (std::size_t c = 0; c < cracks_.size(); ++c) measure_crack(c, openings_[c]);
  transform_all(aperture_, width_, passage_,
                [flow = flow_](double w, double length) { return flow.passage(w, length); });
  for (GasCell& cell : cells_) cell.volume = cell.ways = 0.0;
  chamber_ways_.assign(fed.size(), 0.0);
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    cracks_[c].way = cracks_[c].area * passage_[c];
    count_crack(cracks_[c]);
  }
}

double JointGas::pressure(const GasCell& cell) const {
  if (!(cell.content.mass > 0.0) || !(cell.volume > 0.0)) return 0.0;
  return cell.content.entropy / cell.content.mass *
         power_of(cell.content.mass / cell.volume, flow_.gamma());
}

std::span<const double> JointGas::press() {
  refresh();
  for (std::size_t b = 0; b < cells_.size(); ++b)
    gauge_[b] = std::max(0.0, reservoirs_[b].head.pressure - p_.ambient);
  return gauge_;
}

void JointGas::refresh() {
  find_pressures();
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    const GasPoint gas{pressure_[b], pressure_[b] > 0.0 ? density_[b] : 0.0};
    reservoirs_[b] = {CrackFlow::head(gas, root_[b]), gas.density,
                      cells_[b].ways > 0.0 ? cells_[b].volume / cells_[b].ways : 0.0,
                      entropy_per_mass_[b]};
  }
}

/// Number by number, so that powers are vectorised.
void JointGas::find_pressures() {
  const CrackFlow flow = flow_;  // which no store can change
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    const GasCell& cell = cells_[b];
    const bool holds = cell.content.mass > 0.0 && cell.volume > 0.0;
    density_[b] = holds ? cell.content.mass / cell.volume : 1.0;
    entropy_per_mass_[b] = holds ? cell.content.entropy / cell.content.mass : 0.0;
  }
  transform_all(density_, entropy_per_mass_, pressure_,
                [flow](double rho, double k) { return k * power_of(rho, flow.gamma()); });
  transform_all(pressure_, density_, root_, [flow](double p, double) { return flow.root_of(p); });
}

void JointGas::exchange(std::size_t c, double dt) {
  const Crack& crack = cracks_[c];
  std::size_t from = crack.i, to = crack.j;
  if (reservoirs_[to].head.pressure > reservoirs_[from].head.pressure) std::swap(from, to);
  const Reservoir &donor = reservoirs_[from], &taker = reservoirs_[to];
  if (!(donor.head.pressure > taker.head.pressure)) return;
  const double flux = flow_.flux(donor.head, taker.head, passage_[c]);
  const double thinning = CrackFlow::thinning(donor.head, taker.head);
  const double most = crack.way * equalising_mass(donor.density, donor.room, thinning, taker.room);
  const double mass = std::min(flux * crack.area * dt, most);
  move(from, -mass, donor.entropy_per_mass);
  move(to, mass, donor.entropy_per_mass);
}

JointGas::Reservoir JointGas::inlet_of(const GasChamber& chamber) const {
  if (!(chamber.gas.pressure > 0.0)) return {};
  return {flow_.head(chamber.gas), chamber.gas.density,
          chamber.mass / chamber.gas.density / chamber.ways,
          chamber.gas.pressure / std::pow(chamber.gas.density, flow_.gamma())};
}

/// From the chamber into block b, or back; returns the mass.
double JointGas::feed(std::size_t b, std::size_t c, const Reservoir& inlet, double dt) {
  const Reservoir& gas = reservoirs_[b];
  if (!(inlet.head.pressure > 0.0) || !(gas.room > 0.0)) return 0.0;
  const bool in = inlet.head.pressure > gas.head.pressure;
  const GasHead &up = in ? inlet.head : gas.head, &down = in ? gas.head : inlet.head;
  const double most =
      cracks_[c].end() * equalising_mass(in ? inlet.density : gas.density, inlet.room,
                                         CrackFlow::thinning(up, down), gas.room);
  const double mass =
      std::min(flow_.flux(up, down, passage_[c]) * 0.5 * cracks_[c].area * dt, most);
  move(b, in ? mass : -mass, in ? inlet.entropy_per_mass : gas.entropy_per_mass);
  return in ? mass : -mass;
}

/// From block b into the atmosphere; returns the mass.
double JointGas::vent(std::size_t b, std::size_t c, double dt) {
  const Reservoir& gas = reservoirs_[b];
  if (!(gas.head.pressure > p_.ambient)) return 0.0;
  const double most =
      cracks_[c].end() * gas.density * gas.room * (1.0 - CrackFlow::thinning(gas.head, outside_));
  const double mass =
      std::min(flow_.flux(gas.head, outside_, passage_[c]) * 0.5 * cracks_[c].area * dt, most);
  move(b, -mass, gas.entropy_per_mass);
  return mass;
}

JointGas::Flows JointGas::flow(std::span<const GasChamber> chambers, double dt) {
  Flows flows{std::vector<double>(chambers.size(), 0.0), 0.0};
  std::fill(changes_.begin(), changes_.end(), Change{});
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    if (cracks_[c].joint) exchange(c, dt);
  }
  std::vector<Reservoir> inlets;
  for (const GasChamber& chamber : chambers) inlets.push_back(inlet_of(chamber));
  for (const std::uint32_t c : ending_) {
    const Crack& crack = cracks_[c];
    each_block(crack, [&](std::size_t b) {
      if (!owned(b)) return;
      if (crack.hole >= 0) {
        const auto hole = static_cast<std::size_t>(crack.hole);
        flows.from_hole[hole] += feed(b, c, inlets[hole], dt);
      }
      if (crack.surfaces) flows.vented += vent(b, c, dt);
    });
  }
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    if (!owned(b)) continue;
    cells_[b].content.mass += changes_[b].mass;
    cells_[b].content.entropy += changes_[b].entropy;
  }
  return flows;
}

JointGas::Opened JointGas::open_wide() {
  Opened opened;
  if (wide_.empty()) return opened;
  std::vector<double> lost_volume(cells_.size(), 0.0);
  for (const std::uint32_t c : wide_) {
    opened.joints.push_back(cracks_[c].facet);
    keeps_[cracks_[c].facet] = Keeps::nothing;
    listed_ = false;
    each_block(cracks_[c], [&](std::size_t b) { lost_volume[b] += cracks_[c].volume; });
  }
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    if (!owned(b) || lost_volume[b] == 0.0) continue;
    GasContent& content = cells_[b].content;
    const double kept = std::max(0.0, 1.0 - lost_volume[b] / cells_[b].volume);
    // The last joint takes all: no rounding is left behind.
    const GasContent rest =
        kept < 1e-12 ? GasContent{} : GasContent{kept * content.mass, kept * content.entropy};
    opened.vented += content.mass - rest.mass;
    content = rest;
  }
  return opened;
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
