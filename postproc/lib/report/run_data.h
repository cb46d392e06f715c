// SPDX-License-Identifier: GPL-2.0-or-later
// What every report starts from: the blocks, where they ended, and which of them were broken out.
// Scope: loaded once per sub-command; the folder must outlive it, as it keeps the blocks.
#pragma once

#include <algorithm>
#include <vector>

#include "io/muck.h"
#include "io/result_folder.h"
#include "measure/broken_out.h"
#include "measure/pit_floor.h"
#include "measure/sunk_blocks.h"
#include "report/options.h"

namespace muckpile {

struct RunData {
  RunData(const ResultFolder& of, const MeasureOptions& options)
      : folder(of),
        blocks(of.rock()),
        last(read_snapshot(of.snapshots().back(), of.blocks())),
        muck(of.blocks().begin() + static_cast<std::ptrdiff_t>(blocks.size()), of.blocks().end()),
        muck_states(split_muck(last.states, blocks.size())),
        block_size(mean_block_size(blocks, std::vector<char>(blocks.size(), 1))),
        cell(options.cell.value_or(0.25 * block_size)),
        moved(broken_out(blocks, last.states, options.least_move.value_or(block_size))),
        lies(blocks.size(), 1),
        still(of.is_still()),
        floor(floor_of(of)) {
    // At the end of a run that is not still nearly all may move: then the surface is that of all.
    if (!still) return;
    for (char& each : lies = on_the_move(last.states)) each = each == 0;
  }

  // Of the folder's blocks, rock and muck.
  [[nodiscard]] Snapshot with_muck() const {
    Snapshot all = last;
    all.states.insert(all.states.end(), muck_states.begin(), muck_states.end());
    return all;
  }

  // Rock and muck whose centre lies in another block at the end.
  [[nodiscard]] std::ptrdiff_t blocks_in_blocks() const {
    return std::ranges::count(sunk_blocks(folder.blocks(), with_muck().states), 1);
  }

  const ResultFolder& folder;
  const std::vector<StartBlock>& blocks;  // the folder's, of the rock alone: what is measured
  Snapshot last;                          // of these
  std::vector<StartBlock> muck;           // that lay in front, and its states
  std::vector<BlockState> muck_states;
  double block_size;  // mean over all blocks [m]
  double cell;        // of columns [m]
  std::vector<char> moved;
  std::vector<char> lies;  // 0: still on the move as the pile had come to rest
  bool still;              // the run ended at rest
  PitFloor floor;

 private:
  static PitFloor floor_of(const ResultFolder& folder) {
    if (!folder.scene_has("floor_survey") || folder.scene_number("floor_survey") == 0.0) return {};
    // Solids behind the first are not the ground, but what the rock stands on.
    const std::filesystem::path file = folder.dump("floor.stl");
    return {read_first_solid(file, 1.0), folder.scene_number("floor_front_m"), file.string()};
  }
};

}  // namespace muckpile
