// SPDX-License-Identifier: GPL-2.0-or-later
// Distances and closest points on the finite cylinder of a crushed zone.
// Scope: a point is split into its coordinate along the axis and its vector from the axis.
#include "geometry/holes/hole_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace muckpile {
namespace {

struct AxisCoordinates {
  double along = 0.0;  // from the toe [m]
  Vec3 across;         // from the axis line [m]
};

AxisCoordinates split(const Hole& hole, const Vec3& point) {
  const Vec3 direction = (hole.collar - hole.toe).normalized();
  const double along = (point - hole.toe).dot(direction);
  return {along, point - hole.toe - along * direction};
}

}  // namespace

double hole_length(const Hole& hole) { return (hole.collar - hole.toe).norm(); }

double cylinder_volume(const Hole& hole) {
  return std::numbers::pi * hole.radius * hole.radius * hole_length(hole);
}

bool inside_hole(const Hole& hole, const Vec3& point) {
  const AxisCoordinates at = split(hole, point);
  return at.along >= 0.0 && at.along <= hole_length(hole) && at.across.norm() <= hole.radius;
}

Vec3 closest_on_hole(const Hole& hole, const Vec3& point) {
  const AxisCoordinates at = split(hole, point);
  const Vec3 direction = (hole.collar - hole.toe).normalized();
  const double shrink = std::min(1.0, hole.radius / std::max(at.across.norm(), 1e-300));
  return hole.toe + std::clamp(at.along, 0.0, hole_length(hole)) * direction + shrink * at.across;
}

double enclosed_by_face(const Hole& hole, const FaceGeometry& face) {
  return -0.5 * face.area * face.normal.dot(split(hole, face.centroid).across);
}

std::vector<Vec3> cylinder_samples(const Hole& hole) {
  constexpr int kRings = 8, kAngles = 32, kSlices = 128;
  const Vec3 direction = (hole.collar - hole.toe).normalized();
  const Vec3 e1 = direction.unitOrthogonal(), e2 = direction.cross(e1);
  std::vector<Vec3> samples;
  samples.reserve(kRings * kAngles * kSlices);
  for (int s = 0; s < kSlices; ++s) {
    const Vec3 centre = hole.toe + (s + 0.5) / kSlices * (hole.collar - hole.toe);
    for (int a = 0; a < kAngles; ++a) {
      const double angle = 2.0 * std::numbers::pi * (a + 0.5) / kAngles;
      const Vec3 spoke = hole.radius * (std::cos(angle) * e1 + std::sin(angle) * e2);
      for (int r = 0; r < kRings; ++r) {
        samples.push_back(centre + std::sqrt((r + 0.5) / kRings) * spoke);
      }
    }
  }
  return samples;
}

}  // namespace muckpile
