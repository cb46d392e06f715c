// SPDX-License-Identifier: GPL-2.0-or-later
// Leaning faces: gradients and stresses of blocks, tractions, breaking.
// Scope: see the header.
#include "bond/network/leaning_faces.h"

#include <algorithm>
#include <cmath>

#include "bond/network/leaning_group.h"

namespace muckpile {
namespace {

std::span<double> numbers_of(std::vector<Mat3>& tensors, std::size_t blocks) {
  return {blocks > 0 ? tensors.front().data() : nullptr, 9 * blocks};
}

/// From the centre of block i to that of j in the start [m].
Vec3 line_of_centres(const FacetTables& tables, std::size_t f) {
  return tables.arm_i(f) - tables.arm_j(f);
}

bool leans(const FacetKinematics& facets, std::size_t f) {
  const FacetName& name = facets.tables.name(f);
  return facets.history.bonded_points(f) > 0 && (name.slanted_i || name.slanted_j);
}

[[gnu::always_inline]] inline LeaningFacet facet_of(const LeaningFaces& faces,
                                                    const FacetKinematics& facets, std::size_t f) {
  const FacetMotion motion = facets.motion(f);
  return {faces.facet(f), facets, f, motion, facets.bonded_jump(f, motion)};
}

/// Calls `add` with block, what has opened and the side, of each side on which a facet leans.
template <class Add>
void stretch_facet(const LeaningFaces& faces, const FacetKinematics& facets, std::size_t f,
                   const Add& add) {
  if (!leans(facets, f)) return;
  const LeaningFacet facet = facet_of(faces, facets, f);
  facet.each_side([&](int, const LeaningFacet::Side& side) {
    add(side.block, opened_on(facet, side, facets.blocks), side);
  });
}

template <class Add>
void stretch_group(const LeaningFaces& faces, const FacetKinematics& facets, const LaneSet& set,
                   const Add& add) {
  const LeaningLanes lanes(facets, set);
  struct {
    alignas(64) FacetRows<double> opened, opening, lean;
  } rows[2];
  if (lanes.at_once != 0) {
    const LeaningGroup group(faces, facets, set.group, lanes);
    group.each_side([&](int s, const LeaningGroup::Side& side) __attribute__((always_inline)) {
      store(opened_on(group, side, facets.blocks), rows[s].opened);
      store(side.opening, rows[s].opening);
      store(side.lean, rows[s].lean);
    });
  }
  each_lane(set.lanes, [&](std::size_t k) {
    const std::size_t f = set.group * kGroup + k;
    if ((lanes.at_once >> k & 1u) == 0) return stretch_facet(faces, facets, f, add);
    const auto [i, j] = facets.tables.blocks_of(f);
    const auto add_side = [&](std::size_t b, int s) {
      add(b, at_lane(rows[s].opened, k),
          LeaningSide<Vec3>{at_lane(rows[s].opening, k), at_lane(rows[s].lean, k)});
    };
    if ((lanes.on_i >> k & 1u) != 0) add_side(i, 0);
    if ((lanes.on_j >> k & 1u) != 0) add_side(j, 1);
  });
}

/// Calls `add` with a facet that leans, its traction and the torque on both of its blocks.
template <class Add>
void pull_facet(const LeaningFaces& faces, const FacetKinematics& facets,
                const BlockTensors& tensors, std::size_t f, const Add& add) {
  if (!leans(facets, f)) return;
  const LeaningFacet facet = facet_of(faces, facets, f);
  const LeaningPull pull = pull_on(facet, tensors, facets.blocks);
  add(f, pull.traction(), pull.torque(facet.area()));
}

template <class Add>
void pull_group(const LeaningFaces& faces, const FacetKinematics& facets,
                const BlockTensors& tensors, const LaneSet& set, const Add& add) {
  const LeaningLanes lanes(facets, set);
  alignas(64) FacetRows<double> tractions, torques;
  if (lanes.at_once != 0) {
    const LeaningGroup group(faces, facets, set.group, lanes);
    const LeaningPull pull = pull_on(group, tensors, facets.blocks);
    store(pull.traction(), tractions);
    store(pull.torque(group.area()), torques);
  }
  each_lane(set.lanes, [&](std::size_t k) {
    const std::size_t f = set.group * kGroup + k;
    if ((lanes.at_once >> k & 1u) == 0) return pull_facet(faces, facets, tensors, f, add);
    add(f, at_lane(tractions, k), at_lane(torques, k));
  });
}

}  // namespace

std::span<double> LeaningFaces::gradients(std::size_t blocks) {
  return numbers_of(gradients_, blocks);
}

std::span<double> LeaningFaces::stresses(std::size_t blocks) {
  return numbers_of(stresses_, blocks);
}

bool LeaningFaces::exist_in(const FacetTables& tables) {
  return std::any_of(tables.names().begin(), tables.names().end(),
                     [](const FacetName& name) { return name.slanted_i || name.slanted_j; });
}

void LeaningFaces::reset_blocks(std::size_t blocks) {
  gradients_.assign(blocks, Mat3::Zero());
  stresses_.assign(blocks, Mat3::Zero());
}

void LeaningFaces::set(const FacetTables& tables, std::size_t blocks) {
  facets_.assign(tables.size(), {});
  tractions_.assign(tables.groups() * kGroup, Vec3::Zero());
  reset_blocks(blocks);
  for (std::size_t f = 0; f < tables.size(); ++f) {
    if (!tables.is_joint(f)) {
      facets_[f].shear_share = tables.name(f).kind == FacetKind::mirror ? 0.0 : 1.0;
      continue;
    }
    const Vec3 between = line_of_centres(tables, f), normal = tables.normal(f);
    const Vec3 along = between / normal.dot(between);
    const BondConstants bond = tables.bond(f);
    facets_[f].lean = {along - bond.opening_i, along - bond.opening_j};
    const double rock = 2.0 * tables.laws().rock(tables.zone_i(f)).shear_modulus() /
                        (normal.dot(between) / tables.stiffening(f));
    facets_[f].shear_share = bond.shear / rock / (bond.bulk_i + bond.bulk_j);
  }
}

/// The part of the bonded points of a facet in the moment Q of its block i (side 0) or j, times V.
Mat3 LeaningFaces::point_moment(const FacetTables& tables, std::size_t f, int side) const {
  const Vec3 between = line_of_centres(tables, f);
  const Mat3 m = between * facets_[f].lean[static_cast<std::size_t>(side)].transpose();
  return 0.25 * (tables.area(f) / kFacetPoints) * (m + m.transpose());
}

void LeaningFaces::count_moments(const FacetTables& tables, const FacetHistory& history,
                                 const BlockFields& blocks) {
  blocks_.assign(blocks.size(), {});
  lost_.assign(blocks.size(), {});
  for (std::size_t f = 0; f < tables.size(); ++f) {
    if (!tables.is_joint(f)) continue;
    const auto [i, j] = tables.blocks_of(f);
    const double points = history.bonded_points(f);
    if (tables.name(f).slanted_i)
      blocks_[i].moment += points / blocks.volume(i) * point_moment(tables, f, 0);
    if (tables.name(f).slanted_j)
      blocks_[j].moment += points / blocks.volume(j) * point_moment(tables, f, 1);
  }
}

void LeaningFaces::stretch(const FacetKinematics& facets, const std::vector<LaneSet>& bonded) {
  const BlockFields& blocks = facets.blocks;
  std::fill(gradients_.begin(), gradients_.end(), Mat3::Zero());
  for (BlockLean& block : blocks_) block.excess.setZero();
  const auto add = [&](std::size_t b, const Vec3& opened, const LeaningSide<Vec3>& side) {
    add_opened(opened, side, gradients_[b], blocks_[b].excess);
  };
  for (const LaneSet& set : bonded) stretch_group(*this, facets, set, add);
  for (std::size_t b = 0; b < blocks.size(); ++b) stresses_[b] = stress(b, blocks);
}

/// T of a block [Pa].
Mat3 LeaningFaces::stress(std::size_t b, const BlockFields& blocks) const {
  const Mat3& r = blocks.state[b].rotation;
  return leaning_stress(blocks.rock[b].two_g, gradients_[b], r * blocks_[b].moment * r.transpose(),
                        blocks_[b].excess);
}

double LeaningFaces::energy(std::size_t b, const BlockFields& blocks) const {
  // G (F:F Q - 2 F:E) = F:T/2 - G F:E.
  const Mat3 t = stress(b, blocks);
  return blocks.volume(b) *
         (0.5 * gradients_[b].cwiseProduct(t).sum() -
          0.5 * blocks.rock[b].two_g * gradients_[b].cwiseProduct(blocks_[b].excess).sum());
}

/// On a block that turns its moment Q against its gradient [N m].
Vec3 LeaningFaces::moment_torque(std::size_t b, const Mat3& r, double volume,
                                 double shear_modulus) const {
  const Mat3 q = moment(b, r);
  const Mat3 squared = gradients_[b].transpose() * gradients_[b];
  const Mat3 swirl = q * squared - squared * q;
  return 2.0 * volume * shear_modulus * Vec3(swirl(2, 1), swirl(0, 2), swirl(1, 0));
}

/// u, m and g of one facet may turn without the block's other facets and its moment, which changes
/// the energy: hence the torques.
void LeaningFaces::pull(const FacetKinematics& facets, const std::vector<LaneSet>& working,
                        std::vector<Vec3>& torque) {
  const BlockFields& blocks = facets.blocks;
  const auto add = [&](std::size_t f, const Vec3& traction, const Vec3& turning) {
    const auto [i, j] = facets.tables.blocks_of(f);
    tractions_[f] = traction;
    torque[i] += turning;
    torque[j] += turning;
  };
  const BlockTensors tensors{gradients_, stresses_};
  for (const LaneSet& set : working) pull_group(*this, facets, tensors, set, add);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    torque[b] +=
        moment_torque(b, blocks.state[b].rotation, blocks.volume(b), 0.5 * blocks.rock[b].two_g);
}

void LeaningFaces::drop(const FacetKinematics& facets, std::size_t f, const LostPoint& point) {
  const LeaningFacet facet(facets_[f], facets, f, facets.motion(f), point.lost);
  facet.each_side([&](int s, const LeaningFacet::Side& side) {
    LostLean& lost = lost_[side.block];
    const double volume = facets.blocks.volume(side.block);
    add_opened(opened(facet.area() * side.share, kFacetPoints * volume, facet.jump()), side,
               lost.gradient, lost.excess);
    if (facets.tables.is_joint(f) && !point.slips)
      lost.moment += point_moment(facets.tables, f, s) / volume;
  });
}

void LeaningFaces::book(const BlockFields& blocks, JointLosses& losses) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    BlockLean& block = blocks_[b];
    LostLean& lost = lost_[b];
    if (blocks.owned(b)) {
      const double before = energy(b, blocks);
      gradients_[b] -= lost.gradient;
      block.excess -= lost.excess;
      block.moment -= lost.moment;
      losses.fracture += before - energy(b, blocks);
      stresses_[b] = stress(b, blocks);
    }
    lost = {};
  }
}

double LeaningFaces::bytes() const {
  return static_cast<double>(
      facets_.capacity() * sizeof(FacetLean) + tractions_.capacity() * sizeof(Vec3) +
      blocks_.capacity() * sizeof(BlockLean) + lost_.capacity() * sizeof(LostLean) +
      (gradients_.capacity() + stresses_.capacity()) * sizeof(Mat3));
}

}  // namespace muckpile
