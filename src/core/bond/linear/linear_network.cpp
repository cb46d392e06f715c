// SPDX-License-Identifier: GPL-2.0-or-later
// Stiffness of the facet network about its present pose.
// Scope: see the header.
#include "bond/linear/linear_network.h"

#include <algorithm>

#include "bond/network/facet_kinematics.h"
#include "bond/network/joint_points.h"

namespace muckpile {
namespace {

using Six = Eigen::Matrix<double, 6, 1>;

Six of_block(std::span<const double> values, int block) {
  return Eigen::Map<const Six>(values.data() + 6 * static_cast<std::size_t>(block));
}

/// Displacement of a point at `arm` from the centre.
Vec3 moved(const Six& motion, const Vec3& arm) {
  return motion.head<3>() + Vec3(motion.tail<3>()).cross(arm);
}

}  // namespace

LinearNetwork::LinearNetwork(const FacetNetwork& network, BreakView view, double damping_rate) {
  each_facet(network.schedule().active(), [&](std::size_t f) {
    if (network.history().state(f) == FacetState::retired) return;
    add_spring(network, f, view, damping_rate);
  });
  set_blocks(network, view);
}

void LinearNetwork::add_spring(const FacetNetwork& network, std::size_t f, BreakView view,
                               double damping_rate) {
  const FacetKinematics facets = network.kinematics();
  const FacetMotion motion = facets.motion(f);
  const BondConstants bond = facets.tables.bond(f);
  const FacetEnds ends = network.ends(f);
  const FacetOpenings openings = facets.openings(f, motion.scale);
  Spring spring{};
  spring.i = ends.i;
  spring.j = ends.j == network.ground() ? -1 : ends.j;
  spring.normal = motion.normal;
  spring.on_i = {openings.i, Vec3::Zero()};
  spring.on_j = {openings.j, Vec3::Zero()};
  spring.pull_i = bond.point_area * bond.bulk_i;
  spring.pull_j = bond.point_area * bond.bulk_j;
  spring.strain_i = bond.area_i / kFacetPoints;
  spring.strain_j = bond.area_j / kFacetPoints;
  if (view == BreakView::as_it_is) spring.sharpening = facets.tables.coupling(f).sharpening;
  spring.slanted = facets.tables.name(f).slanted();
  if (const LeaningFaces* leaning = network.leaning()) {
    const FacetLean& lean = leaning->facet(f);
    spring.shear_share = lean.shear_share;
    spring.on_i.lean = facets.turned(f, lean.lean[0], motion.scale);
    spring.on_j.lean = facets.turned(f, lean.lean[1], motion.scale);
  }
  set_points(spring, network, f, view, damping_rate);
  springs_.push_back(spring);
}

/// Where the points are and what they carry.
void LinearNetwork::set_points(Spring& spring, const FacetNetwork& network, std::size_t f,
                               BreakView view, double damping_rate) {
  const FacetKinematics facets = network.kinematics();
  const FacetMotion motion = facets.motion(f);
  const LaneVec jump = motion.jump(), side = motion.side();
  const BondConstants bond = facets.tables.bond(f);
  const FacetTraces& traces = facets.history.traces(f);
  const FacetEnds ends = network.ends(f);
  const Vec3 between =
      facets.blocks.state_of(ends.i).centre - facets.blocks.state_of(ends.j).centre;
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    spring.arm_i[p] = side.at(static_cast<int>(p)) + 0.5 * jump.at(static_cast<int>(p));
    spring.arm_j[p] = spring.arm_i[p] + between;
    const bool bonded = view == BreakView::as_it_is && !traces.is_contact(p);
    const bool rubs = bonded && traces.slipping[p];
    const double fade = bonded ? 1.0 : facets.history.contacts().fade(f);
    const StiffestNormal stiffest = stiffest_normal(facets, f, bonded);
    spring.normal_share[p] = stiffest.share;
    const double dashpot = damping_rate * (bonded && !rubs ? facets.tables.damping(f)
                                                           : facets.tables.contact_damping(f));
    const bool damps_shear = bonded && !rubs && !facets.tables.is_mirror(f);
    spring.bonded[p] = bonded;
    spring.law[p] = {bond.point_area * (fade * bond.shear + (damps_shear ? dashpot : 0.0)),
                     bond.point_area * (fade * (stiffest.stiffness - bond.shear) +
                                        (damps_shear ? 0.0 : fade * dashpot))};
  }
}

void LinearNetwork::set_blocks(const FacetNetwork& network, BreakView view) {
  const BlockFields& blocks = network.block_fields();
  const LeaningFaces* leaning = view == BreakView::as_it_is ? network.leaning() : nullptr;
  rock_ = blocks.rock;
  for (std::size_t b = 0; b + 1 < blocks.size(); ++b) {
    volume_.push_back(blocks.stiffened_volume(b, blocks.sums[b]));
    rock_volume_.push_back(blocks.volume(b));
    moment_.push_back(leaning != nullptr ? leaning->moment(b, blocks.state[b].rotation)
                                         : Mat3(Mat3::Zero()));
  }
  slants_.resize(volume_.size());
  theta_.resize(volume_.size());
  bulk_.resize(volume_.size());
}

Vec3 LinearNetwork::jump(const Spring& s, std::size_t p, std::span<const double> motion) {
  const Vec3 of_i = moved(of_block(motion, s.i), s.arm_i[p]);
  return s.j < 0 ? Vec3(-of_i) : Vec3(moved(of_block(motion, s.j), s.arm_j[p]) - of_i);
}

