// SPDX-License-Identifier: GPL-2.0-or-later
// Styles of which a run may have one fix only.
// Scope: called first of all in the fix's constructor.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// Stops the run, with a message that begins with `where`, if a fix of `style` exists, or if this
/// one is defined under an ID that is taken: the engine has then deleted the fix of that ID, to
/// which others may point.
void refuse_second_fix(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& style);

}  // namespace muckpile::engine
