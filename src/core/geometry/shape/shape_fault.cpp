// SPDX-License-Identifier: GPL-2.0-or-later
// What keeps a polyhedron of a file from being a block.
// Scope: see the header.
#include "geometry/shape/shape_fault.h"

#include <cmath>

#include "geometry/shape/convex_cell.h"

namespace muckpile {

std::string shape_fault(const Polyhedron& shape, const MassProperties& mass) {
  for (const Vec3& v : shape.vertices)
    if (!v.allFinite()) return "has a corner that is not at finite numbers";
  if (!(mass.volume > 0.0)) return "must be closed and have a volume > 0 m3";
  const double size = std::cbrt(mass.volume), slack = kShapeRounding * size;
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const FaceGeometry face = face_geometry(shape, static_cast<int>(f));
    if (face.area < slack * size) continue;  // no direction to speak of
    for (const int v : shape.faces[f]) {
      const Vec3& at = shape.vertices[static_cast<std::size_t>(v)];
      if (std::abs(face.normal.dot(at - face.centroid)) > slack)
        return "is not plane at its face " + std::to_string(f + 1);
    }
    if (extent(shape, face.normal).second - face.normal.dot(face.centroid) > slack)
      return "is not convex at its face " + std::to_string(f + 1);
  }
  return area_vector_sum(shape).norm() > slack * size ? "is not closed" : "";
}

}  // namespace muckpile
