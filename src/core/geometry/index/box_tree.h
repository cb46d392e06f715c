// SPDX-License-Identifier: GPL-2.0-or-later
// A tree of boxes around things that have an extent, by which to find those near a place.
// Scope: built once for things that stay; median splits by their middles. Who asks decides which
// boxes to enter.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "math/types.h"

namespace muckpile {

class BoxTree {
 public:
  /// Box around one thing, and the place that decides to which half of a split it goes.
  struct Item {
    Vec3 lo = Vec3::Zero(), hi = Vec3::Zero();  // [m]
    Vec3 middle = Vec3::Zero();                 // of any scale, the same for all
  };
  struct Node {
    Vec3 lo, hi;              // of its items [m]
    int first = 0, last = 0;  // range of item(k)
    int right = 0;            // the left child is the next node; 0 for a leaf
    /// Of a point from the box [m2].
    [[nodiscard]] double distance2(const Vec3& point) const {
      return (point - point.cwiseMax(lo).cwiseMin(hi)).squaredNorm();
    }
  };
  BoxTree(const std::vector<Item>& items, int most_in_a_leaf);

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] std::size_t bytes() const {
    return order_.capacity() * sizeof(int) + nodes_.capacity() * sizeof(Node);
  }
  [[nodiscard]] const Node& node(std::size_t number) const { return nodes_[number]; }
  /// Number of the item at a place of the nodes' ranges.
  [[nodiscard]] std::size_t item(int k) const {
    return static_cast<std::size_t>(order_[static_cast<std::size_t>(k)]);
  }

  /// Calls visit(number) for the items in all boxes with enter(node), until it says true; returns
  /// whether it did. The order is fixed.
  template <class Enter, class Visit>
  bool any(const Enter& enter, const Visit& visit) const;

 private:
  int build(const std::vector<Item>& items, int first, int last);

  int most_in_a_leaf_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

template <class Enter, class Visit>
bool BoxTree::any(const Enter& enter, const Visit& visit) const {
  constexpr std::size_t kDeepest = 64;  // the halves of int's range
  std::array<std::size_t, kDeepest> open;
  std::size_t depth = 0;
  if (!nodes_.empty()) open[depth++] = 0;
  while (depth > 0) {
    const std::size_t number = open[--depth];
    const Node& node = nodes_[number];
    if (!enter(node)) continue;
    if (node.right != 0) {
      open[depth++] = static_cast<std::size_t>(node.right);
      open[depth++] = number + 1;
      continue;
    }
    for (int k = node.first; k < node.last; ++k)
      if (visit(item(k))) return true;
  }
  return false;
}

}  // namespace muckpile
