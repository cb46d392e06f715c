// SPDX-License-Identifier: GPL-2.0-or-later
// read_restart: LIGGGHTS' command, after a look at the file.
// Scope: see the header, which is not read_restart.h because LIGGGHTS has one.
#include "read_sealed_restart.h"

#include <read_restart.h>

#include "engine/restart_seal.h"

namespace muckpile {

void ReadSealedRestart::command(int narg, char** arg) {
  if (narg == 1) engine::require_whole_restart(*lmp, arg[0]);
  LAMMPS_NS::ReadRestart(lmp).command(narg, arg);
}

}  // namespace muckpile
