// SPDX-License-Identifier: GPL-2.0-or-later
// What every report starts from: the blocks, where they ended, and which of them were broken out.
// Scope: loaded once per sub-command; the folder must outlive it, as it keeps the blocks.
#pragma once

#include <vector>

#include "io/result_folder.h"
#include "measure/broken_out.h"
#include "report/options.h"

namespace muckpile {

struct RunData {
  RunData(const ResultFolder& of, const MeasureOptions& options)
      : folder(of),
        blocks(of.blocks()),
        last(read_snapshot(of.snapshots().back(), blocks)),
        block_size(mean_block_size(blocks, std::vector<char>(blocks.size(), 1))),
        cell(options.cell.value_or(0.25 * block_size)),
        moved(broken_out(blocks, last.states, options.least_move.value_or(block_size))),
        lies(blocks.size(), 1),
        still(of.is_still()) {
    // At the end of a run that is not still nearly all may move: then the surface is that of all.
    if (!still) return;
    for (char& each : lies = on_the_move(last.states)) each = each == 0;
  }

  const ResultFolder& folder;
  const std::vector<StartBlock>& blocks;  // the folder's
  Snapshot last;
  double block_size;  // mean over all blocks [m]
  double cell;        // of columns [m]
  std::vector<char> moved;
  std::vector<char> lies;  // 0: still on the move as the pile had come to rest
  bool still;              // the run ended at rest
};

}  // namespace muckpile
