// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network as a whole: set-up, dilatations and bulk stresses, sums over it.
// Scope: see the header; intact facets are in facet_groups.cpp, bonded and breaking ones in
// facet_bond.cpp, broken ones in facet_contact.cpp and facet_contact_groups.cpp, what they still
// hold in facet_softening.cpp, pressure in facet_load.cpp, gas in facet_gas.cpp, yielding supports
// in quiet_ground.cpp.
#include "bond/network/facet_network.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "bond/network/facet_lanes.h"

namespace muckpile {
namespace {

constexpr std::size_t kAhead = 32 / kGroup;  // groups fetched ahead of the one at work

/// m of block i. A block may slide along a mirror, and the ground of a fixed support may yield.
Vec3 opening_of(const Facet& facet) {
  if (facet.kind == FacetKind::joint) return facet.opening_i;
  if (facet.kind == FacetKind::fixed) return facet.normal;
  const Vec3 part = facet.normal.dot(facet.opening_i) * facet.normal;
  // What is that part already stays as it was rounded.
  constexpr double kRounded = 1e-6;
  const bool is_part = (facet.opening_i - part).norm() <= kRounded * part.norm();
  return is_part ? facet.opening_i : part;
}

std::uint8_t bonded_points(const FacetTraces& memory) {
  return static_cast<std::uint8_t>(kFacetPoints - memory.contact().count());
}

}  // namespace

FacetNetwork::FacetNetwork(const JointMaterial& material, const std::vector<JointClass>& natural)
    : materials_{material} {
  for (const JointClass& joint : natural) materials_.push_back(material.with_joints(joint));
  derive();
}

void FacetNetwork::set_blocks(std::vector<BlockConstants> blocks) {
  blocks_ = std::move(blocks);
  blocks_.reserve(blocks_.size() + 1);
  blocks_.push_back({kGroundTag, false, 1.0, 1.0, {}});
  state_.assign(blocks_.size(), {Mat3::Identity(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  sums_.assign(blocks_.size(), {});
  theta_.assign(blocks_.size(), 0.0);
  bulk_stress_.assign(blocks_.size(), 0.0);
  force_.assign(blocks_.size(), Vec3::Zero());
  torque_.assign(blocks_.size(), Vec3::Zero());
  gas_pressure_.clear();
  rests_.assign(blocks_.size(), 0);
}

void FacetNetwork::set_facets(std::vector<Facet> facets, std::vector<FacetMemory> memory) {
  const std::size_t count = facets.size();
  facets_.resize(count);
  FacetGroup empty;
  empty.normal[0].fill(1.0f);  // lanes without a facet are worked on as well
  groups_.assign((count + kGroup - 1) / kGroup, empty);
  traces_.assign(count, {});
  contacts_.reset(groups_.size());
  rare_.reset(count);
  states_.resize(count);
  bonded_points_.resize(count);
  memory.resize(count);
  for (std::size_t f = 0; f < count; ++f) {
    place_memory(f, memory[f]);
    place_facet(f, facets[f]);
    derive_facet(f);
  }
  derive_slants();
  list_anew();
}

void FacetNetwork::derive_anew() {
  derive();
  list_anew();
}

void FacetNetwork::list_anew() {
  asleep_.assign(facets_.size(), 0);
  calls_ = 0;
  list_active();
  list_yielding();
  count_unbonded();
  count_slants();
}

void FacetNetwork::set_faces(std::vector<BoundaryFace> faces) {
  faces_ = std::move(faces);
  faces_.shrink_to_fit();
  count_unbonded();
  list_wall();
}

void FacetNetwork::give_up(std::vector<Facet>& facets, std::vector<FacetMemory>& memory,
                           std::vector<BoundaryFace>& faces) {
  facets = this->facets();
  memory = this->memory();
  faces = std::move(faces_);
  const auto release = [](auto&... table) { ((table = std::decay_t<decltype(table)>()), ...); };
  release(facets_, traces_, contacts_, rare_, groups_, states_, bonded_points_, bonded_, active_,
          working_, asleep_, yielding_, faces_, wall_, walls_, backs_, slants_, slant_traction_,
          block_slants_, gradients_, slant_stresses_);
}

std::size_t FacetList::size() const { return network_->facet_count(); }
Facet FacetList::operator[](std::size_t f) const { return network_->facet(f); }
Facet FacetList::Iterator::operator*() const { return network_->facet(f_); }

Facet FacetNetwork::facet(std::size_t f) const {
  const FacetName& name = facets_[f];
  const FacetGroup& group = group_of(f);
  const std::size_t k = lane_of(f);
  Facet facet;
  facet.i = group.i[k];
  facet.j = group.j[k];
  facet.tag_i = blocks_[static_cast<std::size_t>(facet.i)].tag;
  facet.tag_j = blocks_[static_cast<std::size_t>(facet.j)].tag;
  facet.face = name.face;
  facet.kind = name.kind;
  facet.joint_class = name.joint_class;
  facet.normal = at_lane(group.normal, k);
  facet.arm_i = at_lane(group.arm, k);
  const GroundMemory& ground = ground_memory(f);
  facet.arm_j = ground.placed ? ground.arm_j : at_lane(group.arm_j, k);
  facet.opening_i = at_lane(group.opening_i, k);
  facet.opening_j = at_lane(group.opening_j, k);
  facet.half_axes = {at_lane(group.half_1, k), at_lane(group.half_2, k)};
  facet.area = group.area[k];
  facet.sharpened = name.sharpened;
  facet.slanted = name.slanted();
  facet.weight = facets_[f].weight;
  return facet;
}

void FacetNetwork::derive() {
  held_known_ = false;
  const JointParameters& parameters = material().parameters();
  softens_ = parameters.fracture_energy_tension > 0.0 || parameters.fracture_energy_shear > 0.0;
  depends_on_rate_ = parameters.rate_exponent > 0.0;
  strengths_.clear();
  for (const JointMaterial& joint : materials_)
    strengths_.push_back(
        {{joint.parameters().tension, joint.parameters().cohesion, joint.tan_friction()},
         joint.tan_residual_friction()});
  damping_ = material().damping_coefficient();
  contact_damping_ = material().contact_damping_coefficient();
  shear_over_p_wave_ = 2.0 * material().shear_modulus() / material().p_wave_modulus();
  slip_weakening_ = {parameters.weakening_speed, std::tan(parameters.weakened_friction_angle)};
  for (std::size_t f = 0; f < facets_.size(); ++f) derive_facet(f);
}

/// Into the tables, rounded once and for all: what is derived of it is derived of the rounded
/// values, so that it is the same after a restart or a change of ranks.
void FacetNetwork::place_facet(std::size_t f, const Facet& facet) {
  FacetName& name = facets_[f];
  name.weight = static_cast<float>(facet.weight);
  name.face = static_cast<std::uint16_t>(facet.face);
  name.joint_class = facet.joint_class;
  name.kind = facet.kind;
  name.sharpened = facet.sharpened;
  name.slanted_i = facet.slanted[0];
  name.slanted_j = facet.slanted[1];
  FacetGroup& group = group_of(f);
  const std::size_t lane = lane_of(f);
  group.i[lane] = facet.i;
  group.j[lane] = facet.j;
  group.area[lane] = facet.area;
  set_lane(group.arm, lane, facet.arm_i);
  set_lane(group.half_1, lane, facet.half_axes[0]);
  set_lane(group.half_2, lane, facet.half_axes[1]);
  set_lane(group.normal, lane, facet.normal);
  set_lane(group.opening_i, lane, opening_of(facet));
  set_lane(group.opening_j, lane,
           facet.kind == FacetKind::joint ? facet.opening_j : Vec3(Vec3::Zero()));
  const Vec3 rounded = at_lane(group.arm, lane) - facet.arm_i;  // the same place from j
  const Vec3 arm_j = facet.arm_j + rounded;
  set_lane(group.arm_j, lane, arm_j + ground_memory(f).displacement);
  if (facet.kind != FacetKind::joint && rare_.exists(f)) rare_.made(f).ground.place(arm_j);
}

void FacetNetwork::place_memory(std::size_t f, const FacetMemory& memory) {
  traces_[f] = memory;
  states_[f] = memory.state;
  bonded_points_[f] = bonded_points(memory);
  if (memory.contact.exists()) contacts_.set(f, memory.contact.get());
  if (memory.rare.exists()) rare_.made(f) = memory.rare.get();
}

FacetMemory FacetNetwork::memory(std::size_t f) const {
  FacetMemory memory{traces_[f], {}, {}};
  if (contacts_.exists(f)) memory.contact.made() = contacts_.get(f);
  if (rare_.exists(f)) memory.rare.made() = rare_.get(f);
  return memory;
}

std::vector<FacetMemory> FacetNetwork::memory() const {
  std::vector<FacetMemory> all;
  all.reserve(facets_.size());
  for (std::size_t f = 0; f < facets_.size(); ++f) all.push_back(memory(f));
  return all;
}

void FacetNetwork::derive_facet(std::size_t f) {
  const Facet facet = this->facet(f);
  const bool grounded = facet.kind != FacetKind::joint, smooth = facet.kind == FacetKind::mirror;
  const double depth_i = facet.normal.dot(facet.arm_i);
  const double depth_j = grounded ? 0.0 : -facet.normal.dot(facet.arm_j);
  const JointMaterial& joint = materials_.at(facet.joint_class);
  const FacetStiffness k = joint.facet_stiffness(depth_i + depth_j);
  const double shear = smooth ? 0.0 : k.shear, point_area = facet.area / kFacetPoints;
  const double d =
      kSharpening * (2.0 * material().lame_lambda() + material().shear_modulus()) / 6.0;  // [Pa]
  const double stiffness = facet.sharpened ? d * k.rock_share * (depth_i + depth_j) : 0.0;

  FacetGroup& group = group_of(f);
  const std::size_t lane = lane_of(f);
  group.sharpening[lane] = stiffness * point_area * bonded_points_[f];
  group.shear[lane] = shear;
  group.normal_extra[lane] = k.normal - shear;
  group.bulk[lane] = (grounded ? 1.0 : 0.5) * k.rock_share;
}

/// Distances of the facet from the two centres [m].
std::pair<double, double> FacetNetwork::depths(std::size_t f) const {
  const Vec3 normal = at_lane(group_of(f).normal, lane_of(f));
  const bool grounded = facets_[f].kind != FacetKind::joint;
  return {normal.dot(at_lane(group_of(f).arm, lane_of(f))),
          grounded ? 0.0 : -normal.dot(arm_j_of(f))};
}

void FacetNetwork::list_active() {
  for (auto* sets : {&active_, &bonded_, &working_}) {
    sets->clear();
    sets->reserve(groups_.size());
  }
  active_count_ = 0;
  for (std::size_t f = 0; f < states_.size(); ++f) {
    if (!traces_[f].over()) {
      add_facet(active_, f);
      ++active_count_;
    }
    if (bonded_points_[f] > 0) add_facet(bonded_, f);
  }
  changed_since_ = 0;
  list_working();
}

void FacetNetwork::list_working() {
  working_.clear();
  each_facet(active_, [&](std::size_t f) {
    const auto i = static_cast<std::size_t>(i_of(f)), j = static_cast<std::size_t>(j_of(f));
    if (rests_[i] == 0 || rests_[j] == 0) add_facet(working_, f);
  });
  list_stirred();
}

/// Blocks at rest stay where they are, and what their facets add to their dilatations stays too.
/// Slanted facets are not told apart; all is worked out while ground yields, too.
void FacetNetwork::list_stirred() {
  held_known_ = false;
  any_rests_ = !slanted() && !rests_.empty() && std::count(rests_.begin(), rests_.end() - 1, 1) > 0;
  if (!any_rests_) return;
  stirred_.assign(blocks_.size(), 0);
  opening_.clear();
  coupled_.clear();
  each_facet(bonded_, [&](std::size_t f) {
    const auto i = static_cast<std::size_t>(i_of(f)), j = static_cast<std::size_t>(j_of(f));
    if (rests_[i] != 0 && rests_[j] != 0) return;
    add_facet(opening_, f);
    stirred_[i] = stirred_[j] = 1;
  });
  for (const BoundaryFace& face : faces_)
    if (face.hole >= 0) stirred_[static_cast<std::size_t>(face.block)] = 1;
  stirred_.back() = 0;  // the ground
  each_facet(bonded_, [&](std::size_t f) {
    const auto i = static_cast<std::size_t>(i_of(f)), j = static_cast<std::size_t>(j_of(f));
    if (stirred_[i] != 0 || stirred_[j] != 0) add_facet(coupled_, f);
  });
}

void FacetNetwork::wake_all() {
  rests_.assign(blocks_.size(), 0);
  list_working();
}

void FacetNetwork::mark_joined(std::span<const int> moves, std::span<int> disturbed) const {
  each_facet(active_, [&](std::size_t f) {
    if (states_[f] == FacetState::retired) return;
    const auto i = static_cast<std::size_t>(i_of(f)), j = static_cast<std::size_t>(j_of(f));
    if (moves[i] != 0) disturbed[j] = 1;
    if (moves[j] != 0) disturbed[i] = 1;
  });
  for (std::size_t f : yielding_) disturbed[static_cast<std::size_t>(i_of(f))] = 1;
}

void FacetNetwork::mark_held(std::span<char> held) const {
  const auto mark = [&](int block) {
    const auto b = static_cast<std::size_t>(block);
    if (b < held.size()) held[b] = 1;
  };
  each_facet(active_, [&](std::size_t f) {
    if (states_[f] == FacetState::retired) return;
    mark(i_of(f));
    mark(j_of(f));
  });
}

void FacetNetwork::let_rest(std::span<const int> rests) {
  for (std::size_t b = 0; b < rests_.size(); ++b) rests_[b] = rests[b] != 0 ? 1 : 0;
  list_working();
}

void FacetNetwork::count_unbonded() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) sums_[b].unbonded = blocks_[b].retired.unbonded;
  for (const BoundaryFace& face : faces_) {
    const auto b = static_cast<std::size_t>(face.block);
    sums_[b].unbonded += face.area * face.normal.dot(face.arm) / blocks_[b].volume;
  }
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const auto i = static_cast<std::size_t>(i_of(f)), j = static_cast<std::size_t>(j_of(f));
    const auto [depth_i, depth_j] = depths(f);
    for (std::size_t p = 0; p < kFacetPoints; ++p) {
      if (!traces_[f].is_contact(p)) continue;
      sums_[i].unbonded += area(f) / kFacetPoints * depth_i / blocks_[i].volume;
      sums_[j].unbonded += area(f) / kFacetPoints * depth_j / blocks_[j].volume;
    }
  }
}

void FacetNetwork::dilatation(double dt) {
  if (4 * changed_since_ > active_count_) list_active();
  std::erase_if(yielding_, [&](std::size_t f) { return states_[f] != FacetState::intact; });
  const bool some = leaves_resting();
  if (some && !held_known_) open_resting();
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    sums_[b].bonded = some ? held_[b] : 0.0;
    sums_[b].loaded = 0.0;
  }
  squeezed_ = 0.0;
  for (const LaneSet& set : some ? opening_ : bonded_) open_group(set);
  if (slanted()) stretch_slanted();
  const double two_g = 2.0 * material().shear_modulus();
  for (const BoundaryFace& face : faces_) {
    if (face.pressure == 0.0) continue;
    const auto b = static_cast<std::size_t>(face.block);
    const double squeezed = face.area * face.pressure * face.normal.dot(face.arm) / two_g;
    sums_[b].loaded -= squeezed;
    if (blocks_[b].owned) squeezed_ += 0.5 * squeezed * face.pressure;
  }
  if (!yielding_.empty()) yield_ground(dt);
  for (std::size_t b = 0; b < blocks_.size(); ++b) theta_[b] = theta_of(b);
  theta_.back() = 0.0;  // the ground
}

