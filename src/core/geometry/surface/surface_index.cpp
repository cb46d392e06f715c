// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles of a surface in a tree of boxes.
// Scope: see the header.
#include "geometry/surface/surface_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/surface/triangle_point.h"

namespace muckpile {
namespace {

constexpr int kLeafSize = 4;

std::vector<BoxTree::Item> boxes_of(const std::vector<StlTriangle>& triangles) {
  std::vector<BoxTree::Item> items;
  items.reserve(triangles.size());
  for (const StlTriangle& t : triangles)
    items.push_back({t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]),
                     t[0] + t[1] + t[2]});
  return items;
}

double distance_to_box(const BoxTree::Node& node, const Vec3& p) {
  return (node.lo - p).cwiseMax(p - node.hi).cwiseMax(0.0).norm();
}

/// Whether a line from (x, y) along +x crosses the edge in plan. Computed alike for both triangles
/// at an edge, and half-open in y, so that triangles leave no gap and do not overlap.
bool crosses(const Vec3& a, const Vec3& b, double x, double y) {
  if ((a.y() > y) == (b.y() > y)) return false;
  const bool in_order = std::pair(a.y(), a.x()) < std::pair(b.y(), b.x());
  const Vec3 &low = in_order ? a : b, &high = in_order ? b : a;
  return low.x() + (y - low.y()) / (high.y() - low.y()) * (high.x() - low.x()) > x;
}

bool holds_in_plan(const StlTriangle& t, double x, double y) {
  return crosses(t[0], t[1], x, y) != (crosses(t[1], t[2], x, y) != crosses(t[2], t[0], x, y));
}

/// On which side of a line an edge passes. Computed alike for both triangles at an edge, so that
/// they leave no gap and do not overlap.
bool passes(const Vec3& a, const Vec3& b, const Vec3& from, const Vec3& to) {
  const bool in_order =
      std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  const Vec3 &low = in_order ? a : b, &high = in_order ? b : a;
  return ((low - from).cross(high - from).dot(to - from) > 0.0) == in_order;
}

bool meets(const StlTriangle& t, const Vec3& normal, const Vec3& from, const Vec3& to) {
  if ((normal.dot(from - t[0]) > 0.0) == (normal.dot(to - t[0]) > 0.0)) return false;
  const bool first = passes(t[0], t[1], from, to);
  return first == passes(t[1], t[2], from, to) && first == passes(t[2], t[0], from, to);
}

double height_of(const StlTriangle& t, const Vec3& normal, double x, double y) {
  const double bottom = std::min({t[0].z(), t[1].z(), t[2].z()});
  const double top = std::max({t[0].z(), t[1].z(), t[2].z()});
  if (normal.z() == 0.0) return bottom;
  const double rise = (normal.x() * (x - t[0].x()) + normal.y() * (y - t[0].y())) / -normal.z();
  return std::clamp(t[0].z() + rise, bottom, top);  // of a steep one rounding in plan is large
}

}  // namespace

SurfaceIndex::SurfaceIndex(std::vector<StlTriangle> triangles)
    : triangles_(std::move(triangles)), tree_(boxes_of(triangles_), kLeafSize) {
  normals_.reserve(triangles_.size());
  for (const StlTriangle& t : triangles_)
    normals_.push_back((t[1] - t[0]).cross(t[2] - t[0]).normalized());
}

double SurfaceIndex::area() const {
  double area = 0.0;
  for (const StlTriangle& t : triangles_) area += 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
  return area;
}

std::size_t SurfaceIndex::bytes() const {
  return triangles_.capacity() * sizeof(StlTriangle) + normals_.capacity() * sizeof(Vec3) +
         tree_.bytes();
}

void SurfaceIndex::look_for_closest(std::size_t number, const Vec3& from, Closest& best) const {
  const BoxTree::Node& node = tree_.node(number);
  if (node.right == 0) {
    for (int k = node.first; k < node.last; ++k) {
      const std::size_t triangle = tree_.item(k);
      const Vec3 at = closest_on(triangles_[triangle], from).at;
      const double distance = (at - from).norm();
      if (distance < best.distance) best = {at, distance, triangle};
    }
    return;
  }
  std::array<std::size_t, 2> children{number + 1, static_cast<std::size_t>(node.right)};
  std::array<double, 2> away{};
  for (std::size_t c = 0; c < 2; ++c) away[c] = distance_to_box(tree_.node(children[c]), from);
  const std::size_t nearer = away[1] < away[0] ? 1 : 0;
  for (const std::size_t c : {nearer, 1 - nearer})
    if (away[c] < best.distance) look_for_closest(children[c], from, best);
}

SurfaceIndex::Closest SurfaceIndex::closest(const Vec3& from) const {
  Closest best;
  best.distance = std::numeric_limits<double>::infinity();
  look_for_closest(0, from, best);
  return best;
}

void SurfaceIndex::near(const Vec3& place, double distance, std::vector<std::size_t>& found) const {
  found.clear();
  tree_.any([&](const BoxTree::Node& node) { return distance_to_box(node, place) <= distance; },
            [&](std::size_t triangle) {
              if ((closest_on(triangles_[triangle], place).at - place).norm() <= distance)
                found.push_back(triangle);
              return false;
            });
}

template <class Visit>
void SurfaceIndex::visit_column(double x, double y, double from_z, const Visit& visit) const {
  tree_.any(
      [&](const BoxTree::Node& node) {
        return x >= node.lo.x() && x <= node.hi.x() && y >= node.lo.y() && y <= node.hi.y() &&
               node.hi.z() >= from_z;
      },
      [&](std::size_t triangle) {
        const StlTriangle& t = triangles_[triangle];
        if (holds_in_plan(t, x, y)) visit(triangle, height_of(t, normals_[triangle], x, y));
        return false;
      });
}

void SurfaceIndex::crossings_at(double x, double y, std::vector<Crossing>& crossings) const {
  crossings.clear();
  visit_column(x, y, -std::numeric_limits<double>::infinity(),
               [&](std::size_t triangle, double height) {
                 crossings.push_back({height, normals_[triangle].z() > 0.0});
               });
  std::ranges::sort(crossings, {}, &Crossing::height);
}

bool SurfaceIndex::parts(const Vec3& from, const Vec3& to) const {
  const Vec3 lo = from.cwiseMin(to), hi = from.cwiseMax(to);
  bool odd = false;
  tree_.any(
      [&](const BoxTree::Node& node) {
        return (node.lo.array() <= hi.array()).all() && (node.hi.array() >= lo.array()).all();
      },
      [&](std::size_t k) {
        odd = odd != meets(triangles_[k], normals_[k], from, to);
        return false;
      });
  return odd;
}

bool SurfaceIndex::inside(const Vec3& point) const {
  bool odd = false;
  visit_column(point.x(), point.y(), point.z(),
               [&](std::size_t, double height) { odd = odd != (height > point.z()); });
  return odd;
}

}  // namespace muckpile
