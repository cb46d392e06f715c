// SPDX-License-Identifier: GPL-2.0-or-later
// What the facet network works out of one facet for four vectors, or three points, at once.
// Scope: inside FacetNetwork. Points are the first kFacetPoints lanes, the last has no meaning.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "bond/network/facet_network.h"
#include "math/lanes.h"

namespace muckpile {

static_assert(kFacetPoints == kLanes - 1);

/// Where the points lie: three points at 120 degrees on the ellipse of half axes sqrt(2) x gyration
/// radii have the facet's second moments. Weights of the first and the second half axis.
inline constexpr double kHalfSqrt3 = 0.86602540378443865;
inline constexpr std::array<double, kLanes> kOnFirst = {1.0, -0.5, -0.5, 0.0};
inline constexpr std::array<double, kLanes> kOnSecond = {0.0, kHalfSqrt3, -kHalfSqrt3, 0.0};

[[nodiscard]] inline LaneMask is_point() {
  return Lanes([](auto lane) { return lane < kFacetPoints ? 1.0 : 0.0; }) > 0.5;
}

/// Points for which `is` holds.
template <class Is>
[[nodiscard]] LaneMask where(const Is& is) {
  const auto value = [&](auto lane) {
    return lane < kFacetPoints && is(std::size_t{lane % kFacetPoints}) ? 1.0 : 0.0;
  };
  return Lanes(value) > 0.5;
}
[[nodiscard]] inline LaneMask where_broken(const FacetTraces& memory) {
  return where([&](std::size_t p) { return memory.broken[p]; });
}
[[nodiscard]] inline LaneMask where_contact(const FacetTraces& memory) {
  return where([&](std::size_t p) { return memory.is_contact(p); });
}
[[nodiscard]] inline LaneMask where_slipping(const FacetTraces& memory) {
  return where([&](std::size_t p) { return memory.slipping[p]; });
}

/// A vector of each point.
[[nodiscard]] inline LaneVec lanes_of(const std::array<Vec3, kFacetPoints>& v) {
  const auto of = [&](Eigen::Index d) {
    return Lanes([&](auto lane) { return lane < kFacetPoints ? v[lane % kFacetPoints][d] : 0.0; });
  };
  return {of(0), of(1), of(2)};
}

/// By how many groups what broken facets remember is asked for ahead of its use.
inline constexpr std::size_t kContactsAhead = 32 / kGroup;

/// A facet that has turned so far begins to fade, and does not hold on by a last point, as by a
/// hinge [rad].
inline constexpr double kTurnStart = 0.1;

// A broken facet is a plane contact only while its two faces still match. It fades between these
// shares of its radius slid, and of radians turned, and retires once it has opened that far.
inline constexpr double kSlideStart = 0.1, kSlideEnd = 0.5;
inline constexpr double kTurnEnd = 0.5;  // from kTurnStart
inline constexpr double kOpened = 0.1;
inline constexpr double kSurelyOpen = 0.01;  // further than its rotation explains: no point closed

/// How far the faces match: 1 to 0. `slid` in radii, `turned` in radians.
[[nodiscard]] inline double matching_faces(double slid, double turned) {
  const auto ramp_down = [](double x, double start, double end) {
    return std::clamp((end - x) / (end - start), 0.0, 1.0);
  };
  return ramp_down(slid, kSlideStart, kSlideEnd) * ramp_down(turned, kTurnStart, kTurnEnd);
}

/// How the two sides of a facet lie in the present pose. Lanes: the centroid, the two half axes,
/// the normal.
struct FacetNetwork::Motion {
  LaneVec near;   // on block i; the centroid from its centre [m]
  LaneVec apart;  // on block j less on block i [m]
  Vec3 normal;    // unit, mean of the two
  double scale;   // that makes the sum of the two normals a unit vector [-]

  [[nodiscard]] Vec3 mean_jump() const { return apart.at(0); }
  [[nodiscard]] LaneVec jump() const { return at_points(apart); }
  [[nodiscard]] LaneVec side() const { return at_points(near); }

  /// Square of the angle between the two blocks, while small [rad2]: by how much the half axes of
  /// both sides differ.
  [[nodiscard]] double turned_squared() const {
    const Lanes differ = dot(apart, apart), lengths = dot(near, near);
    return differ[1] / lengths[1] + differ[2] / lengths[2];
  }
  /// Whether they have turned by more than `angle` [rad]; without a division.
  [[nodiscard]] bool turned(double angle) const {
    const Lanes differ = dot(apart, apart), lengths = dot(near, near);
    return differ[1] * lengths[2] + differ[2] * lengths[1] >
           angle * angle * lengths[1] * lengths[2];
  }

