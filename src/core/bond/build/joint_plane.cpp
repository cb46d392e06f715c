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

bool in_a_disc(const JointPlane& plane, const Vec3& centroid) {
  if (plane.centres.empty()) return (centroid - plane.point).norm() <= plane.radius;
  return std::any_of(plane.centres.begin(), plane.centres.end(), [&](const Vec3& centre) {
    return (centroid - centre).norm() <= plane.radius;
  });
}

/// `normal` is the plane's, of length 1.
bool contains(const JointPlane& plane, const Vec3& normal, const Facet& facet,
              const Vec3& centroid) {
  return std::abs(normal.dot(centroid - plane.point)) < kRounding * std::sqrt(facet.area) &&
         normal.cross(facet.normal).norm() < kRounding && in_a_disc(plane, centroid);
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
  std::vector<Vec3> normals;
  for (const JointPlane& plane : planes) normals.push_back(plane.normal.normalized());
  for (Facet& facet : facets) {
    if (facet.kind != FacetKind::joint) continue;
    const auto block = static_cast<std::size_t>(facet.tag_i - first_tag);
    const Vec3 centroid = blocks[block].mass.centroid + facet.arm_i;
    for (std::size_t p = 0; p < planes.size(); ++p) {
      if (!contains(planes[p], normals[p], facet, centroid)) continue;
      facet.joint_class = planes[p].joint_class;
      ++count;
      break;
    }
  }
  return count;
}

}  // namespace muckpile
