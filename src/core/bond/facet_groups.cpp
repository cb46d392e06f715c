// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where facets hold at every point: eight of them at once.
// Scope: dilatations and forces of intact, undamped facets, as facet_bond.cpp works them out one by
// one. A facet takes this path or that by its own state alone, never by those beside it in its
// group, and blocks get their parts in the order of the facets: both are the same on any ranks.
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

}  // namespace

/// How the two sides of each facet of a group lie now.
struct FacetNetwork::WidePose {
  WideMat sum, difference;  // of the rotations of i and j; of j less that of i
  WideVec between;          // centre of j less that of i [m]
  WideVec near, jump;       // centroid from the centre of i; from the side of i to that of j [m]
  WideVec both;             // sum of the normals of both sides
  Wide scale;               // that makes it a unit vector
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
  static_assert(sizeof(BlockState) % sizeof(double) == 0);
  constexpr int kNumbers = sizeof(BlockState) / sizeof(double);
  const auto places = [](const FacetRow<std::int32_t>& blocks) {
    alignas(64) FacetRow<std::int32_t> at;
    for (std::size_t k = 0; k < kGroup; ++k) at[k] = kNumbers * blocks[k];
    return at;
  };
  alignas(64) const FacetRow<std::int32_t> at_i = places(group.i), at_j = places(group.j);
  const auto vector = [](const FacetRow<std::int32_t>& at, const double* from) {
    return WideVec(gather(at, from), gather(at, from + 1), gather(at, from + 2));
  };
  const auto rotation = [&](const FacetRow<std::int32_t>& at) {
    const double* from = state_.front().rotation.data();
    return WideMat{vector(at, from), vector(at, from + 3), vector(at, from + 6)};
  };
  const double* centre = state_.front().centre.data();
  const WideMat ri = rotation(at_i), rj = rotation(at_j);
  WidePose pose;
  pose.sum = {ri.x + rj.x, ri.y + rj.y, ri.z + rj.z};
  pose.difference = {rj.x - ri.x, rj.y - ri.y, rj.z - ri.z};
  pose.between = vector(at_j, centre) - vector(at_i, centre);
  pose.near = ri * wide(group.arm);
  pose.jump = rj * wide(group.arm_j) - pose.near + pose.between;
  pose.both = pose.sum * wide(group.normal);
  const Wide squared = dot(pose.both, pose.both);
  pose.scale = 1.0 / sqrt(squared);
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

/// Forces of those of `lanes` of which no point fails; returns which.
unsigned FacetNetwork::hold_group(std::size_t g, unsigned lanes, WideForces& forces) const {
  const FacetGroup& group = groups_[g];
  const WidePose pose = pose_of(group);
  const WideVec normal = pose.scale * pose.both;
  const Wide shear = wide(group.shear), extra = wide(group.normal_extra);
  const auto pull = [&](const WideVec& jump) {
    return shear * jump + extra * dot(normal, jump) * normal;
  };
  const auto stress = [&](std::size_t b) { return bulk_stress_[b]; };
  const WideVec squeezed = gather(group.i, stress) * wide(group.opening_i) +
                           gather(group.j, stress) * wide(group.opening_j);
  const WideVec mean = pull(pose.jump) + wide(group.bulk) * pose.scale * (pose.sum * squeezed);
  // Both jump and arm are linear over the facet: their parts along the half axes.
  const WideVec half_1 = wide(group.half_1), half_2 = wide(group.half_2);
  const WideVec along_1 = pull(pose.difference * half_1), along_2 = pull(pose.difference * half_2);

  FacetRow<double> tension{}, cohesion{}, tan_friction{};
  for (std::size_t k = 0; k < kGroup; ++k) {
    const std::size_t f = std::min(g * kGroup + k, facets_.size() - 1);
    const Strength& strength = strengths_[facets_[f].joint_class];
    tension[k] = strength.tension;
    cohesion[k] = strength.cohesion;
    tan_friction[k] = strength.tan_friction;
  }
  typename Wide::mask_type fails(false);
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const WideVec traction = mean + Wide(kOnFirst[p]) * along_1 + Wide(kOnSecond[p]) * along_2;
    const Wide across = dot(normal, traction);
    fails = fails || joint_fails(across, Wide(dot(traction, traction) - across * across),
                                 wide(tension), wide(cohesion), wide(tan_friction));
  }
  const Wide area = wide(group.area);
  const WideVec arm = pose.near + Wide(0.5) * pose.jump;
  const WideVec turning = cross(pose.sum * half_1, along_1) + cross(pose.sum * half_2, along_2);
  const WideVec force = area * mean;
  const WideVec moment = cross(arm, force) + Wide(0.25) * area * turning;
  store(force, forces.force);
  store(moment, forces.torque_i);
  store(cross(pose.between, force) - moment, forces.torque_j);
  for (std::size_t k = 0; k < kGroup; ++k)
    if (fails[k]) lanes &= ~(1u << k);
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
  unsigned held = damping_ == 0.0 ? working.lanes & whole_lanes(working.group) : 0;
  if (held != 0) held = hold_group(working.group, held, forces);
  for (unsigned left = working.lanes; left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    const std::size_t f = working.group * kGroup + k;
    if ((held >> k & 1u) != 0) {
      add_forces(groups_[working.group], k, forces);
    } else if (states_[f] != FacetState::retired && asleep_[f] <= calls_) {
      work_facet(f, dt);
    }
  }
}

}  // namespace muckpile
