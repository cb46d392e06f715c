// SPDX-License-Identifier: GPL-2.0-or-later
// The seal at the end of a restart file: how long the file was when it was written, and a hash of
// its bytes. Scope: LIGGGHTS trusts all that it reads, even the lengths of its own buffers; the
// seal shows damage and a missing end before LIGGGHTS reads the file. It stands behind LIGGGHTS'
// data. Files in parts (with % in their name) have none.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// Puts the seal behind a file just written. Called by every rank, done by the first.
void seal_restart(LAMMPS_NS::LAMMPS& lmp, const std::string& file);

/// Stops the run if the file is damaged or not whole. Collective. Passes files without a seal that
/// hold nothing of Muckpile's, as LIGGGHTS alone writes them.
void require_whole_restart(LAMMPS_NS::LAMMPS& lmp, const std::string& file);

}  // namespace muckpile::engine
