// SPDX-License-Identifier: GPL-2.0-or-later
// The volume that two convex polyhedra share.
// Scope: what lies within 1e-6 of the size of the second one of its planes counts as outside.
#pragma once

#include <span>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

/// Of `a` with a second one of the size V^(1/3) `size` [m] and these faces [m3].
[[nodiscard]] double shared_volume(const Polyhedron& a, double size,
                                   std::span<const FaceGeometry> faces);

/// All of them.
[[nodiscard]] std::vector<FaceGeometry> face_geometries(const Polyhedron& shape);

}  // namespace muckpile
