// SPDX-License-Identifier: GPL-2.0-or-later
// Which joints still hold at the end of a run, from dump/joints.csv.
// Scope: joints between two blocks of the model; what is not listed has broken whole.
#pragma once

#include <filesystem>
#include <vector>

namespace muckpile {

struct HoldingJoints {
  long step = 0;
  double time = 0.0;  // [s]
  struct Joint {
    int id;    // of the block with the smaller one
    int face;  // number in its polyhedron
    auto operator<=>(const Joint&) const = default;
  };
  std::vector<Joint> joints;  // in rising order

  [[nodiscard]] bool has(int id, int face) const;
};

// Throws InputError, naming the file, if it is absent or malformed or a joint occurs twice.
HoldingJoints read_joints(const std::filesystem::path& path);

}  // namespace muckpile
