// SPDX-License-Identifier: GPL-2.0-or-later
// What fixes that write files every so many steps share.
// Scope: see the header.
#include "fixes/engine/periodic_output.h"

#include <comm.h>
#include <lammps.h>
#include <mpi.h>
#include <unistd.h>

#include <filesystem>

#include "args/numbers.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/style_args.h"

namespace muckpile::engine {

ArgTable periodic_output_table(const std::string& style, const std::string& every_text,
                               const std::string& directory_text) {
  return ArgTable(style)
      .integer("every", "steps", step_counts(), std::nullopt, every_text)
      .word("directory", {}, std::nullopt, directory_text);
}

void make_output_folder(LAMMPS_NS::LAMMPS& lmp, const std::string& where,
                        const std::string& folder) {
  int bad = 0;
  if (lmp.comm->me == 0) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    bad = fault || access(folder.c_str(), W_OK | X_OK) != 0 ? 1 : 0;
  }
  bad = of_first_rank(bad, lmp.world);
  if (bad != 0) stop(lmp, where + ": directory must be writable, got '" + folder + "'");
}

int read_every(LAMMPS_NS::LAMMPS& lmp, const std::string& where, int narg, char** arg) {
  if (narg < 2) stop(lmp, where + ": every needs a number of steps");
  return static_cast<int>(or_engine_error(
      lmp, [&] { return parse_integer(where, "every", arg[1], "steps", step_counts()); }));
}

}  // namespace muckpile::engine
