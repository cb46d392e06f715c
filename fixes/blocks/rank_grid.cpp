// SPDX-License-Identifier: GPL-2.0-or-later
// rank_grid: words to numbers, and LIGGGHTS' own command with the grid that follows from them.
// Scope: see the header.
#include "fixes/blocks/rank_grid.h"

#include <comm.h>
#include <domain.h>
#include <input.h>

#include <string>

#include "args/arg_table.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/keyword_tables.h"
#include "partition/rank_grid.h"

namespace muckpile {
namespace {

constexpr const char* kStyle = "rank_grid";

const ArgTable& table() {
  static const ArgTable args = ArgTable(kStyle)
                                   .real("width_y", "m", Range::left_open(0.0, 1e6), std::nullopt,
                                         "of the rock along y, the row")
                                   .real("thinnest", "m", Range::left_open(0.0, 1e6), std::nullopt,
                                         "slab of rock along y that one rank may have");
  return args;
}

}  // namespace

const ArgTable& rank_grid_keywords() { return table(); }

void RankGridCommand::command(int narg, char** arg) {
  const ArgValues args = engine::read_args(*lmp, table(), kStyle, narg, arg, 0);
  if (domain->box_exist != 0)
    engine::stop(*lmp, std::string(kStyle) + ": must come before the box is made");
  const RankGrid grid = rank_grid(comm->nprocs, args.real("width_y"), args.real("thinnest"));
  const std::string line =
      "processors " + std::to_string(grid.along_x) + ' ' + std::to_string(grid.along_y) + " 1";
  input->one(line.c_str());
}

}  // namespace muckpile
