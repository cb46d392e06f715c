// SPDX-License-Identifier: GPL-2.0-or-later
// Points spread evenly over a face of a block.
// Scope: a face with n corners gives 4 n points; small faces as many as large ones.
#pragma once

#include <cstddef>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

/// Calls visit(point, area) for the middles of the face's parts.
template <class Visit>
void sample_face(const Polyhedron& shape, std::size_t number, const Visit& visit) {
  const std::vector<int>& face = shape.faces[number];
  const auto corner = [&](std::size_t k) -> const Vec3& {
    return shape.vertices[static_cast<std::size_t>(face[k % face.size()])];
  };
  const Vec3 middle = face_geometry(shape, static_cast<int>(number)).centroid;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3 a = corner(k), b = corner(k + 1);
    const double quarter = 0.125 * (a - middle).cross(b - middle).norm();
    const Vec3 ab = 0.5 * (a + b), am = 0.5 * (a + middle), bm = 0.5 * (b + middle);
    visit(Vec3((a + ab + am) / 3.0), quarter);
    visit(Vec3((b + ab + bm) / 3.0), quarter);
    visit(Vec3((middle + am + bm) / 3.0), quarter);
    visit(Vec3((ab + am + bm) / 3.0), quarter);
  }
}

/// Mean of a function of place over a face; 0 for a face without area.
template <class Value>
double mean_over_face(const Polyhedron& shape, std::size_t number, const Value& value) {
  double sum = 0.0, area = 0.0;
  sample_face(shape, number, [&](const Vec3& at, double part) {
    sum += part * value(at);
    area += part;
  });
  return area > 0.0 ? sum / area : 0.0;
}

}  // namespace muckpile