/// The parts of facets of which both blocks rest.
void FacetNetwork::open_resting() {
  for (BlockSums& sums : sums_) sums.bonded = 0.0;
  auto moves = opening_.begin();
  for (LaneSet set : bonded_) {
    while (moves != opening_.end() && moves->group < set.group) ++moves;
    if (moves != opening_.end() && moves->group == set.group) set.lanes &= ~moves->lanes;
    if (set.lanes != 0) open_group(set);
  }
  held_.resize(sums_.size());
  for (std::size_t b = 0; b < sums_.size(); ++b) held_[b] = sums_[b].bonded;
}

/// s of the header.
double FacetNetwork::stiffening(const BlockSums& sums) const {
  return 1.0 + sums.unbonded * material().lame_lambda() / (2.0 * material().shear_modulus());
}

double FacetNetwork::theta_of(std::size_t b) const {
  return (sums_[b].bonded + sums_[b].loaded) / (blocks_[b].volume * stiffening(sums_[b]));
}

void FacetNetwork::bulk_stresses() {
  const bool all = !leaves_resting() || !held_known_;
  held_known_ = leaves_resting();
  for (BlockSums& sums : sums_) sums.uneven = 0.0;
  for (const LaneSet& set : all ? bonded_ : coupled_) {
    const FacetGroup& group = groups_[set.group];
    if (set.group + kAhead < groups_.size()) groups_[set.group + kAhead].fetch_couplings();
    for (std::size_t k = 0; k < kGroup; ++k) {  // nothing of those that are not bonded
      const auto i = static_cast<std::size_t>(group.i[k]), j = static_cast<std::size_t>(group.j[k]);
      const double part = group.sharpening[k] * (theta_[i] - theta_[j]);
      sums_[i].uneven += part;
      sums_[j].uneven -= part;
    }
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!all && stirred_[b] == 0) continue;  // nobody asks for it
    bulk_stress_[b] = material().lame_lambda() * theta_[b] +
                      sums_[b].uneven / (blocks_[b].volume * stiffening(sums_[b]));
  }
  bulk_stress_.back() = 0.0;  // the ground
}

