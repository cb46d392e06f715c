// SPDX-License-Identifier: GPL-2.0-or-later
// Neighbour search among points of strongly varying density: a k-d tree.
// Scope: median splits along the longest edge of each node's bounding box; ties go by number.
#include "geometry/index/point_index.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace muckpile {
namespace {
constexpr int kLeafSize = 8;
}

PointIndex::PointIndex(const std::vector<Vec3>& points) : order_(points.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!points.empty()) build(points, 0, static_cast<int>(points.size()));
  sorted_.reserve(points.size());
  for (const int k : order_) sorted_.push_back(points[static_cast<std::size_t>(k)]);
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

void PointIndex::shell(const Vec3& centre, double inner, double outer, Found& found) const {
  found.clear();
  const double inner2 = inner * inner, outer2 = outer * outer;
  std::vector<int> stack;
  if (!nodes_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const int number = stack.back();
    stack.pop_back();
    const Node& node = nodes_[static_cast<std::size_t>(number)];
    const Vec3 nearest = centre.cwiseMax(node.lo).cwiseMin(node.hi);
    const Vec3 farthest = (centre - node.lo).cwiseAbs().cwiseMax((centre - node.hi).cwiseAbs());
    if ((nearest - centre).squaredNorm() >= outer2 || farthest.squaredNorm() < inner2) continue;
    if (node.right != 0) {
      stack.push_back(node.right);
      stack.push_back(number + 1);
      continue;
    }
    for (int k = node.first; k < node.last; ++k) {
      const double d2 = (sorted_[static_cast<std::size_t>(k)] - centre).squaredNorm();
      if (d2 >= inner2 && d2 < outer2) found.emplace_back(d2, order_[static_cast<std::size_t>(k)]);
    }
  }
  std::sort(found.begin(), found.end());
}

}  // namespace muckpile
