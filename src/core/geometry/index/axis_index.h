// SPDX-License-Identifier: GPL-2.0-or-later
// Nearest of many charge axes, and those near a point: a tree of boxes around the axes.
// Scope: built once for fixed axes; queries are const. Distances are to the bit those that a look
// at every axis would give.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "math/types.h"

namespace muckpile {

/// A straight line between two points.
class Axis {
 public:
  Axis(const Vec3& from, const Vec3& to);
  [[nodiscard]] const Vec3& from() const { return from_; }
  [[nodiscard]] const Vec3& to() const { return to_; }
  [[nodiscard]] double distance(const Vec3& point) const;  ///< [m]

 private:
  Vec3 from_, to_, direction_;
  double length_;  // [m]
};

class AxisIndex {
 public:
  explicit AxisIndex(std::vector<Axis> axes);

  /// Distance of the nearest axis; infinity without any [m].
  [[nodiscard]] double nearest(const Vec3& point) const;
  /// Calls visit(number) for the axes within a distance [m], and perhaps for a few farther ones,
  /// until it says true; returns whether it did.
  template <class Visitor>
  bool any_within(const Vec3& point, double distance, const Visitor& visit) const;
  [[nodiscard]] const Axis& operator[](int number) const {
    return axes_[static_cast<std::size_t>(number)];
  }

 private:
  struct Node {
    Vec3 lo, hi;              // of its axes [m]
    int first = 0, last = 0;  // range in order_
    int right = 0;            // the left child is the next node; 0 for a leaf
    [[nodiscard]] double distance2(const Vec3& point) const;  // of the box [m2]
  };
  int build(int first, int last);
  /// Offers the axes in boxes nearer than the root of reach2() [m2], nearer boxes first.
  template <class Reach, class Visitor>
  bool walk(const Vec3& point, const Reach& reach2, const Visitor& visit) const;

  std::vector<Axis> axes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

template <class Reach, class Visitor>
bool AxisIndex::walk(const Vec3& point, const Reach& reach2, const Visitor& visit) const {
  constexpr double kSlack = 1.0 + 1e-9;  // a box may be nearer by rounding
  constexpr std::size_t kDeepest = 64;   // the halves of int's range
  std::array<std::pair<double, int>, kDeepest> stack;
  std::size_t depth = 0;
  if (!nodes_.empty()) stack[depth++] = {nodes_[0].distance2(point), 0};
  while (depth > 0) {
    const auto [distance2, number] = stack[--depth];
    if (distance2 > kSlack * reach2()) continue;
    const Node& node = nodes_[static_cast<std::size_t>(number)];
    if (node.right == 0) {
      for (int k = node.first; k < node.last; ++k)
        if (visit(order_[static_cast<std::size_t>(k)])) return true;
      continue;
    }
    std::pair<double, int> near(nodes_[static_cast<std::size_t>(number) + 1].distance2(point),
                                number + 1);
    std::pair<double, int> far(nodes_[static_cast<std::size_t>(node.right)].distance2(point),
                               node.right);
    if (far < near) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return false;
}

template <class Visitor>
bool AxisIndex::any_within(const Vec3& point, double distance, const Visitor& visit) const {
  return walk(
      point, [&] { return distance * distance; }, visit);
}

}  // namespace muckpile
