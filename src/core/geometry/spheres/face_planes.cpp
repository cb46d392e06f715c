// SPDX-License-Identifier: GPL-2.0-or-later
// Planes of faces; see the header.
#include "geometry/spheres/face_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muckpile {
namespace {

double mean_square_size(const Polyhedron& shape) {
  double sum = 0.0;
  for (const Vec3& v : shape.vertices) sum += (v - shape.vertices.front()).squaredNorm();
  return sum / static_cast<double>(shape.vertices.size());
}

// The innermost corner decides, so that a face that is not quite plane stays outside.
double innermost_offset(const Polyhedron& shape, int face, const Vec3& normal) {
  double offset = std::numeric_limits<double>::infinity();
  for (const int v : shape.faces[static_cast<std::size_t>(face)]) {
    offset = std::min(offset, normal.dot(shape.vertices[static_cast<std::size_t>(v)]));
  }
  return offset;
}

}  // namespace

FacePlanes::FacePlanes(const Polyhedron& shape) {
  const double floor_area = 1e-16 * mean_square_size(shape);
  for (int f = 0; f < static_cast<int>(shape.faces.size()); ++f) {
    const FaceGeometry face = face_geometry(shape, f);
    if (face.area <= floor_area) continue;  // a sliver has no direction to speak of
    normals_.push_back(face.normal);
    offsets_.push_back(innermost_offset(shape, f, face.normal));
  }
}

std::pair<double, std::size_t> FacePlanes::nearest(const Vec3& point) const {
  std::pair<double, std::size_t> best(std::numeric_limits<double>::infinity(), 0);
  for (std::size_t k = 0; k < normals_.size(); ++k) {
    const double distance = offsets_[k] - normals_[k].dot(point);
    if (distance < best.first) best = {distance, k};
  }
  return best;
}

double FacePlanes::way_to(double distance, const Vec3& start, const Vec3& way) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < normals_.size(); ++k) {
    const double approach = normals_[k].dot(way);
    if (approach > 0.0)
      least = std::min(least, (offsets_[k] - distance - normals_[k].dot(start)) / approach);
  }
  return least;
}

// Each plane in turn moves the place by what its multiplier, which is never negative, changes
// (Hildreth 1957).
Vec3 FacePlanes::nearest_below(double depth, const Vec3& point) const {
  constexpr int kSweeps = 200;
  constexpr double kRounding = 1e-5;  // of the depth
  std::vector<double> multipliers(normals_.size(), 0.0);
  Vec3 at = point;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double largest = 0.0;
    for (std::size_t k = 0; k < normals_.size(); ++k) {
      const double missing = normals_[k].dot(at) - offsets_[k] + depth;
      const double change = std::max(missing, -multipliers[k]);
      at -= change * normals_[k];
      multipliers[k] += change;
      largest = std::max(largest, std::abs(change));
    }
    if (largest < kRounding * depth) break;
  }
  return at;
}

bool FacePlanes::is_corner(const Vec3& vertex, double size) const {
  constexpr double kRounding = 1e-9, kParallel = 1e-6;  // of the size, radians
  std::vector<Vec3> met;
  for (std::size_t k = 0; k < normals_.size(); ++k) {
    if (std::abs(offsets_[k] - normals_[k].dot(vertex)) > kRounding * size) continue;
    const bool known = std::any_of(met.begin(), met.end(), [&](const Vec3& n) {
      return (n - normals_[k]).norm() < kParallel;
    });
    if (!known) met.push_back(normals_[k]);
  }
  return met.size() > 2;
}

}  // namespace muckpile
