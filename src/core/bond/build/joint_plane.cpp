// SPDX-License-Identifier: GPL-2.0-or-later
// Natural joints as planes: which facets lie in one.
// Scope: see the header.
#include "bond/build/joint_plane.h"

#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

/// Coordinates of neighbouring blocks agree to about 1e-11 of their size.
constexpr double kRounding = 1e-6;

bool contains(const JointPlane& plane, const Facet& facet, const Vec3& centroid) {
  const Vec3 normal = plane.normal.normalized(), from = centroid - plane.point;
  return std::abs(normal.dot(from)) < kRounding * std::sqrt(facet.area) &&
         normal.cross(facet.normal).norm() < kRounding && from.norm() <= plane.radius;
}

}  // namespace

Vec3 normal_of_dip(double dip, double dip_direction) {
  return {std::sin(dip) * std::sin(dip_direction), std::sin(dip) * std::cos(dip_direction),
          std::cos(dip)};
}

std::size_t assign_joint_classes(const std::vector<JointPlane>& planes,
                                 const std::vector<Block>& blocks, int first_tag,
                                 std::vector<Facet>& facets) {
  std::size_t count = 0;
  for (Facet& facet : facets) {
    if (facet.kind != FacetKind::joint) continue;
    const auto block = static_cast<std::size_t>(facet.tag_i - first_tag);
    const Vec3 centroid = blocks[block].mass.centroid + facet.arm_i;
    const auto plane = std::find_if(planes.begin(), planes.end(), [&](const JointPlane& p) {
      return contains(p, facet, centroid);
    });
    if (plane == planes.end()) continue;
    facet.joint_class = plane->joint_class;
    ++count;
  }
  return count;
}

}  // namespace muckpile
