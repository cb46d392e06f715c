// SPDX-License-Identifier: GPL-2.0-or-later
// Whether walls are at rest: asks LIGGGHTS' fixes.
// Scope: see the header. That of fix wall/gran includes lists of contact models which Debian does
// not package; empty ones of fixes/CMakeLists.txt take their place: the class does not depend on
// them.
#include "engine/walls.h"

#include <fix_mesh_surface.h>
#include <fix_wall_gran.h>
#include <lammps.h>
#include <modify.h>

#include <string_view>

namespace muckpile::engine {
namespace {

bool stands_still(LAMMPS_NS::FixWallGran& wall) {
  if (wall.is_moving() != 0) return false;
  for (int m = 0; wall.is_mesh_wall() && m < wall.n_meshes(); ++m)
    if (wall.mesh_list()[m]->surfaceVel()) return false;
  return true;
}

bool is_known(std::string_view style) {
  return style == "gravity" || style.find("muckpile") != style.npos ||
         style.substr(0, 11) == "multisphere";
}

}  // namespace

bool walls_stand_still(LAMMPS_NS::LAMMPS& lmp) {
  const LAMMPS_NS::Modify& modify = *lmp.modify;
  for (int f = 0; f < modify.nfix; ++f) {
    auto* const wall = dynamic_cast<LAMMPS_NS::FixWallGran*>(modify.fix[f]);
    const bool pushes = (modify.fmask[f] & LAMMPS_NS::FixConst::POST_FORCE) != 0;
    if (wall != nullptr ? !stands_still(*wall) : pushes && !is_known(modify.fix[f]->style))
      return false;
  }
  return true;
}

}  // namespace muckpile::engine
