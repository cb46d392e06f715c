// SPDX-License-Identifier: GPL-2.0-or-later
// Whether the forces on spheres that are neither of contacts nor of gravity are of walls at rest.
// Scope: LIGGGHTS' fix wall/gran; the one file that includes its header.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// False where a wall moves, or slides along itself, and where a fix that we do not know pushes
/// spheres.
[[nodiscard]] bool walls_stand_still(LAMMPS_NS::LAMMPS& lmp);

}  // namespace muckpile::engine
