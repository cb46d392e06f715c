// SPDX-License-Identifier: GPL-2.0-or-later
// rank_grid: divides the box among the ranks along the row first, then along the throw.
// Scope: stands for LIGGGHTS' command processors, before the box is made.
#pragma once

#include <pointers.h>

namespace muckpile {

class RankGridCommand : protected LAMMPS_NS::Pointers {
 public:
  explicit RankGridCommand(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);
};

}  // namespace muckpile
