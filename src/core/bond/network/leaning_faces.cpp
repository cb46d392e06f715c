// SPDX-License-Identifier: GPL-2.0-or-later
// Leaning faces: gradients and stresses of blocks, tractions, breaking.
// Scope: see the header.
#include "bond/network/leaning_faces.h"

#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

std::span<double> numbers_of(std::vector<Mat3>& tensors, std::size_t blocks) {
  return {blocks > 0 ? tensors.front().data() : nullptr, 9 * blocks};
}

/// From the centre of block i to that of j in the start [m].
Vec3 line_of_centres(const FacetTables& tables, std::size_t f) {
  return tables.arm_i(f) - tables.arm_j(f);
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
  each_facet(bonded, [&](std::size_t f) {
    const std::array<bool, 2> leans = facets.tables.name(f).slanted();
    if (facets.history.bonded_points(f) == 0 || !(leans[0] || leans[1])) return;
    const FacetMotion motion = facets.motion(f);
    const FacetOpenings openings = facets.openings(f, motion.scale);
    const BondConstants bond = facets.tables.bond(f);
    const Vec3 jump = facets_[f].strained(facets.bonded_jump(f, motion), motion.normal);
    const auto add = [&](int block, double area, const Vec3& opening, const Vec3& lean) {
      const auto b = static_cast<std::size_t>(block);
      const Vec3 opened = area / blocks.volume(b) * jump;
      gradients_[b] += opened * opening.transpose();
      blocks_[b].excess += opened * facets.turned(f, lean, motion.scale).transpose();
    };
    if (leans[0]) add(facets.tables.i_of(f), bond.area_i, openings.i, facets_[f].lean[0]);
    if (leans[1]) add(facets.tables.j_of(f), bond.area_j, openings.j, facets_[f].lean[1]);
  });
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
  const FacetTables& tables = facets.tables;
  const BlockFields& blocks = facets.blocks;
  each_facet(working, [&](std::size_t f) {
    const std::array<bool, 2> leans = tables.name(f).slanted();
    if (facets.history.bonded_points(f) == 0 || !(leans[0] || leans[1])) return;
    const FacetMotion motion = facets.motion(f);
    const FacetOpenings openings = facets.openings(f, motion.scale);
    const BondConstants bond = tables.bond(f);
    const Vec3 jump = facets_[f].strained(facets.bonded_jump(f, motion), motion.normal);
    Vec3 traction = Vec3::Zero(), turning = Vec3::Zero();
    const auto add = [&](int block, double share, const Vec3& opening, const Vec3& start) {
      const auto b = static_cast<std::size_t>(block);
      const Vec3 lean = blocks.rock[b].two_g * facets.turned(f, start, motion.scale);
      traction += share * (stresses_[b] * opening - gradients_[b] * lean);
      turning += share * (opening.cross(Vec3(stresses_[b].transpose() * jump)) -
                          lean.cross(Vec3(gradients_[b].transpose() * jump)));
    };
    if (leans[0]) add(tables.i_of(f), bond.bulk_i, openings.i, facets_[f].lean[0]);
    if (leans[1]) add(tables.j_of(f), bond.bulk_j, openings.j, facets_[f].lean[1]);
    tractions_[f] = facets_[f].strained(traction, motion.normal);
    turning = (-0.5 * tables.area(f) * (turning + jump.cross(traction))).eval();
    const auto [i, j] = tables.blocks_of(f);
    torque[i] += turning;
    torque[j] += turning;
  });
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
