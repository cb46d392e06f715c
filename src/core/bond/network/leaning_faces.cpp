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

/// Calls `add` with block, `opened`, m and g of each side on which a facet leans.
template <class Add>
void stretch_facet(const LeaningFaces& faces, const FacetKinematics& facets, std::size_t f,
                   const Add& add) {
  const std::array<bool, 2> leans = facets.tables.name(f).slanted();
  if (facets.history.bonded_points(f) == 0 || !(leans[0] || leans[1])) return;
  const FacetMotion motion = facets.motion(f);
  const FacetOpenings openings = facets.openings(f, motion.scale);
  const BondConstants bond = facets.tables.bond(f);
  const FacetLean& leaning = faces.facet(f);
  const Vec3 jump = leaning.strained(facets.bonded_jump(f, motion), motion.normal);
  const auto add_side = [&](std::size_t b, double area, const Vec3& opening, const Vec3& lean) {
    add(b, Vec3(area / facets.blocks.volume(b) * jump), opening,
        facets.turned(f, lean, motion.scale));
  };
  const auto [i, j] = facets.tables.blocks_of(f);
  if (leans[0]) add_side(i, bond.area_i, openings.i, leaning.lean[0]);
  if (leans[1]) add_side(j, bond.area_j, openings.j, leaning.lean[1]);
}

template <class Add>
void stretch_group(const LeaningFaces& faces, const FacetKinematics& facets, const LaneSet& set,
                   const Add& add) {
  const LeaningLanes lanes(facets, set);
  if (lanes.at_once == 0)
    return each_lane(set.lanes, [&](std::size_t k) {
      stretch_facet(faces, facets, set.group * kGroup + k, add);
    });
  const LeaningGroup group(faces, facets, set.group);
  const StretchRows on_i(group, group.side_i(), facets.blocks),
      on_j(group, group.side_j(), facets.blocks);
  each_lane(set.lanes, [&](std::size_t k) {
    const std::size_t f = set.group * kGroup + k;
    if ((lanes.at_once >> k & 1u) == 0) return stretch_facet(faces, facets, f, add);
    const auto [i, j] = facets.tables.blocks_of(f);
    const auto add_side = [&](std::size_t b, const StretchRows& rows) {
      add(b, at_lane(rows.opened, k), at_lane(rows.opening, k), at_lane(rows.lean, k));
    };
    if ((lanes.on_i >> k & 1u) != 0) add_side(i, on_i);
    if ((lanes.on_j >> k & 1u) != 0) add_side(j, on_j);
  });
}

/// Displacement gradients and stresses T of all blocks.
struct BlockTensors {
  const std::vector<Mat3>&gradients, &stresses;
};

/// Calls `add` with a facet that leans, its traction and the torque on both of its blocks.
template <class Add>
void pull_facet(const LeaningFaces& faces, const FacetKinematics& facets,
                const BlockTensors& tensors, std::size_t f, const Add& add) {
  const FacetTables& tables = facets.tables;
  const std::array<bool, 2> leans = tables.name(f).slanted();
  if (facets.history.bonded_points(f) == 0 || !(leans[0] || leans[1])) return;
  const FacetMotion motion = facets.motion(f);
  const FacetOpenings openings = facets.openings(f, motion.scale);
  const BondConstants bond = tables.bond(f);
  const FacetLean& leaning = faces.facet(f);
  const Vec3 jump = leaning.strained(facets.bonded_jump(f, motion), motion.normal);
  Vec3 traction = Vec3::Zero(), turning = Vec3::Zero();
  const auto add_side = [&](std::size_t b, double share, const Vec3& opening, const Vec3& start) {
    const Vec3 lean = facets.blocks.rock[b].two_g * facets.turned(f, start, motion.scale);
    traction += share * (tensors.stresses[b] * opening - tensors.gradients[b] * lean);
    turning += share * (opening.cross(Vec3(tensors.stresses[b].transpose() * jump)) -
                        lean.cross(Vec3(tensors.gradients[b].transpose() * jump)));
  };
  const auto [i, j] = tables.blocks_of(f);
  if (leans[0]) add_side(i, bond.bulk_i, openings.i, leaning.lean[0]);
  if (leans[1]) add_side(j, bond.bulk_j, openings.j, leaning.lean[1]);
  add(f, leaning.strained(traction, motion.normal),
      Vec3(-0.5 * tables.area(f) * (turning + jump.cross(traction))));
}

template <class Add>
void pull_group(const LeaningFaces& faces, const FacetKinematics& facets,
                const BlockTensors& tensors, const LaneSet& set, const Add& add) {
  const LeaningLanes lanes(facets, set);
  alignas(64) FacetRows<double> tractions, torques;
  if (lanes.at_once != 0) {
    const LeaningGroup group(faces, facets, set.group);
    const WideVec& jump = group.jump();
    WideVec traction, turning;
    const auto add_side = [&](unsigned on, const LeaningGroup::Side& side)
        __attribute__((always_inline)) {
      const Wide share = choose(mask_of<Wide>(on), group.bulk(), 0.0);
      const auto two_g = [&](std::size_t b) { return facets.blocks.rock[b].two_g; };
      const WideVec lean = group.number(side, two_g) * side.lean;
      const WideMat stress = group.tensor(side, tensors.stresses),
                    gradient = group.tensor(side, tensors.gradients);
      traction += share * (stress * side.opening - gradient * lean);
      turning +=
          share * (cross(side.opening, stress.back(jump)) - cross(lean, gradient.back(jump)));
    };
    add_side(lanes.on_i, group.side_i());
    add_side(lanes.on_j, group.side_j());
    store(group.strained(traction), tractions);
    store(Wide(-0.5) * group.area() * (turning + cross(jump, traction)), torques);
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
  const auto add = [&](std::size_t b, const Vec3& opened, const Vec3& opening, const Vec3& lean) {
    gradients_[b].noalias() += opened * opening.transpose();
    blocks_[b].excess.noalias() += opened * lean.transpose();
  };
  for (const LaneSet& set : bonded) stretch_group(*this, facets, set, add);
  for (std::size_t b = 0; b < blocks.size(); ++b) stresses_[b] = stress(b, blocks);
}

/// T of a block [Pa].
Mat3 LeaningFaces::stress(std::size_t b, const BlockFields& blocks) const {
  const Mat3& r = blocks.state[b].rotation;
  return blocks.rock[b].two_g *
         (gradients_[b] * (r * blocks_[b].moment * r.transpose()) - blocks_[b].excess);
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
  const Mat3 q = r * blocks_[b].moment * r.transpose();
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
  const FacetTables& tables = facets.tables;
  const double scale = facets.motion(f).scale;
  const BondConstants bond = tables.bond(f);
  const Vec3 jump = facets_[f].strained(point.lost, point.normal);
  const auto take = [&](int side, int block, double area, const Vec3& opening) {
    if (!tables.name(f).slanted()[static_cast<std::size_t>(side)]) return;
    const auto b = static_cast<std::size_t>(block);
    const double volume = facets.blocks.volume(b);
    const Vec3 opened = area / (kFacetPoints * volume) * jump;
    const Vec3 lean = facets.turned(f, facets_[f].lean[static_cast<std::size_t>(side)], scale);
    lost_[b].gradient += opened * opening.transpose();
    lost_[b].excess += opened * lean.transpose();
    if (tables.is_joint(f) && !point.slips)
      lost_[b].moment += point_moment(tables, f, side) / volume;
  };
  take(0, tables.i_of(f), bond.area_i, point.openings.i);
  take(1, tables.j_of(f), bond.area_j, point.openings.j);
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