/// Energy of a block's dilatation less the potential of the pressures on its faces [J].
double FacetNetwork::block_potential(std::size_t b, const BlockSums& sums) const {
  const double opened = sums.bonded + sums.loaded;
  return 0.5 * material().lame_lambda() * opened * opened / (blocks_[b].volume * stiffening(sums));
}

/// But for squeezed_.
double FacetNetwork::block_energy(std::size_t b) const {
  const BlockSums& sums = sums_[b];
  return block_potential(b, sums) - bulk_stress_[b] * sums.loaded + slant_energy(b);
}

/// Of the joint, of its closed broken points and of the uneven dilatation on its sides [J].
double FacetNetwork::facet_energy(std::size_t f) const {
  const Motion motion = motion_of(f);
  const LaneVec jumps = elastic_jump(f, motion);
  const Bond bond = bond_of(f);
  const Coupling coupling = coupling_of(f);
  const double uneven =
      theta_[static_cast<std::size_t>(coupling.i)] - theta_[static_cast<std::size_t>(coupling.j)];
  double stored = 0.0;
  for (int p = 0; p < kFacetPoints; ++p) {
    if (traces_[f].is_contact(static_cast<std::size_t>(p))) continue;
    const Vec3 jump = jumps.at(p);
    const double normal = motion.normal.dot(jump);
    stored += bond.twice_energy(jump.squaredNorm(), normal);
  }
  return 0.5 * (bond.point_area * stored + coupling.sharpening * uneven * uneven) +
         contact_energy(f, motion) + (softens_ ? cohesion_energy(f, motion) : 0.0);
}

