// SPDX-License-Identifier: GPL-2.0-or-later
// Ends a run that has gone wrong, and leaves its state where a fix knows a place for it.
// Scope: for faults found at the end of a step, by all ranks.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// Stops the run with `why` and, where a fix muckpile/progress is, the name of the restart file
/// that it has written. Collective.
[[noreturn]] void stop_with_state(LAMMPS_NS::LAMMPS& lmp, const std::string& why);

/// " at step ..., t = ... s", for messages.
[[nodiscard]] std::string at_present(const LAMMPS_NS::LAMMPS& lmp);

}  // namespace muckpile::engine
