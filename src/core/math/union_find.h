// SPDX-License-Identifier: GPL-2.0-or-later
// Sets of numbered things that are joined pair by pair.
// Scope: which thing stands for a set depends on the order of joining.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace muckpile {

class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  /// The thing that stands for the set of thing k.
  [[nodiscard]] std::size_t root(std::size_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace muckpile