  /// The facet's own axes, which turn with the mean of the two blocks, as the jump between points
  /// on both of them does: normal, along the first half axis, across. What broken points remember
  /// turns so: turned by one block, a facet that has slid and then tilts would do work that no
  /// spring stores.
  [[nodiscard]] Mat3 axes() const {
    const Vec3 half = 2.0 * near.at(1) + apart.at(1);
    const Vec3 along = half - normal.dot(half) * normal;
    Mat3 columns;
    columns.col(0) = normal;
    columns.col(1) = 1.0 / std::sqrt(along.squaredNorm()) * along;
    columns.col(2) = normal.cross(Vec3(columns.col(1)));
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

[[gnu::always_inline]] inline FacetNetwork::Motion FacetNetwork::motion_of(std::size_t f) const {
  const FacetGroup& group = group_of(f);
  const std::size_t k = lane_of(f);
  const BlockState& si = state_[static_cast<std::size_t>(group.i[k])];
  const BlockState& sj = state_[static_cast<std::size_t>(group.j[k])];
  const auto four = [&](std::size_t d) {
    return load(std::array<float, kLanes>{group.arm[d][k], group.half_1[d][k], group.half_2[d][k],
                                          group.normal[d][k]});
  };
  const LaneVec start(four(0), four(1), four(2));
  const LaneMask centroid = Lanes([](auto lane) { return lane == 0 ? 1.0 : 0.0; }) > 0.5;
  Motion motion;
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

inline FacetNetwork::Bond FacetNetwork::bond_of(std::size_t f) const {
  const FacetGroup& group = group_of(f);
  const std::size_t k = lane_of(f);
  const double area = group.area[k], bulk = group.bulk[k];
  const double bulk_j = facets_[f].kind == FacetKind::joint ? bulk : 0.0;
  return {{group.shear[k], group.normal_extra[k]},
          at_lane(group.opening_i, k),
          at_lane(group.opening_j, k),
          bulk * area,
          bulk_j * area,
          area / kFacetPoints,
          bulk,
          bulk_j};
}

/// Of slow slip [-]; a mirror has none.
[[gnu::always_inline]] inline double FacetNetwork::residual_friction(std::size_t f) const {
  const FacetName& name = facets_[f];
  return name.kind == FacetKind::mirror ? 0.0 : strengths_[name.joint_class].tan_residual;
}

[[gnu::always_inline]] inline FacetNetwork::Contact FacetNetwork::contact_of(std::size_t f) const {
  const FacetGroup& group = group_of(f);
  const std::size_t k = lane_of(f);
  const LinearClosure<double> bonded{group.shear[k], group.normal_extra[k]};
  return {facets_[f].weight,
          group.area[k] / kFacetPoints,
          {bonded.contact(rock_share(f), shear_over_p_wave_)},
          group.shear[k],
          M_1_PI * group.area[k]};
}

/// m of the two blocks in the present pose.
[[gnu::always_inline]] inline FacetNetwork::Openings FacetNetwork::openings_of(std::size_t f,
                                                                               double scale) const {
  const FacetGroup& group = group_of(f);
  const std::size_t k = lane_of(f);
  const Mat3& ri = state_[static_cast<std::size_t>(group.i[k])].rotation;
  const Mat3& rj = state_[static_cast<std::size_t>(group.j[k])].rotation;
  const auto turned = [&](const Vec3& v) { return Vec3(scale * (ri * v + rj * v)); };
  return {turned(at_lane(group.opening_i, k)), turned(at_lane(group.opening_j, k))};
}

/// What a point carried as it broke.
struct FacetNetwork::Break {
  Vec3 normal, jump, elastic, traction, rate;  // [-], [m], less what it slipped, [Pa], [m/s]
  Openings openings;
  Mat3 axes;  // of the facet
  bool torn;  // turned too far, or slid
};

/// What a point that broke still carries.
struct FacetNetwork::Remnant {
  double held;        // along the normal, not positive [Pa]
  Vec3 shear;         // [Pa]
  Vec3 dropped;       // the rest [Pa]
  Vec3 lost;          // jump that leaves the dilatations [m]
  Cohesion cohesion;  // of a point that softens
  bool slips;         // stays in the dilatations
};

/// Tractions on block i at the points of a facet; block j gets the opposite at the same places,
/// midway between the two sides.
struct FacetNetwork::Pull {
  LaneVec normal, jump, arm;  // arm: from the centre of block i [m]
  LaneVec rate;               // motion of block j's side against block i's [m/s]
  LaneVec traction;           // [Pa]

  explicit Pull(const Motion& motion)
      : normal(motion.normal), jump(motion.jump()), arm(motion.side() + Lanes(0.5) * jump) {}

  void add(int p, const Vec3& t) {
    const auto k = static_cast<std::size_t>(p);
    traction.x[k] += t.x();
    traction.y[k] += t.y();
    traction.z[k] += t.z();
  }

  /// Which points fail if they are bonded; those that slip as they open.
  [[nodiscard]] LaneMask failing(const CoulombStrength<Lanes>& strength,
                                 const LaneMask& slipping) const {
    const Lanes along = dot(normal, traction);
    const Lanes shear_squared = dot(traction, traction) - along * along;
    CoulombStrength<Lanes> left = strength;
    left.tension = choose(slipping, Lanes(0.0), strength.tension);
    return is_point() && left.fails(along, choose(slipping, Lanes(0.0), shear_squared));
  }
};

}  // namespace muckpile
