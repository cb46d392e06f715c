// SPDX-License-Identifier: GPL-2.0-or-later
// How well blocks follow the surfaces that bound their rock.
// Scope: faces with nothing behind that lie on no wall of the box; volumes of rock by columns.
#pragma once

#include <vector>

#include "geometry/block_model.h"
#include "geometry/surface/rock_body.h"

namespace muckpile {

struct SurfaceFit {
  double area = 0.0;              ///< of the faces [m2]
  double mean_offset = 0.0;       ///< positive out of the rock [block sizes]
  double mean_distance = 0.0;     ///< [block sizes]
  double largest_distance = 0.0;  ///< [block sizes]
  double within_a_quarter = 0.0;  ///< share of the area within a quarter block of the surface [-]
};

/// Distances of points of the faces from the nearest surface, over V^(1/3) of the block.
[[nodiscard]] SurfaceFit surface_fit(const std::vector<Block>& blocks,
                                     const std::vector<RockSurface>& surfaces, const Vec3& lo,
                                     const Vec3& hi);

/// Of the rock in the box that all surfaces and the region hold [m3]. Columns are exact in height
/// without a region; `columns` to each side.
[[nodiscard]] double rock_volume(const std::vector<RockSurface>& surfaces,
                                 const RegionQuery& region, const Vec3& lo, const Vec3& hi,
                                 int columns);

}  // namespace muckpile
