// SPDX-License-Identifier: GPL-2.0-or-later
// What fixes that write files every so many steps share: two keywords, the folder, fix_modify
// every. Scope: words are the same on every rank; all functions are collective.
#pragma once

#include <string>

#include "args/arg_table.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// A table that begins with `every` [steps] and `directory`; the texts are their meanings.
[[nodiscard]] ArgTable periodic_output_table(const std::string& style,
                                             const std::string& every_text,
                                             const std::string& directory_text);

/// Makes `folder` with its parents; one that cannot be written to stops the run. `where` starts the
/// message.
void make_output_folder(LAMMPS_NS::LAMMPS& lmp, const std::string& where,
                        const std::string& folder);

/// The number of steps of `fix_modify ID every N`; `arg` begins with `every`.
[[nodiscard]] int read_every(LAMMPS_NS::LAMMPS& lmp, const std::string& where, int narg,
                             char** arg);

}  // namespace muckpile::engine
