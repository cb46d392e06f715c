// SPDX-License-Identifier: GPL-2.0-or-later
// Styles of which a run may have one fix only, and those that go on from a restart file.
// Scope: called first of all in the fix's constructor.
#pragma once

#include <string>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace muckpile::engine {

/// Stops the run, with a message that begins with `where`, if a fix of `style` exists, or if this
/// one is defined under an ID that is taken: the engine has then deleted the fix of that ID, to
/// which others may point.
void refuse_second_fix(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& style);

/// Stops the run, with a message that begins with `where`, if the restart file that has been read
/// holds the state of a fix of this style under another ID: the fix would silently begin anew. To
/// be called before the first run; the engine forgets the file then.
void require_id_of_restart(LAMMPS_NS::LAMMPS& lmp, const std::string& where, LAMMPS_NS::Fix& fix);

}  // namespace muckpile::engine
