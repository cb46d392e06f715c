// SPDX-License-Identifier: GPL-2.0-or-later
// From the engine's (narg, arg) to values of a keyword table, and from InputError to an engine
// error. Scope: arguments are the same on every rank, so every rank stops together; nothing here is
// for a fault that one rank alone has found.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "args/input_error.h"
#include "args/parse_args.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// The words arg[first] ... arg[narg - 1].
[[nodiscard]] std::vector<std::string> words_of(int narg, char** arg, int first);

/// Reads the words from arg[first] on against the table and echoes the values, as understood, on
/// rank 0 to screen and log file. `where` starts every message, e.g. "fix muckpile/blast 'gas1'".
/// A fault in the words stops the run on all ranks.
[[nodiscard]] ArgValues read_args(LAMMPS_NS::LAMMPS& lmp, const ArgTable& table,
                                  const std::string& where, int narg, char** arg, int first);

/// Prints on rank 0 to screen and log file.
void print_once(LAMMPS_NS::LAMMPS& lmp, const std::string& text);

/// Stops the run with an error message; to be called by all ranks.
[[noreturn]] void stop(LAMMPS_NS::LAMMPS& lmp, const std::string& message);

/// Allowed numbers of steps between two actions of a fix: the engine counts them in an int.
[[nodiscard]] Range step_counts();

/// Result of `body`; an InputError in it, which must be the same on all ranks, stops the run.
template <class Body>
auto or_engine_error(LAMMPS_NS::LAMMPS& lmp, Body&& body) {
  try {
    return std::forward<Body>(body)();
  } catch (const InputError& error) {
    stop(lmp, error.what());
  }
}

/// The same, with the words of what was going on before the message.
template <class Body>
auto or_engine_error(LAMMPS_NS::LAMMPS& lmp, const std::string& where, Body&& body) {
  try {
    return std::forward<Body>(body)();
  } catch (const InputError& error) {
    stop(lmp, where + ": " + error.what());
  }
}

}  // namespace muckpile::engine
