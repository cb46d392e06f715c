// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where facets hold at every point: eight of them at once.
// Scope: dilatations and forces of intact facets, as facet_bond.cpp works them out one by
// one. A facet takes this path or that by its own state alone, never by those beside it in its
// group, and blocks get their parts in the order of the facets: both are the same on any ranks.
#include <algorithm>
#include <array>
#include <cmath>
#include <experimental/simd>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

#include "bond/facet_lanes.h"
#include "bond/facet_network.h"

namespace muckpile {
namespace {

using Wide = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, kGroup>>;
using WideVec = VectorOf<Wide>;

template <class T>
[[gnu::always_inline]] inline Wide wide(const FacetRow<T>& row) {
  return {row.data(), std::experimental::element_aligned};
}
template <class T>
[[gnu::always_inline]] inline WideVec wide(const FacetRows<T>& rows) {
  return {wide(rows[0]), wide(rows[1]), wide(rows[2])};
}
[[gnu::always_inline]] inline void store(const WideVec& v, FacetRows<double>& to) {
  v.x.copy_to(to[0].data(), std::experimental::element_aligned);
  v.y.copy_to(to[1].data(), std::experimental::element_aligned);
  v.z.copy_to(to[2].data(), std::experimental::element_aligned);
}

/// from[place] of each facet. GCC 12 does not make the processor's own gather of it: 10 % of a
/// pass.
[[gnu::always_inline]] inline Wide gather(const FacetRow<std::int32_t>& places,
                                          const double* from) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
  if constexpr (sizeof(Wide) == sizeof(__m512d)) {
    const __m256i at = _mm256_load_si256(reinterpret_cast<const __m256i*>(places.data()));
    return Wide(_mm512_i32gather_pd(at, from, sizeof(double)));
  }
#endif
  return Wide([&](auto lane) { return from[places[lane]]; });
}

/// A number of each facet's block.
template <class Of>
[[gnu::always_inline]] inline Wide gather(const FacetRow<std::int32_t>& blocks, const Of& of) {
  return Wide([&](auto lane) { return of(static_cast<std::size_t>(blocks[lane])); });
}

struct WideMat {
  WideVec x, y, z;  // columns

  [[gnu::always_inline]] WideVec operator*(const WideVec& v) const {
    return v.x * x + v.y * y + v.z * z;
  }
  /// Of the transposed matrix.
  [[gnu::always_inline]] WideVec back(const WideVec& v) const {
    return {dot(x, v), dot(y, v), dot(z, v)};
  }
};

/// Where the states of a group's blocks lie, in numbers after that of the first block.
class BlockPlaces {
 public:
  [[gnu::always_inline]] explicit BlockPlaces(const FacetRow<std::int32_t>& blocks) {
    static_assert(sizeof(BlockState) % sizeof(double) == 0);
    constexpr int kNumbers = sizeof(BlockState) / sizeof(double);
    for (std::size_t k = 0; k < kGroup; ++k) at_[k] = kNumbers * blocks[k];
  }
  /// `first` is that of the first block.
  [[gnu::always_inline]] WideVec vector(const Vec3& first) const { return vector(first.data()); }
  [[gnu::always_inline]] WideMat matrix(const Mat3& first) const {
    const double* from = first.data();
    return {vector(from), vector(from + 3), vector(from + 6)};
  }

 private:
  [[gnu::always_inline]] WideVec vector(const double* from) const {
    return {gather(at_, from), gather(at_, from + 1), gather(at_, from + 2)};
  }
  alignas(64) FacetRow<std::int32_t> at_;
};

}  // namespace

/// How the two sides of each facet of a group lie now.
struct FacetNetwork::WidePose {
  WideMat sum, difference;  // of the rotations of i and j; of j less that of i
  WideVec between;          // centre of j less that of i [m]
  WideVec near, jump;       // centroid from the centre of i; from the side of i to that of j [m]
  WideVec normal;           // unit, mean of both sides
  Wide scale;               // that makes the sum of the normals of both sides a unit vector
};

unsigned FacetNetwork::whole_lanes(std::size_t group) const {
  const std::size_t first = group * kGroup;
  unsigned lanes = 0;
  for (std::size_t k = 0; k < kGroup && first + k < bonded_points_.size(); ++k)
    lanes |= (bonded_points_[first + k] == kFacetPoints ? 1u : 0u) << k;
  return lanes;
}

