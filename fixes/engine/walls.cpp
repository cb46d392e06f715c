// SPDX-License-Identifier: GPL-2.0-or-later
// Whether walls are at rest: asks LIGGGHTS' fixes.
// Scope: see the header. That of fix wall/gran includes lists of contact models which Debian does
// not package; empty ones of fixes/CMakeLists.txt take their place: the class does not depend on
// them.
#include "fixes/engine/walls.h"

#include <fix_mesh_surface.h>
#include <fix_wall_gran.h>
#include <lammps.h>
#include <modify.h>

#include <string_view>

namespace muckpile::engine {
namespace {

bool moves(LAMMPS_NS::Fix* fix) {
  if (auto* const wall = dynamic_cast<LAMMPS_NS::FixWallGran*>(fix)) return wall->is_moving() != 0;
  auto* const mesh = dynamic_cast<LAMMPS_NS::FixMesh*>(fix);
  return mesh != nullptr && (mesh->mesh()->isMoving() || mesh->surfaceVel());
}

bool is_known(std::string_view style) {
  return style == "gravity" || style.substr(0, 9) == "wall/gran" ||
         style.find("muckpile") != style.npos || style.substr(0, 11) == "multisphere";
}

}  // namespace

bool walls_stand_still(LAMMPS_NS::LAMMPS& lmp) {
  const LAMMPS_NS::Modify& modify = *lmp.modify;
  for (int f = 0; f < modify.nfix; ++f) {
    const bool pushes = (modify.fmask[f] & LAMMPS_NS::FixConst::POST_FORCE) != 0;
    if (moves(modify.fix[f]) || (pushes && !is_known(modify.fix[f]->style))) return false;
  }
  return true;
}

std::string wall_on_mesh(LAMMPS_NS::LAMMPS& lmp, const LAMMPS_NS::FixMeshSurface& mesh) {
  for (int f = 0; f < lmp.modify->nfix; ++f) {
    auto* const wall = dynamic_cast<LAMMPS_NS::FixWallGran*>(lmp.modify->fix[f]);
    for (int m = 0; wall != nullptr && wall->is_mesh_wall() && m < wall->n_meshes(); ++m)
      if (wall->mesh_list()[m] == &mesh) return wall->id;
  }
  return "";
}

}  // namespace muckpile::engine
