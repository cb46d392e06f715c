// SPDX-License-Identifier: GPL-2.0-or-later
// The planes of a convex block's faces: how deep a place lies below them.
// Scope: convex polyhedra; lengths in metres.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

/// Half spaces n.x <= d.
class FacePlanes {
 public:
  explicit FacePlanes(const Polyhedron& shape);

  /// Distance to the nearest face, negative outside [m], and that face.
  [[nodiscard]] std::pair<double, std::size_t> nearest(const Vec3& point) const;
  [[nodiscard]] double clearance(const Vec3& point) const { return nearest(point).first; }
  /// How far along a way from `start` the clearance falls to a distance [-].
  [[nodiscard]] double way_to(double distance, const Vec3& start, const Vec3& way) const;
  /// Of all places `depth` [m] below every face the nearest to a point, by iteration: where the
  /// clearance is less than `depth`, it has not converged, or there is no such place.
  [[nodiscard]] Vec3 nearest_below(double depth, const Vec3& point) const;
  [[nodiscard]] const Vec3& normal(std::size_t plane) const { return normals_[plane]; }
  /// Whether faces of three directions meet at a vertex: where a face is divided among several
  /// blocks behind it, it has vertices that are no corners of the body.
  [[nodiscard]] bool is_corner(const Vec3& vertex, double size) const;

 private:
  std::vector<Vec3> normals_;
  std::vector<double> offsets_;  // [m]
};

}  // namespace muckpile
