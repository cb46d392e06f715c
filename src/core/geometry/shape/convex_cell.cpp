// SPDX-License-Identifier: GPL-2.0-or-later
// Division of convex polyhedra by planes.
// Scope: see the header.
#include "geometry/shape/convex_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace muckpile {
namespace {

constexpr double kInPlane = 1e-10;  // of the cell's extent along the plane's normal

/// Heights of the corners over the plane; 0 for corners in it.
std::vector<double> heights_over(const Polyhedron& shape, const Vec3& point, const Vec3& normal) {
  std::vector<double> heights;
  double lowest = 0.0, highest = 0.0;
  for (const Vec3& v : shape.vertices) {
    heights.push_back(normal.dot(v - point));
    lowest = std::min(lowest, heights.back());
    highest = std::max(highest, heights.back());
  }
  const double rounding = kInPlane * (highest - lowest);
  for (double& h : heights) h = std::abs(h) <= rounding ? 0.0 : h;
  return heights;
}

/// Corners where edges cross the plane, made once per edge.
class Crossings {
 public:
  Crossings(Polyhedron& shape, std::vector<double>& heights) : shape_(shape), heights_(heights) {}
  int between(int a, int b) {
    const auto edge = std::minmax(a, b);
    const auto [place, is_new] = made_.try_emplace(edge, static_cast<int>(heights_.size()));
    if (is_new) {
      const auto [p, q] = edge;
      const double hp = heights_[static_cast<std::size_t>(p)],
                   hq = heights_[static_cast<std::size_t>(q)];
      const Vec3 &vp = shape_.vertices[static_cast<std::size_t>(p)],
                 &vq = shape_.vertices[static_cast<std::size_t>(q)];
      const Vec3 at = vp + hp / (hp - hq) * (vq - vp);
      shape_.vertices.push_back(at);
      heights_.push_back(0.0);
    }
    return place->second;
  }

 private:
  Polyhedron& shape_;
  std::vector<double>& heights_;
  std::map<std::pair<int, int>, int> made_;
};

/// The corners in the plane, in order about the normal.
std::vector<int> ordered_about(const Polyhedron& shape, const std::vector<double>& heights,
                               const Vec3& normal) {
  std::vector<int> in_plane;
  Vec3 middle = Vec3::Zero();
  for (std::size_t v = 0; v < heights.size(); ++v) {
    if (heights[v] != 0.0) continue;
    in_plane.push_back(static_cast<int>(v));
    middle += shape.vertices[v];
  }
  middle /= static_cast<double>(in_plane.size());
  const Vec3 first = normal.unitOrthogonal(), second = normal.cross(first);
  const auto angle = [&](int v) {
    const Vec3 from = shape.vertices[static_cast<std::size_t>(v)] - middle;
    return std::atan2(second.dot(from), first.dot(from));
  };
  std::sort(in_plane.begin(), in_plane.end(), [&](int a, int b) { return angle(a) < angle(b); });
  return in_plane;
}

void add_face(ConvexCell& cell, std::vector<int> face, int made_by) {
  if (face.size() < 3) return;
  cell.shape.faces.push_back(std::move(face));
  cell.made_by.push_back(made_by);
}

/// The part of a face on one side (`sign` 1: above).
std::vector<int> part_of(const std::vector<int>& face, const std::vector<double>& heights,
                         Crossings& crossings, double sign) {
  std::vector<int> part;
  bool off_plane = false;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const int p = face[k], q = face[(k + 1) % face.size()];
    const double hp = sign * heights[static_cast<std::size_t>(p)],
                 hq = sign * heights[static_cast<std::size_t>(q)];
    if (hp >= 0.0) part.push_back(p);
    off_plane = off_plane || hp > 0.0;
    if (hp * hq < 0.0) part.push_back(crossings.between(p, q));
  }
  if (!off_plane) part.clear();
  return part;
}

}  // namespace

ConvexCell box_cell(const Vec3& lo, const Vec3& hi) {
  ConvexCell cell;
  for (int k = 0; k < 8; ++k) {
    cell.shape.vertices.emplace_back((k & 1) != 0 ? hi.x() : lo.x(), (k & 2) != 0 ? hi.y() : lo.y(),
                                     (k & 4) != 0 ? hi.z() : lo.z());
  }
  cell.shape.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  cell.made_by.assign(6, -1);
  return cell;
}

std::optional<HalfCells> divided(const ConvexCell& cell, const Vec3& point, const Vec3& normal,
                                 int number) {
  std::vector<double> heights = heights_over(cell.shape, point, normal);
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  if (!(*lowest < 0.0 && *highest > 0.0)) return std::nullopt;
  Polyhedron all = cell.shape;
  Crossings crossings(all, heights);
  HalfCells halves;
  for (std::size_t f = 0; f < cell.shape.faces.size(); ++f) {
    const std::vector<int>& face = cell.shape.faces[f];
    add_face(halves.below, part_of(face, heights, crossings, -1.0), cell.made_by[f]);
    add_face(halves.above, part_of(face, heights, crossings, 1.0), cell.made_by[f]);
  }
  std::vector<int> between = ordered_about(all, heights, normal);
  add_face(halves.below, between, number);
  std::reverse(between.begin(), between.end());
  add_face(halves.above, std::move(between), number);
  for (ConvexCell* half : {&halves.below, &halves.above}) {
    half->shape.vertices = all.vertices;
    drop_unused_vertices(half->shape);
  }
  return halves;
}

std::optional<ConvexCell> part_below(ConvexCell cell, const Vec3& point, const Vec3& normal,
                                     int number) {
  const auto [low, high] = extent(cell.shape, normal);
  const double at = normal.dot(point);
  if (high <= at) return cell;
  if (low >= at) return std::nullopt;
  if (auto halves = divided(cell, point, normal, number)) return std::move(halves->below);
  if (0.5 * (low + high) > at) return std::nullopt;  // it touches the plane
  return cell;
}

double volume_of(const ConvexCell& cell) { return mass_properties(cell.shape).volume; }

Vec3 centroid_of(const ConvexCell& cell) { return mass_properties(cell.shape).centroid; }

double surface_of(const Polyhedron& shape) {
  double area = 0.0;
  for (const std::vector<int>& face : shape.faces) {
    const Vec3& apex = shape.vertices[static_cast<std::size_t>(face[0])];
    Vec3 twice = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      twice += (shape.vertices[static_cast<std::size_t>(face[k])] - apex)
                   .cross(shape.vertices[static_cast<std::size_t>(face[k + 1])] - apex);
    }
    area += 0.5 * twice.norm();
  }
  return area;
}

double mean_radius(const Polyhedron& shape) {
  return 3.0 * mass_properties(shape).volume / surface_of(shape);
}

std::pair<double, double> extent(const Polyhedron& shape, const Vec3& normal) {
  std::pair<double, double> range(std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity());
  for (const Vec3& v : shape.vertices) {
    range.first = std::min(range.first, normal.dot(v));
    range.second = std::max(range.second, normal.dot(v));
  }
  return range;
}

}  // namespace muckpile
