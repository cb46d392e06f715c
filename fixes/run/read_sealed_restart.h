// SPDX-License-Identifier: GPL-2.0-or-later
// read_restart: LIGGGHTS' command, after a look at the file.
// Scope: refuses what is damaged or not whole; all reading is LIGGGHTS'.
#pragma once

#include <pointers.h>

namespace muckpile {

class ReadSealedRestart : protected LAMMPS_NS::Pointers {
 public:
  explicit ReadSealedRestart(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);
};

}  // namespace muckpile