[[gnu::always_inline]] inline FacetNetwork::WidePose FacetNetwork::pose_of(
    const FacetGroup& group) const {
  const BlockPlaces at_i(group.i), at_j(group.j);
  const BlockState& first = state_.front();
  const WideMat ri = at_i.matrix(first.rotation), rj = at_j.matrix(first.rotation);
  WidePose pose;
  pose.sum = {ri.x + rj.x, ri.y + rj.y, ri.z + rj.z};
  pose.difference = {rj.x - ri.x, rj.y - ri.y, rj.z - ri.z};
  pose.between = at_j.vector(first.centre) - at_i.vector(first.centre);
  pose.near = ri * wide(group.arm);
  pose.jump = rj * wide(group.arm_j) - pose.near + pose.between;
  const WideVec both = pose.sum * wide(group.normal);
  pose.scale = 1.0 / sqrt(dot(both, both));
  pose.normal = pose.scale * both;
  return pose;
}

/// The parts of facets in the dilatations of their blocks.
void FacetNetwork::open_group(const LaneSet& bonded) {
  const unsigned whole = bonded.lanes & whole_lanes(bonded.group);
  const FacetGroup& group = groups_[bonded.group];
  alignas(64) FacetRow<double> of_i{}, of_j{};
  if (whole != 0) {
    const WidePose pose = pose_of(group);
    const WideVec turned_back = pose.sum.back(pose.jump);
    const Wide share = wide(group.area) * wide(group.bulk) * pose.scale;
    (share * dot(wide(group.opening_i), turned_back))
        .copy_to(of_i.data(), std::experimental::element_aligned);
    (share * dot(wide(group.opening_j), turned_back))
        .copy_to(of_j.data(), std::experimental::element_aligned);
  }
  for (std::size_t k = 0; k < kGroup; ++k) {
    if ((whole >> k & 1u) != 0) {
      sums_[static_cast<std::size_t>(group.i[k])].bonded += of_i[k];
      sums_[static_cast<std::size_t>(group.j[k])].bonded += of_j[k];
    } else if (bonded.has(k) && bonded_points_[bonded.group * kGroup + k] > 0) {
      open_facet(bonded.group * kGroup + k);
    }
  }
}

/// A number that is linear over each facet: its mean, and what it gains along the half axes.
struct FacetNetwork::WideField {
  WideVec mean, along_1, along_2;

  [[gnu::always_inline]] WideVec at(std::size_t p) const {
    return mean + Wide(kOnFirst[p]) * along_1 + Wide(kOnSecond[p]) * along_2;
  }
};

[[gnu::always_inline]] inline FacetNetwork::WideField FacetNetwork::pull_of(
    const FacetGroup& group, const WidePose& pose) const {
  const Wide shear = wide(group.shear), extra = wide(group.normal_extra);
  const auto pull = [&](const WideVec& jump) {
    return shear * jump + extra * dot(pose.normal, jump) * pose.normal;
  };
  const auto stress = [&](std::size_t b) { return bulk_stress_[b]; };
  const WideVec squeezed = gather(group.i, stress) * wide(group.opening_i) +
                           gather(group.j, stress) * wide(group.opening_j);
  return {pull(pose.jump) + wide(group.bulk) * pose.scale * (pose.sum * squeezed),
          pull(pose.difference * wide(group.half_1)), pull(pose.difference * wide(group.half_2))};
}

/// Lanes that have turned so far that they do not hold on by a last point (Motion::turned).
[[gnu::always_inline]] inline auto FacetNetwork::torn(const FacetGroup& group,
                                                      const WidePose& pose) {
  const WideVec half_1 = wide(group.half_1), half_2 = wide(group.half_2);
  const WideVec apart_1 = pose.difference * half_1, apart_2 = pose.difference * half_2;
  const Wide length_1 = dot(half_1, half_1), length_2 = dot(half_2, half_2);
  return dot(apart_1, apart_1) * length_2 + dot(apart_2, apart_2) * length_1 >
         Wide(kTurnStart * kTurnStart) * length_1 * length_2;
}

/// Those of `lanes` of which no point fails.
[[gnu::always_inline]] inline unsigned FacetNetwork::holding(std::size_t g, unsigned lanes,
                                                             const WidePose& pose,
                                                             const WideField& pull) const {
  FacetRow<double> tension{}, cohesion{}, tan_friction{};
  for (std::size_t k = 0; k < kGroup; ++k) {
    const std::size_t f = std::min(g * kGroup + k, facets_.size() - 1);
    const Strength& strength = strengths_[facets_[f].joint_class];
    tension[k] = strength.tension;
    cohesion[k] = strength.cohesion;
    tan_friction[k] = strength.tan_friction;
  }
  typename Wide::mask_type fails = torn(groups_[g], pose);
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const WideVec traction = pull.at(p);
    const Wide across = dot(pose.normal, traction);
    fails = fails || joint_fails(across, Wide(dot(traction, traction) - across * across),
                                 wide(tension), wide(cohesion), wide(tan_friction));
  }
  for (std::size_t k = 0; k < kGroup; ++k)
    if (fails[k]) lanes &= ~(1u << k);
  return lanes;
}

