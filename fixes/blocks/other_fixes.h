// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS' fixes that move or hold loose particles, on spheres of blocks.
// Scope: a block goes where its joints, its contacts and gravity push it, and its spheres with it.
#pragma once

#include <fix_multisphere.h>
#include <lammps.h>

#include <set>
#include <string>

namespace muckpile {

/// Stops where a fix moves spheres of blocks: moved a second time they are a step ahead of their
/// block as contacts are computed.
void refuse_other_movers(LAMMPS_NS::LAMMPS& lmp, LAMMPS_NS::FixMultisphere& bodies);

/// Of fixes that hold particles, each once: they take the contacts of a block's spheres, but
/// neither its joints nor its weight. `told`: names of those that have been warned of.
void warn_of_other_holders(LAMMPS_NS::LAMMPS& lmp, LAMMPS_NS::FixMultisphere& bodies,
                           std::set<std::string>& told);

}  // namespace muckpile
