// SPDX-License-Identifier: GPL-2.0-or-later
// Finds planes that part a cell into rock and what lies outside the region.
// Scope: a surface is seen from the cell's middle and corners; features narrower than a cell that
// none of them sees are missed.
#pragma once

#include <optional>
#include <vector>

#include "geometry/cut/tessellation.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile {

/// Of the corner that is farthest from a point [m].
[[nodiscard]] double reach_of(const ConvexCell& cell, const Vec3& middle);

/// Points to look from: the middle, and places between it and the corners.
[[nodiscard]] std::vector<Vec3> lookouts(const ConvexCell& cell, const Vec3& middle);

/// Which surfaces a cell is parted by: flat ones only, or curved ones by a tangent plane too.
enum class SurfaceKind { flat, any };

/// The plane whose smaller part is largest; its normal looks out of the rock or into it. None if no
/// plane has rock on one side and none on the other.
[[nodiscard]] std::optional<CutPlane> surface_through(const RegionQuery& region,
                                                      const ConvexCell& cell, SurfaceKind kind);

/// Whether no surface is within the cell's reach and its middle is not in the region.
[[nodiscard]] bool is_far_outside(const RegionQuery& region, const ConvexCell& cell);

}  // namespace muckpile
