// SPDX-License-Identifier: GPL-2.0-or-later
// From the engine's (narg, arg) to values of a keyword table, and from InputError to an engine
// error. Scope: see style_args.h.
#include "fixes/engine/style_args.h"

#include <comm.h>
#include <error.h>
#include <lammps.h>
#include <pointers.h>
#include <universe.h>

#include <cstdio>
#include <cstdlib>
#include <limits>

namespace muckpile::engine {

std::vector<std::string> words_of(int narg, char** arg, int first) {
  std::vector<std::string> words;
  for (int i = first; i < narg; ++i) words.emplace_back(arg[i]);
  return words;
}

ArgValues read_args(LAMMPS_NS::LAMMPS& lmp, const ArgTable& table, const std::string& where,
                    int narg, char** arg, int first) {
  return or_engine_error(lmp, [&] {
    ArgValues values = parse_args(table, where, words_of(narg, arg, first));
    print_once(lmp, values.echo());
    return values;
  });
}

Range step_counts() { return Range::closed(1, std::numeric_limits<int>::max()); }

void print_once(LAMMPS_NS::LAMMPS& lmp, const std::string& text) {
  if (lmp.comm->me != 0) return;
  if (lmp.screen != nullptr) std::fputs(text.c_str(), lmp.screen);
  if (lmp.logfile != nullptr) std::fputs(text.c_str(), lmp.logfile);
}

void stop(LAMMPS_NS::LAMMPS& lmp, const std::string& message) {
  // Error::all of a PUBLIC version follows one message in five by a line from freed memory.
  lmp.universe->version[0] = '\0';
  lmp.error->all(FLERR, message.c_str());
  std::abort();  // not reached: Error::all leaves the program
}

}  // namespace muckpile::engine
