// SPDX-License-Identifier: GPL-2.0-or-later
// Parts cells by surfaces from files, to which planes are fitted as wide as a cell.
// Scope: the planes of surface_planes.h, as a Voronoi cut has them; each moves until it lies on the
// surface in the mean.
#pragma once

#include <optional>
#include <vector>

#include "geometry/cut/tessellation.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile {

/// The rock of a cell of about a block's size.
struct FittedPart {
  bool is_rock = true;             ///< false: there is none
  ConvexCell cell{};               ///< what the planes leave
  std::vector<CutPlane> planes{};  ///< in the order in which they part the cell; normals look out
};

/// Whether 3 V / A is below a hundredth of a size [m]: rounding beside a block, of which no cell
/// can be made.
[[nodiscard]] bool is_film(const ConvexCell& cell, double size);

/// Whether a fitted surface comes as near to a cell's middle as its farthest corner.
[[nodiscard]] bool is_near_fitted(const RegionQuery& region, const ConvexCell& cell);

/// `size`: of a block there [m].
[[nodiscard]] FittedPart rock_part(const RegionQuery& region, const ConvexCell& cell, double size);

/// The plane of a flat piece of a fitted surface that passes through a cell of any size and
/// nowhere in it through rock; of several the one whose smaller part is largest. Rock cut along it
/// first has no slivers there.
[[nodiscard]] std::optional<CutPlane> flat_fitted_through(const RegionQuery& region,
                                                          const ConvexCell& cell);

}  // namespace muckpile
