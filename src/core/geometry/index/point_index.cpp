// SPDX-License-Identifier: GPL-2.0-or-later
// Neighbour search among points of strongly varying density: a k-d tree.
// Scope: median splits along the longest edge of each node's bounding box; ties go by number.
#include "geometry/index/point_index.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace muckpile {
namespace {
constexpr int kLeafSize = 32;
constexpr std::size_t kDeepest = 64;  // levels of halves of 2^31 points, and more
constexpr double kRounding = 1e-14;   // of a square that is summed in another order
}  // namespace

PointIndex::PointIndex(const std::vector<Vec3>& points) : order_(points.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!points.empty()) build(points, 0, static_cast<int>(points.size()));
  for (const int k : order_) {
    const Vec3& p = points[static_cast<std::size_t>(k)];
    x_.push_back(p.x());
    y_.push_back(p.y());
    z_.push_back(p.z());
  }
}

int PointIndex::build(const std::vector<Vec3>& points, int first, int last) {
  const auto point = [&](int k) -> const Vec3& { return points[static_cast<std::size_t>(k)]; };
  Node node;
  node.first = first;
  node.last = last;
  node.lo = node.hi = point(order_[static_cast<std::size_t>(first)]);
  for (int k = first; k < last; ++k) {
    const Vec3& p = point(order_[static_cast<std::size_t>(k)]);
    node.lo = node.lo.cwiseMin(p);
    node.hi = node.hi.cwiseMax(p);
  }
  const std::size_t self = nodes_.size();
  nodes_.push_back(node);
  if (last - first > kLeafSize) {
    Eigen::Index axis = 0;
    (node.hi - node.lo).maxCoeff(&axis);
    const int middle = first + (last - first) / 2;
    std::nth_element(
        order_.begin() + first, order_.begin() + middle, order_.begin() + last,
        [&](int a, int b) { return std::pair(point(a)[axis], a) < std::pair(point(b)[axis], b); });
    build(points, first, middle);
    nodes_[self].right = build(points, middle, last);
  }
  return static_cast<int>(self);
}

/// Most points of a leaf are farther than `outer`: those that may not be are chosen side by side.
void PointIndex::add_leaf(const Node& leaf, const Vec3& centre, double inner2, double outer2,
                          Found& found) const {
  const auto first = static_cast<std::size_t>(leaf.first);
  const auto count = static_cast<std::size_t>(leaf.last - leaf.first);
  const double *const x = x_.data() + first, *const y = y_.data() + first,
                      *const z = z_.data() + first;
  const double cx = centre.x(), cy = centre.y(), cz = centre.z();
  std::array<double, kLeafSize> squared;
  for (std::size_t k = 0; k < count; ++k) {
    const double dx = x[k] - cx, dy = y[k] - cy, dz = z[k] - cz;
    squared[k] = dx * dx + dy * dy + dz * dz;
  }
  std::array<std::size_t, kLeafSize> near;
  std::size_t nears = 0;
  for (std::size_t k = 0; k < count; ++k) {  // without a branch that cannot be foreseen
    near[nears] = k;
    nears += static_cast<std::size_t>(squared[k] < (1.0 + kRounding) * outer2);
  }
  for (std::size_t n = 0; n < nears; ++n) {
    const std::size_t k = near[n];
    const double d2 = (Vec3(x[k], y[k], z[k]) - centre).squaredNorm();
    if (d2 >= inner2 && d2 < outer2) found.emplace_back(d2, order_[first + k]);
  }
}

void PointIndex::shell(const Vec3& centre, double inner, double outer, Found& found) const {
  found.clear();
  const double inner2 = inner * inner, outer2 = outer * outer;
  std::array<int, kDeepest> waiting;  // one node per level at most
  std::size_t count = 0;
  if (!nodes_.empty()) waiting[count++] = 0;
  while (count > 0) {
    const int number = waiting[--count];
    const Node& node = nodes_[static_cast<std::size_t>(number)];
    const Vec3 nearest = centre.cwiseMax(node.lo).cwiseMin(node.hi);
    const Vec3 farthest = (centre - node.lo).cwiseAbs().cwiseMax((centre - node.hi).cwiseAbs());
    if ((nearest - centre).squaredNorm() >= outer2 || farthest.squaredNorm() < inner2) continue;
    if (node.right == 0) {
      add_leaf(node, centre, inner2, outer2, found);
      continue;
    }
    waiting[count++] = node.right;
    waiting[count++] = number + 1;
  }
  std::sort(found.begin(), found.end());
}

}  // namespace muckpile
