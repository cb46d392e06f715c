// SPDX-License-Identifier: GPL-2.0-or-later
// The planes that stand for a surface as a block near it sees it.
// Scope: one plane where the surface is flat, rough or hollow, up to four at edges and corners of
// the rock; the surface is seen from within the rock.
#pragma once

#include <vector>

#include "geometry/surface/surface_index.h"

namespace muckpile {

/// Feet of the perpendiculars from a point in the rock to these planes, none farther than `reach`
/// [m]. Flat faces come out exactly. The planes are fitted by least squares to what of the surface
/// lies within `reach`, with weights that fall from the point outward.
[[nodiscard]] std::vector<Vec3> feet_on_planes(const SurfaceIndex& surface, const Vec3& point,
                                               double reach);

}  // namespace muckpile
