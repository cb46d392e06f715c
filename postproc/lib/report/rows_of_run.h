// SPDX-License-Identifier: GPL-2.0-or-later
// The velocities of some blocks of the rock in the snapshots of a run.
// Scope: io/snapshot_reader.h for the rock alone, whether the snapshots have muck or not.
#pragma once

#include <utility>
#include <vector>

#include "io/snapshot_reader.h"
#include "report/run_data.h"

namespace muckpile {

class RowsOfRun {
 public:
  // `wanted` as in SnapshotReader, of run.blocks. Of their states only the velocities hold.
  RowsOfRun(const RunData& run, std::vector<char> wanted)
      : reader_(run.folder.blocks(), with_muck(std::move(wanted), run), StateParts::kVelocity) {}

  // Holds until the next call.
  const Snapshot& read(const std::filesystem::path& path) { return reader_.read(path); }

 private:
  static std::vector<char> with_muck(std::vector<char> wanted, const RunData& run) {
    wanted.resize(run.blocks.size() + run.muck.size(), 0);
    return wanted;
  }
  SnapshotReader reader_;
};

}  // namespace muckpile
