// SPDX-License-Identifier: GPL-2.0-or-later
// The joints of the rock by geometry.
// Scope: see the header.
#include "measure/joint_faces.h"

#include <algorithm>
#include <cmath>

#include "bond/build/facet_builder.h"
#include "geometry/index/point_index.h"
#include "geometry/shape/polyhedron.h"
#include "io/images.h"

namespace muckpile {
namespace {

std::vector<RockFace> all_faces(const std::vector<StartBlock>& blocks) {
  std::vector<RockFace> faces;
  for (size_t b = 0; b < modelled(blocks); ++b) {
    const Polyhedron shape = polyhedron_of(blocks[b].shape);
    for (size_t f = 0; f < shape.faces.size(); ++f) {
      const FaceGeometry geometry = face_geometry(shape, static_cast<int>(f));
      if (!(geometry.area > 0.0)) continue;
      RockFace face{
          b, static_cast<int>(f), {}, {}, geometry.centroid, geometry.normal, geometry.area};
      for (const int v : shape.faces[f])
        face.corners.push_back(shape.vertices[static_cast<size_t>(v)]);
      faces.push_back(std::move(face));
    }
  }
  return faces;
}

// As build_facets() has it, which makes a joint from the block that comes first.
bool is_too_small(const RockFace& face, const std::vector<StartBlock>& blocks) {
  return face.area < kSmallestFacetShare * std::pow(blocks[face.block].volume, 2.0 / 3.0);
}

bool are_one(const RockFace& a, const RockFace& b) {
  constexpr double kOpposite = -0.999;  // cosine of the normals
  constexpr double kAlike = 0.01;       // of the area
  return a.block != b.block && a.normal.dot(b.normal) < kOpposite &&
         std::abs(a.area - b.area) <= kAlike * std::max(a.area, b.area);
}

}  // namespace

std::vector<RockFace> faces_of_rock(const std::vector<StartBlock>& blocks) {
  constexpr double kNear = 1e-3;  // of the face's size: far more than rounding
  std::vector<RockFace> faces = all_faces(blocks);
  std::vector<Vec3> centroids;
  for (const RockFace& face : faces) centroids.push_back(face.centroid);
  const PointIndex index(centroids);
  std::vector<char> left_out(faces.size(), 0);  // of a joint that its first block has, or too small
  PointSearch search(index);
  for (size_t f = 0; f < faces.size(); ++f) {
    if (left_out[f] != 0) continue;
    const double near = kNear * std::sqrt(faces[f].area);  // [m]
    for (const auto& [distance2, number] : search.shell(faces[f].centroid, 0.0, near)) {
      const auto g = static_cast<size_t>(number);
      if (g <= f || left_out[g] != 0 || !are_one(faces[f], faces[g])) continue;
      faces[f].other = faces[g].block;
      left_out[g] = 1;
      break;
    }
    if (is_too_small(faces[f], blocks)) left_out[f] = 1;
  }
  std::vector<RockFace> once;
  for (size_t f = 0; f < faces.size(); ++f)
    if (left_out[f] == 0) once.push_back(std::move(faces[f]));
  return once;
}

std::optional<std::pair<Vec3, Vec3>> cut_of(const RockFace& face, const Vec3& normal,
                                            double distance) {
  std::vector<Vec3> ends;
  for (size_t k = 0; k < face.corners.size(); ++k) {
    const Vec3 &a = face.corners[k], &b = face.corners[(k + 1) % face.corners.size()];
    const double from = normal.dot(a) - distance, to = normal.dot(b) - distance;
    if ((from < 0.0) != (to < 0.0)) ends.push_back(a + from / (from - to) * (b - a));
  }
  if (ends.size() != 2) return std::nullopt;
  return std::pair(ends[0], ends[1]);
}

}  // namespace muckpile
