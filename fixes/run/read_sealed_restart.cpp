// SPDX-License-Identifier: GPL-2.0-or-later
// read_restart: LIGGGHTS' command, after a look at the file.
// Scope: see the header, which is not read_restart.h because LIGGGHTS has one.
#include "fixes/run/read_sealed_restart.h"

#include <read_restart.h>

#include <array>
#include <string>

#include "fixes/engine/restart_name.h"
#include "fixes/engine/restart_seal.h"
#include "fixes/engine/style_args.h"

namespace muckpile {

void ReadSealedRestart::command(int narg, char** arg) {
  if (narg != 1)
    engine::stop(*lmp, "read_restart: needs one word, the file, got " + std::to_string(narg));
  std::string file = engine::latest_restart(*lmp, arg[0]);
  engine::require_whole_restart(*lmp, file);
  std::array<char*, 1> name{file.data()};
  LAMMPS_NS::ReadRestart(lmp).command(1, name.data());
}

}  // namespace muckpile
