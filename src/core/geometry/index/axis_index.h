// SPDX-License-Identifier: GPL-2.0-or-later
// Nearest of many charge axes, and those near a point: a tree of boxes around the axes.
// Scope: built once for fixed axes; queries are const. Distances are to the bit those that a look
// at every axis would give.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/index/box_tree.h"
#include "math/types.h"

namespace muckpile {

/// A straight line between two points.
class Axis {
 public:
  Axis(const Vec3& from, const Vec3& to);
  [[nodiscard]] const Vec3& from() const { return from_; }
  [[nodiscard]] const Vec3& to() const { return to_; }
  [[nodiscard]] double distance2(const Vec3& point) const {  ///< squared [m2]
    const double along = (point - from_).dot(direction_);
    const double beyond = along - std::clamp(along, 0.0, length_);
    return (point - from_ - along * direction_).squaredNorm() + beyond * beyond;
  }
  [[nodiscard]] double distance(const Vec3& point) const { return std::sqrt(distance2(point)); }

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
  /// Offers the axes in boxes nearer than the root of reach2() [m2], nearer boxes first.
  template <class Reach, class Visitor>
  bool walk(const Vec3& point, const Reach& reach2, const Visitor& visit) const;

  std::vector<Axis> axes_;
  BoxTree tree_;
};

template <class Reach, class Visitor>
bool AxisIndex::walk(const Vec3& point, const Reach& reach2, const Visitor& visit) const {
  constexpr double kSlack = 1.0 + 1e-9;  // a box may be nearer by rounding
  constexpr std::size_t kDeepest = 64;   // the halves of int's range
  struct Way {
    double distance2;  // [m2]
    std::size_t node;
  };
  const auto way_to = [&](std::size_t number) {
    return Way{tree_.node(number).distance2(point), number};
  };
  std::array<Way, kDeepest> stack;
  std::size_t depth = 0;
  if (!tree_.empty()) stack[depth++] = way_to(0);
  while (depth > 0) {
    const auto [distance2, number] = stack[--depth];
    if (distance2 > kSlack * reach2()) continue;
    const BoxTree::Node& node = tree_.node(number);
    if (node.right == 0) {
      for (int k = node.first; k < node.last; ++k)
        if (visit(static_cast<int>(tree_.item(k)))) return true;
      continue;
    }
    Way near = way_to(number + 1), far = way_to(static_cast<std::size_t>(node.right));
    if (far.distance2 < near.distance2) std::swap(near, far);
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
