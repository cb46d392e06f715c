// SPDX-License-Identifier: GPL-2.0-or-later
// What walls LIGGGHTS has: whether they are at rest, and on which mesh.
// Scope: LIGGGHTS' fix wall/gran; the one file that includes its header.
#pragma once

#include <string>

namespace LAMMPS_NS {
class FixMeshSurface;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace muckpile::engine {

/// False where a wall moves, or slides along itself, and where a fix that we do not know pushes
/// spheres.
[[nodiscard]] bool walls_stand_still(LAMMPS_NS::LAMMPS& lmp);

/// ID of the first fix wall/gran of the script that has this mesh, "" if none has.
[[nodiscard]] std::string wall_on_mesh(LAMMPS_NS::LAMMPS& lmp,
                                       const LAMMPS_NS::FixMeshSurface& mesh);

}  // namespace muckpile::engine
