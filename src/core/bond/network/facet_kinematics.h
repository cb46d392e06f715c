// SPDX-License-Identifier: GPL-2.0-or-later
// How the two sides of a facet lie in the present pose, one facet at a time: jumps, normals, turns.
// Scope: reads tables, history and poses of blocks; SI units. Four vectors, or three points, lie in
// the lanes of one number (facet_points.h). Groups of facets at once: facet_wide.h.
#pragma once

#include <array>
#include <cmath>

#include "bond/network/block_fields.h"
#include "bond/network/facet_history.h"
#include "bond/network/facet_parting.h"
#include "bond/network/facet_points.h"
#include "bond/network/facet_tables.h"
#include "math/lanes.h"

namespace muckpile {

/// How the two sides of a facet lie in the present pose. Lanes: the centroid, the two half axes,
/// the normal.
struct FacetMotion {
  LaneVec near;   // on block i; the centroid from its centre [m]
  LaneVec apart;  // on block j less on block i [m]
  Vec3 normal;    // unit, mean of the two
  double scale;   // that makes the sum of the two normals a unit vector [-]

  [[nodiscard]] Vec3 mean_jump() const { return apart.at(0); }
  [[nodiscard]] LaneVec jump() const { return at_points(apart); }
  [[nodiscard]] LaneVec side() const { return at_points(near); }

  [[nodiscard]] FacetTurn<double> turn() const {
    const Lanes differ = dot(apart, apart), lengths = dot(near, near);
    return {differ[1], differ[2], lengths[1], lengths[2]};
  }

  [[nodiscard]] Mat3 axes() const {
    const FacetAxes<Vec3> axes(normal, 2.0 * near.at(1) + apart.at(1));
    Mat3 columns;
    columns << axes.normal, axes.along, axes.across;
    return columns;
  }

 private:
  [[nodiscard]] static Lanes at_points(const Lanes& v) {
    return v[0] + v[1] * load(kOnFirst) + v[2] * load(kOnSecond);
  }
  [[nodiscard]] static LaneVec at_points(const LaneVec& v) {
    return {at_points(v.x), at_points(v.y), at_points(v.z)};
  }
};

/// m of a facet's two blocks in the present pose [-].
struct FacetOpenings {
  Vec3 i, j;
};

/// The facets of a network in the pose of its blocks.
struct FacetKinematics {
  const FacetTables& tables;
  const FacetHistory& history;
  const BlockFields& blocks;

  [[nodiscard]] FacetMotion motion(std::size_t f) const;
  /// `scale` is that of its motion.
  [[nodiscard]] FacetOpenings openings(std::size_t f, double scale) const;
  /// A direction of the start that turns with the mean of the two blocks, as the openings do.
  [[nodiscard, gnu::always_inline]] Vec3 turned(std::size_t f, const Vec3& start,
                                                double scale) const {
    return scale * (blocks.state_of(tables.i_of(f)).rotation * start +
                    blocks.state_of(tables.j_of(f)).rotation * start);
  }
  /// Jumps at the points, less what they have slipped [m].
  [[nodiscard]] LaneVec elastic_jump(std::size_t f, const FacetMotion& motion) const;
  /// Mean over the facet of the elastic jump where it is in the dilatations, as it counts there
  /// [m].
  [[nodiscard]] Vec3 bonded_jump(std::size_t f, const FacetMotion& motion) const {
    return history.state(f) == FacetState::intact && !tables.alone(f)
               ? motion.mean_jump()
               : bonded_jump_of_points(f, motion);
  }

 private:
  /// Where a point has broken, or the law is not grouped. By value: an intact facet's motion needs
  /// no place in memory then.
  [[nodiscard]] Vec3 bonded_jump_of_points(std::size_t f, FacetMotion motion) const;
};

[[gnu::always_inline]] inline FacetMotion FacetKinematics::motion(std::size_t f) const {
  const FacetGroup& group = tables.group_of(f);
  const std::size_t k = FacetTables::lane_of(f);
  const BlockState& si = blocks.state_of(group.i[k]);
  const BlockState& sj = blocks.state_of(group.j[k]);
  const auto four = [&](std::size_t d) {
    return load(std::array<float, kLanes>{group.arm[d][k], group.half_1[d][k], group.half_2[d][k],
                                          group.normal[d][k]});
  };
  const LaneVec start(four(0), four(1), four(2));
  const LaneMask centroid = Lanes([](auto lane) { return lane == 0 ? 1.0 : 0.0; }) > 0.5;
  FacetMotion motion;
  motion.near = rotated(si.rotation, start);
  const LaneVec far =
      rotated(sj.rotation, choose(centroid, LaneVec(at_lane(group.arm_j, k)), start));
  const LaneVec between = choose(centroid, LaneVec(Vec3(sj.centre - si.centre)), LaneVec());
  motion.apart = far - motion.near + between;
  const Vec3 both = motion.near.at(3) + far.at(3);
  motion.scale = 1.0 / std::sqrt(both.squaredNorm());
  motion.normal = motion.scale * both;
  return motion;
}

[[gnu::always_inline]] inline FacetOpenings FacetKinematics::openings(std::size_t f,
                                                                      double scale) const {
  const FacetGroup& group = tables.group_of(f);
  const std::size_t k = FacetTables::lane_of(f);
  const Mat3& ri = blocks.state_of(group.i[k]).rotation;
  const Mat3& rj = blocks.state_of(group.j[k]).rotation;
  const auto turned = [&](const Vec3& v) { return Vec3(scale * (ri * v + rj * v)); };
  return {turned(at_lane(group.opening_i, k)), turned(at_lane(group.opening_j, k))};
}

}  // namespace muckpile