double FacetNetwork::elastic_energy() const {
  double energy = squeezed_;
  each_facet(active_, [&](std::size_t f) {
    if (states_[f] != FacetState::retired && !traces_[f].open)
      energy += facets_[f].weight * facet_energy(f);
  });
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].owned) energy += block_energy(b);
  }
  return energy;
}

double FacetNetwork::broken_count() const {
  double count = 0.0;
  for (const BlockConstants& block : blocks_) {
    if (block.owned) count += 0.5 * block.retired.count;  // each of the two blocks remembers it
  }
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (facets_[f].kind == FacetKind::joint && states_[f] != FacetState::intact)
      count += facets_[f].weight;
  }
  return count;
}

double FacetNetwork::broken_area(bool all) const {
  double sum = 0.0;
  for (const BlockConstants& block : blocks_) {
    if (block.owned) sum += 0.5 * block.retired.area;
  }
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (facets_[f].kind != FacetKind::joint) continue;
    const double share = all ? 1.0 : traces_[f].broken.count() / double{kFacetPoints};
    sum += share * facets_[f].weight * area(f);
  }
  return sum;
}

void FacetNetwork::soften(double factor, std::optional<double> damping) {
  stop_ground();  // what is behind is not softened, and no wave is left to let out
  losses_.fracture += (1.0 - factor) * elastic_energy();
  rare_.each([&](RareMemory& memory) {
    for (Cohesion& cohesion : memory.cohesion) cohesion.strength *= factor;
  });
  for (JointMaterial& material : materials_) material = material.softened(factor, damping);
  softened_ *= factor;
  softer_since_ = true;
  if (damping) damping_given_ = damping;
  derive();
}

