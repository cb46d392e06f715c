// SPDX-License-Identifier: GPL-2.0-or-later
// Coverage and surface deviation of a filling; see the header.
#include "geometry/spheres/filling_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muckpile {
namespace {

constexpr int kPerSide = 20;

/// Outside the nearest sphere > 0, inside < 0 [m].
double distance_from(const std::vector<Sphere>& spheres, const Vec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Sphere& s : spheres) nearest = std::min(nearest, (point - s.centre).norm() - s.radius);
  return nearest;
}

double coverage(const Polyhedron& shape, const std::vector<FaceGeometry>& faces,
                const std::vector<Sphere>& spheres) {
  Vec3 lo = shape.vertices.front(), hi = lo;
  for (const Vec3& v : shape.vertices) {
    lo = lo.cwiseMin(v);
    hi = hi.cwiseMax(v);
  }
  long inside = 0, covered = 0;
  for (int k = 0; k < kPerSide * kPerSide * kPerSide; ++k) {
    const Vec3 share((k % kPerSide + 0.5) / kPerSide, (k / kPerSide % kPerSide + 0.5) / kPerSide,
                     (k / (kPerSide * kPerSide) + 0.5) / kPerSide);
    const Vec3 p = lo + share.cwiseProduct(hi - lo);
    const auto behind = [&](const FaceGeometry& f) { return f.normal.dot(p - f.centroid) <= 0.0; };
    if (!std::all_of(faces.begin(), faces.end(), behind)) continue;
    ++inside;
    covered += distance_from(spheres, p) < 0.0 ? 1 : 0;
  }
  return inside > 0 ? static_cast<double>(covered) / static_cast<double>(inside) : 0.0;
}

/// Integral of the distance over one triangle of the surface [m3]: midpoints of equal triangles.
double deviation_of(const Vec3& a, const Vec3& b, const Vec3& c,
                    const std::vector<Sphere>& spheres) {
  constexpr int kSteps = kPerSide / 2;
  double sum = 0.0;
  const auto add = [&](double i, double j) {
    const Vec3 point = a + i / kSteps * (b - a) + j / kSteps * (c - a);
    sum += std::abs(distance_from(spheres, point));
  };
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps - i; ++j) {
      add(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j < kSteps - 1) add(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
  }
  return 0.5 * (b - a).cross(c - a).norm() * sum / (kSteps * kSteps);
}

}  // namespace

FillingQuality filling_quality(const Polyhedron& shape, const std::vector<Sphere>& spheres) {
  std::vector<FaceGeometry> faces;
  double area = 0.0, deviation = 0.0;
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const FaceGeometry face = face_geometry(shape, static_cast<int>(f));
    if (!(face.area > 0.0)) continue;
    faces.push_back(face);
    area += face.area;
    const std::vector<int>& corners = shape.faces[f];
    const auto corner = [&](std::size_t k) {
      return shape.vertices[static_cast<std::size_t>(corners[k])];
    };
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      deviation += deviation_of(corner(0), corner(k), corner(k + 1), spheres);
    }
  }
  return {coverage(shape, faces, spheres),
          deviation / area / std::cbrt(mass_properties(shape).volume)};
}

}  // namespace muckpile
