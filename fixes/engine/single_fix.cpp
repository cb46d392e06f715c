// SPDX-License-Identifier: GPL-2.0-or-later
// Styles of which a run may have one fix only.
// Scope: see the header.
#include "engine/single_fix.h"

#include <fix.h>
#include <lammps.h>
#include <modify.h>

#include "engine/style_args.h"

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

}  // namespace muckpile::engine
