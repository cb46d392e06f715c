// SPDX-License-Identifier: GPL-2.0-or-later
// A tree of boxes.
// Scope: see the header.
#include "geometry/index/box_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace muckpile {

BoxTree::BoxTree(const std::vector<Item>& items, int most_in_a_leaf)
    : most_in_a_leaf_(most_in_a_leaf), order_(items.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!items.empty()) build(items, 0, static_cast<int>(items.size()));
}

int BoxTree::build(const std::vector<Item>& items, int first, int last) {
  Node node;
  node.first = first;
  node.last = last;
  node.lo.setConstant(std::numeric_limits<double>::infinity());
  node.hi = -node.lo;
  for (int k = first; k < last; ++k) {
    const Item& one = items[item(k)];
    node.lo = node.lo.cwiseMin(one.lo);
    node.hi = node.hi.cwiseMax(one.hi);
  }
  const std::size_t self = nodes_.size();
  nodes_.push_back(node);
  if (last - first > most_in_a_leaf_) {
    Eigen::Index along = 0;
    (node.hi - node.lo).maxCoeff(&along);
    const int middle = first + (last - first) / 2;
    const auto place = [&](int n) { return items[static_cast<std::size_t>(n)].middle[along]; };
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int a, int b) { return std::pair(place(a), a) < std::pair(place(b), b); });
    build(items, first, middle);
    nodes_[self].right = build(items, middle, last);
  }
  return static_cast<int>(self);
}

}  // namespace muckpile
