// SPDX-License-Identifier: GPL-2.0-or-later
// Point of a triangle that is closest to a place.
// Scope: triangles with an area.
#pragma once

#include <cstddef>

#include "geometry/files/stl_file.h"
#include "math/types.h"

namespace muckpile {

/// Where on its triangle a point lies.
struct TrianglePoint {
  enum class On { face, edge, corner };
  Vec3 at = Vec3::Zero();  ///< [m]
  On on = On::face;
  std::size_t corner = 0;  ///< which one, if it is a corner
};

/// Closest point (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
[[nodiscard]] TrianglePoint closest_on(const StlTriangle& triangle, const Vec3& place);

/// A point of the triangle as one of its corners or edges, if those are within `slack` [m] of it.
[[nodiscard]] TrianglePoint snapped(const StlTriangle& triangle, const Vec3& at, double slack);

/// Angle that the triangle fills around one of its points [rad].
[[nodiscard]] double angle_around(const StlTriangle& triangle, const TrianglePoint& point);

}  // namespace muckpile
