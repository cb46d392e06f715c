// SPDX-License-Identifier: GPL-2.0-or-later
// The volume that two convex polyhedra share: one of them, cut by the planes of the other.
// Scope: see the header.
#include "geometry/shape/shared_volume.h"

#include <utility>

#include "geometry/shape/convex_cell.h"

namespace muckpile {

double shared_volume(const Polyhedron& a, double size, std::span<const FaceGeometry> faces) {
  constexpr double kShape = 1e-6;
  ConvexCell rest{a, std::vector<int>(a.faces.size(), -1)};
  for (const FaceGeometry& face : faces) {
    if (face.area < kShape * size * size) continue;  // no direction to speak of
    const auto [lowest, highest] = extent(rest.shape, face.normal);
    const double plane = face.normal.dot(face.centroid);
    if (lowest > plane - kShape * size) return 0.0;
    if (highest <= plane) continue;
    if (auto halves = divided(rest, face.centroid, face.normal, -1))
      rest = std::move(halves->below);
  }
  return volume_of(rest);
}

std::vector<FaceGeometry> face_geometries(const Polyhedron& shape) {
  std::vector<FaceGeometry> faces;
  for (std::size_t f = 0; f < shape.faces.size(); ++f)
    faces.push_back(face_geometry(shape, static_cast<int>(f)));
  return faces;
}

}  // namespace muckpile
