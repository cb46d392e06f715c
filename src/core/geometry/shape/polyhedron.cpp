// SPDX-License-Identifier: GPL-2.0-or-later
// Exact integrals over polyhedra and their faces from simplex formulas.
// Scope: a linear tetrahedron with vertices v_k has the second moment
//   V/20 (sum v_k v_k^T + (sum v_k)(sum v_k)^T), a triangle A/12 (...); both are exact.
#include "geometry/shape/polyhedron.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "geometry/shape/centroid.h"

namespace muckpile {
namespace {

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return points.empty() ? sum : Vec3(sum / static_cast<double>(points.size()));
}

// Into `points`, whose memory is used again.
void take_face_points(std::span<const Vec3> vertices, std::span<const int> face,
                      std::vector<Vec3>& points) {
  points.clear();
  for (const int v : face) points.push_back(vertices[static_cast<std::size_t>(v)]);
}

// Calls visit(a, b, c) for the triangles of every face, fanned about the mean of its vertices.
template <class Shape, class Visitor>
void for_each_triangle(const Shape& shape, Visitor visit) {
  std::vector<Vec3> points;
  for (const std::span<const int> face : shape.faces) {
    take_face_points(shape.vertices, face, points);
    const Vec3 middle = mean_of(points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      visit(middle, points[k], points[(k + 1) % points.size()]);
    }
  }
}

struct FirstMoments {
  double volume = 0.0;
  Vec3 moment = Vec3::Zero();
};

template <class Shape>
FirstMoments first_moments(const Shape& shape, const Vec3& apex) {
  FirstMoments sum;
  for_each_triangle(shape, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const double volume = (a - apex).dot((b - apex).cross(c - apex)) / 6.0;
    sum.volume += volume;
    sum.moment += volume / 4.0 * ((a - apex) + (b - apex) + (c - apex));
  });
  return sum;
}

Mat3 second_moment(const Polyhedron& shape, const Vec3& apex) {
  Mat3 sum = Mat3::Zero();
  for_each_triangle(shape, [&](const Vec3& pa, const Vec3& pb, const Vec3& pc) {
    const Vec3 a = pa - apex, b = pb - apex, c = pc - apex, s = a + b + c;
    const double volume = a.dot(b.cross(c)) / 6.0;
    sum += volume / 20.0 *
           (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  });
  return sum;
}

Vec3 any_normal_to(const Vec3& unit) {
  Eigen::Index smallest = 0;
  unit.cwiseAbs().minCoeff(&smallest);
  return unit.cross(Vec3::Unit(smallest)).normalized();
}

// Fills axis and radii of gyration from the in-plane second moments about the centroid [m4].
void principal_axes(const std::vector<Vec3>& points, FaceGeometry& face) {
  const Vec3 e1 = any_normal_to(face.normal), e2 = face.normal.cross(e1);
  double m11 = 0.0, m22 = 0.0, m12 = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 a = points[k] - face.centroid;
    const Vec3 b = points[(k + 1) % points.size()] - face.centroid;
    const double area = 0.5 * face.normal.dot(a.cross(b));
    const double a1 = a.dot(e1), a2 = a.dot(e2), b1 = b.dot(e1), b2 = b.dot(e2);
    m11 += area / 6.0 * (a1 * a1 + b1 * b1 + a1 * b1);
    m22 += area / 6.0 * (a2 * a2 + b2 * b2 + a2 * b2);
    m12 += area / 12.0 * (2.0 * (a1 * a2 + b1 * b2) + a1 * b2 + a2 * b1);
  }
  const double mean = 0.5 * (m11 + m22), half_gap = std::hypot(0.5 * (m11 - m22), m12);
  const double angle = 0.5 * std::atan2(2.0 * m12, m11 - m22);
  face.axis = std::cos(angle) * e1 + std::sin(angle) * e2;
  face.radius1 = std::sqrt(std::max(0.0, mean + half_gap) / face.area);
  face.radius2 = std::sqrt(std::max(0.0, mean - half_gap) / face.area);
}

template <class Shape>
VolumeAndCentroid exact_first(const Shape& shape) {
  const Vec3 start = mean_of(shape.vertices);
  const FirstMoments first = first_moments(shape, start);
  return {first.volume, first.volume != 0.0 ? Vec3(start + first.moment / first.volume) : start};
}

}  // namespace

VolumeAndCentroid volume_and_centroid(const Polyhedron& shape) { return exact_first(shape); }

VolumeAndCentroid volume_and_centroid(const FlatPolyhedron& shape) { return exact_first(shape); }

MassProperties mass_properties(const Polyhedron& shape) {
  MassProperties mass;
  const VolumeAndCentroid first = volume_and_centroid(shape);
  mass.volume = first.volume;
  mass.centroid = first.centroid;
  const Mat3 second = second_moment(shape, mass.centroid);
  mass.inertia = second.trace() * Mat3::Identity() - second;
  return mass;
}

FaceGeometry face_geometry(const Polyhedron& shape, int face_number) {
  std::vector<Vec3> points;
  take_face_points(shape.vertices, shape.faces[static_cast<std::size_t>(face_number)], points);
  FaceGeometry face;
  face.centroid = mean_of(points);
  Vec3 area_vector = Vec3::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    area_vector +=
        0.5 * (points[k] - face.centroid).cross(points[(k + 1) % points.size()] - face.centroid);
  }
  face.area = area_vector.norm();
  if (!(face.area > 0.0)) {
    face.area = 0.0;
    face.normal = Vec3::UnitZ();
    face.axis = Vec3::UnitX();
    return face;
  }
  face.normal = area_vector / face.area;
  Vec3 shift = Vec3::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 a = points[k] - face.centroid;
    const Vec3 b = points[(k + 1) % points.size()] - face.centroid;
    shift += 0.5 * face.normal.dot(a.cross(b)) * (a + b) / 3.0;
  }
  face.centroid += shift / face.area;
  principal_axes(points, face);
  return face;
}

Vec3 area_vector_sum(const Polyhedron& shape) {
  Vec3 sum = Vec3::Zero();
  for_each_triangle(shape, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    sum += 0.5 * (b - a).cross(c - a);
  });
  return sum;
}

void drop_unused_vertices(Polyhedron& shape) {
  std::vector<int> renumbered(shape.vertices.size(), -1);
  std::vector<Vec3> kept;
  for (std::vector<int>& face : shape.faces) {
    for (int& v : face) {
      int& number = renumbered[static_cast<std::size_t>(v)];
      if (number < 0) {
        number = static_cast<int>(kept.size());
        kept.push_back(shape.vertices[static_cast<std::size_t>(v)]);
      }
      v = number;
    }
  }
  shape.vertices = std::move(kept);
}

}  // namespace muckpile
