// SPDX-License-Identifier: GPL-2.0-or-later
// Many snapshots of one run, of which often a few blocks are needed.
// Scope: as read_snapshot (io/snapshot.h), but for rows that are not requested.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/snapshot.h"

namespace muckpile {

enum class StateParts { kAll, kVelocity };

// Reads one snapshot after the other into the same memory.
class SnapshotReader {
 public:
  // `wanted` is 1 for each block whose state is asked for, empty for all of them. The states of the
  // others are not to be used: of their rows only the id and the number of fields are checked. So
  // it is with the other `parts` of a state.
  explicit SnapshotReader(const std::vector<StartBlock>& blocks, std::vector<char> wanted = {},
                          StateParts parts = StateParts::kAll);

  // Holds until the next call. Throws as read_snapshot does.
  const Snapshot& read(const std::filesystem::path& path);

 private:
  const std::vector<StartBlock>& blocks_;
  std::vector<int> ids_;  // of the blocks of the model
  std::vector<char> wanted_;
  StateParts parts_;
  std::string text_;
  Snapshot snapshot_;
};

}  // namespace muckpile
