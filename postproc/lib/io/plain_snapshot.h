// SPDX-License-Identifier: GPL-2.0-or-later
// Snapshots as the engine writes them, read on all cores.
// Scope: numbers with nothing but a comma between them, columns in the engine's order; what is
// written otherwise, faulty files among it, is left to read_snapshot.
#pragma once

#include <string_view>
#include <vector>

#include "io/snapshot_reader.h"

namespace muckpile {

// Of a text that is the rows of a snapshot without its remark, header first. Fills the states of
// the blocks with these ids, which rise, each once; false where a row is not plain, a number is not
// finite, an id is none of them, occurs twice or is missing, or a quaternion is no unit one to
// within `unit_tolerance`. Where `wanted` is not empty, only the states of the blocks for which it
// is not 0 are filled, with these parts; rows of others must have as many fields, whatever is in
// them.
struct WantedStates {
  const std::vector<char>& of;
  StateParts parts;
};
bool read_plain_rows(std::string_view rows, const std::vector<int>& ids, double unit_tolerance,
                     const WantedStates& wanted, std::vector<BlockState>& states);

}  // namespace muckpile
