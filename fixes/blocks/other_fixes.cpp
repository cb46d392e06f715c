// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS' fixes that move or hold loose particles: refused, or warned of.
// Scope: see the header.
#include "fixes/blocks/other_fixes.h"

#include <atom.h>
#include <comm.h>
#include <error.h>
#include <fix.h>
#include <modify.h>

#include <string_view>

#include "fixes/engine/bodies.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"

namespace muckpile {
namespace {

bool moves_particles(std::string_view style) {
  return style.starts_with("nve") || style.starts_with("rigid") || style == "move";
}

bool holds_particles(std::string_view style) {
  return style == "freeze" || style == "setforce" || style == "aveforce" || style == "momentum";
}

bool is_on_blocks(LAMMPS_NS::LAMMPS& lmp, LAMMPS_NS::FixMultisphere& bodies,
                  const LAMMPS_NS::Fix& fix) {
  bool mine = false;
  for (int k = 0; k < lmp.atom->nlocal; ++k)
    if (bodies.belongs_to(k) >= 0 && (lmp.atom->mask[k] & fix.groupbit) != 0) mine = true;
  return engine::on_any_rank(mine, lmp.world);
}

}  // namespace

void refuse_other_movers(LAMMPS_NS::LAMMPS& lmp, LAMMPS_NS::FixMultisphere& bodies) {
  for (int f = 0; f < lmp.modify->nfix; ++f) {
    const LAMMPS_NS::Fix& fix = *lmp.modify->fix[f];
    if (moves_particles(fix.style) && is_on_blocks(lmp, bodies, fix))
      engine::stop(lmp, engine::name_of(fix) +
                            ": must not move the spheres of blocks, which fix multisphere moves; "
                            "take it out, or give it a group without them");
  }
}

void warn_of_other_holders(LAMMPS_NS::LAMMPS& lmp, LAMMPS_NS::FixMultisphere& bodies,
                           std::set<std::string>& told) {
  for (int f = 0; f < lmp.modify->nfix; ++f) {
    const LAMMPS_NS::Fix& fix = *lmp.modify->fix[f];
    if (!holds_particles(fix.style) || !is_on_blocks(lmp, bodies, fix)) continue;
    if (!told.insert(engine::name_of(fix)).second || lmp.comm->me != 0) continue;
    lmp.error->warning(
        FLERR,
        (engine::name_of(fix) +
         ": takes the contacts of blocks, but neither their joints nor their weight, so it does "
         "not hold them; hold rock by 'support fixed' of create_blocks, stop it by "
         "block_motion")
            .c_str());
  }
}

}  // namespace muckpile
