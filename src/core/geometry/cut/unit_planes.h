// SPDX-License-Identifier: GPL-2.0-or-later
// Which faces of blocks lie in planes of the cut.
// Scope: planes by unit normal and offset, made once for all faces.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/cut/tessellation.h"
#include "geometry/shape/polyhedron.h"

namespace muckpile {

class UnitPlanes {
 public:
  explicit UnitPlanes(const std::vector<CutPlane>& planes) {
    for (const CutPlane& plane : planes) {
      const Vec3 normal = plane.normal.normalized();
      planes_.push_back({normal, normal.dot(plane.point)});
    }
  }
  /// The face is parallel to one of them and within `rounding` [m] of it.
  [[nodiscard]] bool hold(const FaceGeometry& face, double rounding) const {
    constexpr double kParallel = 1e-7;
    return std::ranges::any_of(planes_, [&](const Plane& plane) {
      return std::abs(plane.normal.dot(face.centroid) - plane.offset) < rounding &&
             plane.normal.cross(face.normal).norm() < kParallel;
    });
  }

 private:
  struct Plane {
    Vec3 normal;
    double offset;  // of the plane along it [m]
  };
  std::vector<Plane> planes_;
};

}  // namespace muckpile
