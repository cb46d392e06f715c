// SPDX-License-Identifier: GPL-2.0-or-later
// The graded bed by which the contact search is judged: 8,000 blocks of 0.1 m beside 1,000 blocks
// of 1 m, nine spheres each. A search that bins by the largest sphere takes seventy times as long
// on it as on the small blocks alone.
#pragma once

#include <vector>

#include "block_scene.h"
#include "contact/block_contact_list.h"

namespace muckpile::perf {

/// Blocks in two cubic lattices with slightly turned blocks, the same every time. Their centres are
/// `spacing` times their size apart.
[[nodiscard]] std::vector<testing::BlockSpec> graded_bed(double spacing);

/// The spheres of blocks as the contact search wants them.
class BedSpheres {
 public:
  explicit BedSpheres(const std::vector<testing::BlockSpec>& blocks);
  [[nodiscard]] SphereSet view() const;

 private:
  std::vector<double> positions_, radii_;
  std::vector<int> tags_, blocks_;
};

/// Half the width of the box that holds the bed [m].
inline constexpr double kHalfBox = 12.0;

}  // namespace muckpile::perf
