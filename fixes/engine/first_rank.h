// SPDX-License-Identifier: GPL-2.0-or-later
// Work of the first rank alone, whose faults stop all.
// Scope: collective.
#pragma once

#include <functional>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// Runs `body` on the first rank; what it throws stops the run on all ranks, with its message, or
/// what `told` makes of that.
void on_first_rank(LAMMPS_NS::LAMMPS& lmp, const std::function<void()>& body,
                   const std::function<std::string(const std::string&)>& told = {});

}  // namespace muckpile::engine
