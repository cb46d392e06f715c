// SPDX-License-Identifier: GPL-2.0-or-later
// Text files of results, written by the first rank and not lost in silence.
// Scope: small enough for memory; a full disk stops the run, as what follows would be
// lost, too.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// Writes `text`, which counts on the first rank, in place of what was in the file. Collective;
/// stops the run, with a message that begins with `where`, if not all of it has arrived: the file
/// is then what it was, and whoever reads it meanwhile finds the old text or the new one.
void write_file(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& file,
                const std::string& text);

/// The same behind what the file holds.
void append_to_file(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& file,
                    const std::string& text);

}  // namespace muckpile::engine
