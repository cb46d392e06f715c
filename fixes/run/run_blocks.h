// SPDX-License-Identifier: GPL-2.0-or-later
// run_blocks: runs a scene without charges to a time, or until the rock rests.
// Scope: from the words and the contacts of the script to core's BlocksRun.
#pragma once

#include <pointers.h>

namespace muckpile {

class RunBlocksCommand : protected LAMMPS_NS::Pointers {
 public:
  static constexpr const char* kStyle = "run_blocks";

  explicit RunBlocksCommand(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);
};

}  // namespace muckpile