/// Adds the dashpots of the joints, and what they take to `forces`.
[[gnu::always_inline]] inline void FacetNetwork::damp_group(std::size_t g, const WidePose& pose,
                                                            WideField& pull, double dt,
                                                            WideForces& forces) const {
  const FacetGroup& group = groups_[g];
  FacetRow<double> dashpot;
  dashpot.fill(damping_);
  if (!yielding_.empty()) {  // that ground has a dashpot itself
    for (std::size_t k = 0, f = g * kGroup; k < kGroup && f < facets_.size(); ++k, ++f)
      if (facets_[f].kind != FacetKind::joint && memory_[f].ground().yields) dashpot[k] = 0.0;
  }
  const BlockPlaces at_i(group.i), at_j(group.j);
  const BlockState& first = state_.front();
  const WideVec spin_j = at_j.vector(first.spin), spin = spin_j - at_i.vector(first.spin);
  const WideVec slip = at_j.vector(first.velocity) - at_i.vector(first.velocity);
  const WideVec arm = pose.near + Wide(0.5) * pose.jump;
  const Wide half(0.5);
  const WideField rate = {slip - cross(spin_j, pose.between) + cross(spin, arm),
                          half * cross(spin, pose.sum * wide(group.half_1)),
                          half * cross(spin, pose.sum * wide(group.half_2))};
  const Wide c = wide(dashpot);
  pull.mean += c * rate.mean;
  pull.along_1 += c * rate.along_1;
  pull.along_2 += c * rate.along_2;
  // Of the squares of the weights of three points each half axis has 3/2, their products nothing.
  const Wide squares = dot(rate.mean, rate.mean) +
                       half * (dot(rate.along_1, rate.along_1) + dot(rate.along_2, rate.along_2));
  (Wide(dt) * c * wide(group.area) * squares)
      .copy_to(forces.damped.data(), std::experimental::element_aligned);
}

/// Forces of those of `lanes` of which no point fails; returns which.
unsigned FacetNetwork::hold_group(std::size_t g, unsigned lanes, double dt,
                                  WideForces& forces) const {
  const FacetGroup& group = groups_[g];
  const WidePose pose = pose_of(group);
  WideField pull = pull_of(group, pose);
  if (slanted()) {
    const auto slant = [&](Eigen::Index d) {
      return Wide([&](auto lane) { return slant_traction_[g * kGroup + lane][d]; });
    };
    pull.mean += WideVec(slant(0), slant(1), slant(2));
  }
  lanes = holding(g, lanes, pose, pull);
  if (damping_ != 0.0) damp_group(g, pose, pull, dt, forces);
  const Wide area = wide(group.area);
  const WideVec arm = pose.near + Wide(0.5) * pose.jump;
  const WideVec turning = cross(pose.sum * wide(group.half_1), pull.along_1) +
                          cross(pose.sum * wide(group.half_2), pull.along_2);
  const WideVec force = area * pull.mean;
  const WideVec moment = cross(arm, force) + Wide(0.25) * area * turning;
  store(force, forces.force);
  store(moment, forces.torque_i);
  store(cross(pose.between, force) - moment, forces.torque_j);
  return lanes;
}

[[gnu::always_inline]] inline void FacetNetwork::add_forces(const FacetGroup& group, std::size_t k,
                                                            const WideForces& forces) {
  const auto i = static_cast<std::size_t>(group.i[k]), j = static_cast<std::size_t>(group.j[k]);
  const Vec3 force = at_lane(forces.force, k);
  force_[i] += force;
  torque_[i] += at_lane(forces.torque_i, k);
  force_[j] -= force;
  torque_[j] += at_lane(forces.torque_j, k);
}

/// What broken facets remember lies where they broke, not side by side: waiting for it took longer
/// than working with it.
void FacetNetwork::fetch_contacts(const LaneSet& working) const {
  for (unsigned left = working.lanes; left != 0; left &= left - 1) {
    const std::size_t f = working.group * kGroup + static_cast<std::size_t>(std::countr_zero(left));
    if (asleep_[f] <= calls_) memory_[f].contact.fetch();
  }
}

void FacetNetwork::work_group(const LaneSet& working, double dt) {
  WideForces forces;
  unsigned held = working.lanes & whole_lanes(working.group);
  if (held != 0) held = hold_group(working.group, held, dt, forces);
  for (unsigned left = working.lanes; left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    const std::size_t f = working.group * kGroup + k;
    if ((held >> k & 1u) != 0) {
      add_forces(groups_[working.group], k, forces);
      if (damping_ != 0.0) losses_.damping += facets_[f].weight * forces.damped[k];
    } else if (states_[f] != FacetState::retired && asleep_[f] <= calls_) {
      work_facet(f, dt);
    }
  }
}

}  // namespace muckpile
