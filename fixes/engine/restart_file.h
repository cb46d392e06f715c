// SPDX-License-Identifier: GPL-2.0-or-later
// The state of a fix as bytes of LIGGGHTS' restart file.
// Scope: global state; one writer (rank 0), every rank reads all of it.
#pragma once

#include <cstdio>
#include <string>

#include "fixes/engine/exchange.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// Writes `common` as rank 0 has it, then `mine` of every rank. Collective; stops the run if that
/// is more than the format can hold.
void write_state(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::FILE* file,
                 ByteWriter& common, ByteWriter& mine);
void write_state(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::FILE* file,
                 ByteWriter& common);

/// Reader of what write_state() wrote; `state` is what the engine hands to Fix::restart().
[[nodiscard]] ByteReader read_state(const char* state);

/// Sum over ranks. Collective.
[[nodiscard]] double total(LAMMPS_NS::LAMMPS& lmp, double mine);
/// This rank's part of a sum over ranks read from a file: all of it on rank 0, 0 elsewhere.
[[nodiscard]] double share_of_total(LAMMPS_NS::LAMMPS& lmp, double all);

}  // namespace muckpile::engine
