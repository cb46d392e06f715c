// SPDX-License-Identifier: GPL-2.0-or-later
// Spheres inside a block that stand for its shape in contact after its joints have broken.
// Limits: convex polyhedra; mass and inertia never come from these spheres.
#pragma once

#include <vector>

#include "geometry/shape/polyhedron.h"
#include "state/encoding.h"

namespace muckpile {

struct Sphere {
  Vec3 centre = Vec3::Zero();  // [m]
  double radius = 0.0;         // [m]
};
template <>
struct Stored<Sphere> {
  static constexpr std::string_view kName = "sphere";
  static constexpr int kVersion = 1;
  static auto fields(auto& sphere) { return std::tie(sphere.centre, sphere.radius); }
};

// `count` spheres (>= 1), each inside the polyhedron; the first one is the largest inscribed
// sphere (to about 1 %), the others go to the corners with half its radius, or a quarter when there
// are more spheres than corners. `centroid` is the polyhedron's. Same input, same spheres.
// Throws InputError if count < 1.
[[nodiscard]] std::vector<Sphere> fill_with_spheres(const Polyhedron& shape, const Vec3& centroid,
                                                    int count);

}  // namespace muckpile
