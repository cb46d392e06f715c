// SPDX-License-Identifier: GPL-2.0-or-later
// Frames of a text dump (dump custom), which LIGGGHTS and LAMMPS write alike.
// Scope: numbers only; every frame has its rows in the file's order.
#pragma once

#include <filesystem>
#include <vector>

namespace muckpile::crosscheck {

struct Frame {
  long step = 0;
  std::vector<std::vector<double>> rows;  ///< in the columns of the dump command
};

/// Throws std::runtime_error, naming the file, if it cannot be read, ends within a frame or has a
/// row of another length than `columns`.
[[nodiscard]] std::vector<Frame> read_dump(const std::filesystem::path& path, std::size_t columns);

}  // namespace muckpile::crosscheck
