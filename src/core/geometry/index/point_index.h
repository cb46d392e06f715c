// SPDX-License-Identifier: GPL-2.0-or-later
// Neighbour search among points of strongly varying density: a k-d tree.
// Scope: built once for fixed points; queries are const and may run in parallel.
#pragma once

#include <utility>
#include <vector>

#include "math/types.h"

namespace muckpile {

class PointIndex {
 public:
  explicit PointIndex(const std::vector<Vec3>& points);

  using Found = std::vector<std::pair<double, int>>;  // squared distance [m2], point number
  // Replaces `found` by the points with inner <= distance < outer [m] from `centre`, nearest first.
  void shell(const Vec3& centre, double inner, double outer, Found& found) const;

 private:
  struct Node {
    Vec3 lo, hi;              // bounding box of its points [m]
    int first = 0, last = 0;  // range in order_
    int right = 0;            // the left child is the next node; 0 for a leaf
  };
  int build(const std::vector<Vec3>& points, int first, int last);
  void add_leaf(const Node& leaf, const Vec3& centre, double inner2, double outer2,
                Found& found) const;

  std::vector<int> order_;
  std::vector<double> x_, y_, z_;  // of the points in the order of order_ [m]
  std::vector<Node> nodes_;
};

}  // namespace muckpile
