// SPDX-License-Identifier: GPL-2.0-or-later
// A convex polyhedron that planes divide in two, again and again, and that remembers which plane
// made which of its faces.
// Scope: one cell at a time; what lies on a plane to 1e-10 of the cell counts as lying in it.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

struct ConvexCell {
  Polyhedron shape;
  std::vector<int> made_by;  // per face: number of the dividing plane, negative for box walls
};

/// The box from lo to hi; its faces are made by -1.
[[nodiscard]] ConvexCell box_cell(const Vec3& lo, const Vec3& hi);

struct HalfCells {
  ConvexCell below, above;  // against and along the plane's normal
};

/// None if the plane does not pass through the cell. `normal` is a unit vector.
[[nodiscard]] std::optional<HalfCells> divided(const ConvexCell& cell, const Vec3& point,
                                               const Vec3& normal, int number);

/// The same cell on the lower side of a plane; none if nothing is there.
[[nodiscard]] std::optional<ConvexCell> part_below(ConvexCell cell, const Vec3& point,
                                                   const Vec3& normal, int number);

[[nodiscard]] double volume_of(const ConvexCell& cell);    // [m3]
[[nodiscard]] Vec3 centroid_of(const ConvexCell& cell);    // [m]
[[nodiscard]] double surface_of(const Polyhedron& shape);  // [m2]

/// 3 V / A: between the radius of the largest sphere inside a convex body and three times that; s/2
/// of a cube of edge s, 3t/2 of a plate of thickness t [m].
[[nodiscard]] double mean_radius(const Polyhedron& shape);

/// Least and greatest n.x of the corners [m].
[[nodiscard]] std::pair<double, double> extent(const Polyhedron& shape, const Vec3& normal);

}  // namespace muckpile
