// SPDX-License-Identifier: GPL-2.0-or-later
// What keeps a polyhedron of a file from being a block.
// Scope: one body by itself; to 1e-6 of its size.
#pragma once

#include <string>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

inline constexpr double kShapeRounding = 1e-6;  ///< of V^(1/3): plane, convex and closed to this

/// Goes on behind the name of the body, as "is not closed"; "" of one that has a volume, is closed
/// and convex, and has plane faces. `mass` of that shape.
[[nodiscard]] std::string shape_fault(const Polyhedron& shape, const MassProperties& mass);

}  // namespace muckpile
