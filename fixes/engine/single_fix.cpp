// SPDX-License-Identifier: GPL-2.0-or-later
// Styles of which a run may have one fix only, and those that go on from a restart file.
// Scope: see the header.
#include "fixes/engine/single_fix.h"

#include <fix.h>
#include <lammps.h>
#include <modify.h>

#include "fixes/engine/style_args.h"

namespace muckpile::engine {

void refuse_second_fix(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& style) {
  for (int i = 0; i < lmp.modify->nfix; ++i) {
    // Modify::add_fix leaves an empty slot while it replaces a fix.
    if (lmp.modify->fix[i] == nullptr)
      stop(lmp, where + ": a fix of this ID exists; unfix it before");
    if (lmp.modify->fix[i]->style == style)
      stop(lmp, where + ": only one fix " + style + " is possible");
  }
}

void require_id_of_restart(LAMMPS_NS::LAMMPS& lmp, const std::string& where, LAMMPS_NS::Fix& fix) {
  LAMMPS_NS::Modify& modify = *lmp.modify;
  if (!modify.have_restart_data_style(fix.style) || modify.have_restart_data(&fix)) return;
  stop(lmp, where + ": must have the ID that it had when the restart file was written");
}

}  // namespace muckpile::engine
