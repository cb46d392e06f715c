// SPDX-License-Identifier: GPL-2.0-or-later
// Tree of boxes around triangles.
// Scope: median splits by the middles of the triangles, as of index/axis_index.h.
#include "geometry/surface/surface_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/surface/triangle_point.h"

namespace muckpile {
namespace {

constexpr int kLeafSize = 4;

double distance_to_box(const Vec3& lo, const Vec3& hi, const Vec3& p) {
  return (lo - p).cwiseMax(p - hi).cwiseMax(0.0).norm();
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

double height_of(const StlTriangle& t, const Vec3& normal, double x, double y) {
  const double bottom = std::min({t[0].z(), t[1].z(), t[2].z()});
  const double top = std::max({t[0].z(), t[1].z(), t[2].z()});
  if (normal.z() == 0.0) return bottom;
  const double rise = (normal.x() * (x - t[0].x()) + normal.y() * (y - t[0].y())) / -normal.z();
  return std::clamp(t[0].z() + rise, bottom, top);  // of a steep one rounding in plan is large
}

}  // namespace

SurfaceIndex::SurfaceIndex(std::vector<StlTriangle> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()) {
  normals_.reserve(triangles_.size());
  for (const StlTriangle& t : triangles_)
    normals_.push_back((t[1] - t[0]).cross(t[2] - t[0]).normalized());
  std::iota(order_.begin(), order_.end(), 0);
  build(0, static_cast<int>(triangles_.size()));
}

int SurfaceIndex::build(int first, int last) {
  Node node;
  node.first = first;
  node.last = last;
  node.lo.setConstant(std::numeric_limits<double>::infinity());
  node.hi = -node.lo;
  const auto triangle = [&](int k) -> const StlTriangle& {
    return triangles_[static_cast<std::size_t>(k)];
  };
  for (int k = first; k < last; ++k) {
    for (const Vec3& corner : triangle(order_[static_cast<std::size_t>(k)])) {
      node.lo = node.lo.cwiseMin(corner);
      node.hi = node.hi.cwiseMax(corner);
    }
  }
  const std::size_t self = nodes_.size();
  nodes_.push_back(node);
  if (last - first > kLeafSize) {
    Eigen::Index along = 0;
    (node.hi - node.lo).maxCoeff(&along);
    const int middle = first + (last - first) / 2;
    const auto place = [&](int n) {
      const StlTriangle& t = triangle(n);
      return t[0][along] + t[1][along] + t[2][along];
    };
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int a, int b) { return std::pair(place(a), a) < std::pair(place(b), b); });
    build(first, middle);
    nodes_[self].right = build(middle, last);
  }
  return static_cast<int>(self);
}

void SurfaceIndex::look_for_closest(std::size_t number, const Vec3& from, Closest& best) const {
  const Node& node = nodes_[number];
  if (node.right == 0) {
    for (int k = node.first; k < node.last; ++k) {
      const auto triangle = static_cast<std::size_t>(order_[static_cast<std::size_t>(k)]);
      const Vec3 at = closest_on(triangles_[triangle], from).at;
      const double distance = (at - from).norm();
      if (distance < best.distance) best = {at, distance, triangle};
    }
    return;
  }
  std::array<std::size_t, 2> children{number + 1, static_cast<std::size_t>(node.right)};
  std::array<double, 2> away{};
  for (std::size_t c = 0; c < 2; ++c)
    away[c] = distance_to_box(nodes_[children[c]].lo, nodes_[children[c]].hi, from);
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
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    const std::size_t number = open.back();
    open.pop_back();
    const Node& node = nodes_[number];
    if (distance_to_box(node.lo, node.hi, place) > distance) continue;
    if (node.right != 0) {
      open.push_back(static_cast<std::size_t>(node.right));
      open.push_back(number + 1);
      continue;
    }
    for (int k = node.first; k < node.last; ++k) {
      const auto triangle = static_cast<std::size_t>(order_[static_cast<std::size_t>(k)]);
      if ((closest_on(triangles_[triangle], place).at - place).norm() <= distance)
        found.push_back(triangle);
    }
  }
}

template <class Visit>
void SurfaceIndex::visit_column(double x, double y, double from_z, const Visit& visit) const {
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    const std::size_t number = open.back();
    open.pop_back();
    const Node& node = nodes_[number];
    if (x < node.lo.x() || x > node.hi.x() || y < node.lo.y() || y > node.hi.y() ||
        node.hi.z() < from_z)
      continue;
    if (node.right != 0) {
      open.push_back(static_cast<std::size_t>(node.right));
      open.push_back(number + 1);
      continue;
    }
    for (int k = node.first; k < node.last; ++k) {
      const auto triangle = static_cast<std::size_t>(order_[static_cast<std::size_t>(k)]);
      const StlTriangle& t = triangles_[triangle];
      if (holds_in_plan(t, x, y)) visit(triangle, height_of(t, normals_[triangle], x, y));
    }
  }
}

void SurfaceIndex::crossings_at(double x, double y, std::vector<Crossing>& crossings) const {
  crossings.clear();
  visit_column(x, y, -std::numeric_limits<double>::infinity(),
               [&](std::size_t triangle, double height) {
                 crossings.push_back({height, normals_[triangle].z() > 0.0});
               });
  std::ranges::sort(crossings, {}, &Crossing::height);
}

bool SurfaceIndex::inside(const Vec3& point) const {
  bool odd = false;
  visit_column(point.x(), point.y(), point.z(),
               [&](std::size_t, double height) { odd = odd != (height > point.z()); });
  return odd;
}

}  // namespace muckpile
