// SPDX-License-Identifier: GPL-2.0-or-later
// Whether anything keeps blocks without joints from passing through each other.
// Scope: see the header.
#include "fixes/engine/pair_style_check.h"

#include <comm.h>
#include <error.h>
#include <force.h>
#include <lammps.h>

#include <string>

namespace muckpile::engine {

bool has_contact_law(LAMMPS_NS::LAMMPS& lmp) { return lmp.force->pair != nullptr; }

void warn_without_contact_law(LAMMPS_NS::LAMMPS& lmp) {
  LAMMPS_NS::Force& force = *lmp.force;
  if (lmp.comm->me != 0 || force.pair_match("muckpile/block", 1) != nullptr) return;
  const std::string fault =
      force.pair == nullptr
          ? std::string(
                "there is no pair_style: blocks that no joint holds pass through each other")
          : std::string("pair_style ") + force.pair_style +
                " knows no joints: it acts between the spheres of joined blocks too";
  lmp.error->warning(
      FLERR, ("create_blocks: " + fault + "; give 'pair_style muckpile/block' and 'pair_coeff * *'")
                 .c_str());
}

}  // namespace muckpile::engine
