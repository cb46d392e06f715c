// SPDX-License-Identifier: GPL-2.0-or-later
// Volume and centroid of a polyhedron, without the inertia that mass_properties() adds.
// Scope: the same numbers as there, to the last bit.
#pragma once

#include "geometry/shape/flat_polyhedron.h"
#include "geometry/shape/polyhedron.h"

namespace muckpile {

struct VolumeAndCentroid {
  double volume = 0.0;  // [m3]
  Vec3 centroid = Vec3::Zero();
};

[[nodiscard]] VolumeAndCentroid volume_and_centroid(const Polyhedron& shape);
[[nodiscard]] VolumeAndCentroid volume_and_centroid(const FlatPolyhedron& shape);

}  // namespace muckpile
