// SPDX-License-Identifier: GPL-2.0-or-later
// A closed polyhedron with planar faces, and its exact mass and face properties.
// Limits: faces are convex polygons (Voronoi faces are); the body itself need not be convex.
#pragma once

#include <vector>

#include "math/types.h"

namespace muckpile {

struct Polyhedron {
  std::vector<Vec3> vertices;           // [m]
  std::vector<std::vector<int>> faces;  // vertex numbers, counter-clockwise seen from outside
};

struct MassProperties {
  double volume = 0.0;           // [m3]
  Vec3 centroid = Vec3::Zero();  // [m]
  Mat3 inertia = Mat3::Zero();   // about the centroid, for unit density [m5]
};

// Exact to rounding: the body is split into tetrahedra with a common apex. A polyhedron with
// inward faces has a negative volume; nothing is thrown, so the sign can be used as a check.
[[nodiscard]] MassProperties mass_properties(const Polyhedron& shape);

struct FaceGeometry {
  double area = 0.0;             // [m2]
  Vec3 centroid = Vec3::Zero();  // [m]
  Vec3 normal = Vec3::Zero();    // unit, outward
  Vec3 axis = Vec3::Zero();      // unit, in the plane: direction of the larger radius of gyration
  double radius1 = 0.0;          // sqrt(second moment of area along axis / area) [m]
  double radius2 = 0.0;          // the same along normal x axis; radius1 >= radius2 [m]
};

// A face without area gets zero area and radii, and some unit normal and axis at right angles.
[[nodiscard]] FaceGeometry face_geometry(const Polyhedron& shape, int face);

// Sum of area * outward normal over all faces [m2]; zero for a closed polyhedron.
[[nodiscard]] Vec3 area_vector_sum(const Polyhedron& shape);

// Keeps the vertices that faces use, in the order of their first use.
void drop_unused_vertices(Polyhedron& shape);

}  // namespace muckpile