void LinearNetwork::bulk_stresses(std::span<const double> motion, const RankTeam& team) {
  std::fill(theta_.begin(), theta_.end(), 0.0);
  for (const Spring& s : springs_) {
    for (std::size_t p = 0; p < kFacetPoints; ++p) {
      if (!s.bonded[p]) continue;
      const Vec3 opened = s.counted(p, jump(s, p, motion));
      theta_[static_cast<std::size_t>(s.i)] += s.strain_i * s.on_i.opening.dot(opened);
      if (s.j >= 0)
        theta_[static_cast<std::size_t>(s.j)] += s.strain_j * s.on_j.opening.dot(opened);
    }
  }
  for (std::size_t b = 0; b < theta_.size(); ++b) theta_[b] /= volume_[b];
  team.fill_copies(theta_, 1);
  std::fill(bulk_.begin(), bulk_.end(), 0.0);
  for (const Spring& s : springs_) {
    if (s.j < 0 || s.sharpening == 0.0) continue;
    const auto i = static_cast<std::size_t>(s.i), j = static_cast<std::size_t>(s.j);
    const double uneven = s.sharpening * (theta_[i] - theta_[j]);
    bulk_[i] += uneven;
    bulk_[j] -= uneven;
  }
  for (std::size_t b = 0; b < bulk_.size(); ++b)
    bulk_[b] = rock_[b].bulk_stress(theta_[b], bulk_[b], volume_[b]);
  team.fill_copies(bulk_, 1);
}

void LinearNetwork::slant_stresses(std::span<const double> motion, const RankTeam& team) {
  if (!slanted_) {
    const auto is_slanted = [](const Spring& s) { return s.slanted[0] || s.slanted[1]; };
    slanted_ =
        team.sum(std::any_of(springs_.begin(), springs_.end(), is_slanted) ? 1.0 : 0.0) > 0.0;
  }
  if (!*slanted_) return;
  for (Slant& slant : slants_) slant = {Mat3::Zero(), Mat3::Zero(), Mat3::Zero()};
  for (const Spring& s : springs_) {
    for (std::size_t p = 0; p < kFacetPoints; ++p) {
      if (!s.bonded[p]) continue;
      const Vec3 strained = s.strained(s.counted(p, jump(s, p, motion)));
      const auto add = [&](int block, double strain, const LeaningSide<Vec3>& side) {
        const auto b = static_cast<std::size_t>(block);
        add_opened(opened(strain, rock_volume_[b], strained), side, slants_[b].gradient,
                   slants_[b].excess);
      };
      if (s.slanted[0]) add(s.i, s.strain_i, s.on_i);
      if (s.slanted[1]) add(s.j, s.strain_j, s.on_j);
    }
  }
  for (std::size_t b = 0; b < slants_.size(); ++b)
    slants_[b].stress =
        leaning_stress(rock_[b].two_g, slants_[b].gradient, moment_[b], slants_[b].excess);
  static_assert(sizeof(Slant) == 27 * sizeof(double));
  team.fill_copies(
      {slants_.empty() ? nullptr : slants_.front().gradient.data(), 27 * slants_.size()}, 27);
}

/// Force of a bonded point by the slant [N].
Vec3 LinearNetwork::slant_pull(const Spring& s) const {
  Vec3 pull = Vec3::Zero();
  const auto add = [&](int block, double share, const LeaningSide<Vec3>& side) {
    const auto b = static_cast<std::size_t>(block);
    const LeaningBlock on_facet{rock_[b].two_g, slants_[b].stress, slants_[b].gradient};
    pull += share * on_facet.traction(side);
  };
  if (s.slanted[0]) add(s.i, s.pull_i, s.on_i);
  if (s.slanted[1]) add(s.j, s.pull_j, s.on_j);
  return s.strained(pull);
}

/// Force of a bonded point by the bulk stresses [N].
Vec3 LinearNetwork::bulk_pull(const Spring& s) const {
  Vec3 pull = s.pull_i * bulk_[static_cast<std::size_t>(s.i)] * s.on_i.opening;
  if (s.j >= 0) pull += s.pull_j * bulk_[static_cast<std::size_t>(s.j)] * s.on_j.opening;
  return pull;
}

void LinearNetwork::balance(std::span<double> motion, std::span<double> force,
                            const RankTeam& team) {
  team.fill_copies(motion, 6);
  bulk_stresses(motion, team);
  slant_stresses(motion, team);
  std::fill(force.begin(), force.end(), 0.0);
  const auto push = [&](int block, const Vec3& on_block, const Vec3& arm) {
    const auto at = 6 * static_cast<std::size_t>(block);
    if (block < 0 || at >= force.size()) return;  // the ground, or a copy
    Eigen::Map<Six> six(force.data() + at);
    six.head<3>() += on_block;
    six.tail<3>() += arm.cross(on_block);
  };
  for (const Spring& s : springs_) {
    const Vec3 bulk = bulk_pull(s) + slant_pull(s);
    for (std::size_t p = 0; p < kFacetPoints; ++p) {
      const Vec3 opened = jump(s, p, motion);
      Vec3 pull = s.law[p].traction(s.normal, opened);
      if (s.bonded[p]) pull += s.counted(p, bulk);
      push(s.i, -pull, s.arm_i[p]);
      push(s.j, pull, s.arm_j[p]);
    }
  }
}

}  // namespace muckpile
