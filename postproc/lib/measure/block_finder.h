// SPDX-License-Identifier: GPL-2.0-or-later
// Which block a point lay in before the blast.
// Scope: convex blocks; a point on a face may be of either block. One search looks at the few
// blocks whose boxes reach into its cell of a grid.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "io/blocks_file.h"

namespace muckpile {

// Whether a place lies in a block, as it stood before the blast, by more than `depth` [m]; below 0:
// or so far outside of it. Faces without area bound nothing.
[[nodiscard]] bool lies_within(const StartBlock& block, const Vec3& place, double depth);

class BlockFinder {
 public:
  // `blocks` must outlive the finder.
  explicit BlockFinder(const std::vector<StartBlock>& blocks);

  [[nodiscard]] std::optional<size_t> at(const Vec3& point) const;

 private:
  using Cell = std::array<long, 3>;
  [[nodiscard]] Cell cell_of(const Vec3& point) const;

  const std::vector<StartBlock>& blocks_;
  double width_;  // of a cell [m]
  std::map<Cell, std::vector<size_t>> in_cell_;
};

}  // namespace muckpile
