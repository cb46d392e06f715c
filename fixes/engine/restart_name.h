// SPDX-License-Identifier: GPL-2.0-or-later
// The restart file that a name with `*` means: the one of the latest step.
// Scope: compares whole names. LIGGGHTS' own search takes a word in place of the `*` for step 0,
// and accepts files whose names only begin alike.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// `name` with the greatest number that a file has in place of its `*`; of files in parts (`%`) the
/// base counts. A name without `*` is itself. Collective; stops the run if there is no such file.
[[nodiscard]] std::string latest_restart(LAMMPS_NS::LAMMPS& lmp, const std::string& name);

}  // namespace muckpile::engine