void FacetNetwork::resume(const NetworkTotals& totals) {
  losses_ = totals.losses;
  pressure_work_ = totals.pressure_work;
  wave_work_ = totals.wave_work;
  softened_ = totals.softened;
  damping_given_ = totals.damping;
  quiet_ground_ = totals.quiet_ground;
  moved_unseen_ = totals.moved_unseen;
  softer_since_ = totals.softer_since;
  if (softened_ == 1.0 && !totals.damping) return;
  for (JointMaterial& material : materials_)
    material = material.softened(softened_, totals.damping);
  derive();
}

std::vector<FacetNetwork::TableSize> FacetNetwork::table_sizes() const {
  const auto bytes = [](const auto&... table) {
    return (static_cast<double>(table.capacity() * sizeof(table[0])) + ...);
  };
  return {{"facet_groups", bytes(groups_)},
          {"facet_names", bytes(facets_)},
          {"facet_traces", bytes(traces_, states_, bonded_points_)},
          {"facet_sleep", bytes(asleep_)},
          {"facet_lists", bytes(bonded_, active_, working_, opening_, coupled_, yielding_)},
          {"contact", contacts_.memory_usage()},
          {"softening_and_ground", rare_.memory_usage()},
          {"slant", bytes(slants_, slant_traction_, block_slants_, gradients_, slant_stresses_)},
          {"block_constants", bytes(blocks_)},
          {"block_states", bytes(state_)},
          {"block_sums", bytes(sums_, theta_, bulk_stress_, dropped_)},
          {"block_forces", bytes(force_, torque_)},
          {"block_rest", bytes(rests_, stirred_, held_)},
          {"gas", bytes(gas_pressure_, gas_force_, gas_torque_)},
          {"faces", bytes(faces_)},
          {"walls", bytes(wall_, walls_, backs_)}};
}

double FacetNetwork::memory_usage() const {
  double bytes = 0.0;
  for (const TableSize& size : table_sizes()) bytes += size.bytes;
  return bytes;
}

}  // namespace muckpile
