// SPDX-License-Identifier: GPL-2.0-or-later
// velocity, displace_atoms and set: the warning, and LIGGGHTS' commands.
// Scope: see the header.
#include "sphere_commands.h"

#include <atom.h>
#include <comm.h>
#include <displace_atoms.h>
#include <error.h>
#include <fix_multisphere.h>
#include <group.h>
#include <set.h>
#include <velocity.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "engine/bodies.h"

namespace muckpile {
namespace {

/// That `set` may change, of those that blocks prescribe to their spheres.
constexpr std::array<std::string_view, 9> kMotion = {"x",  "y",      "z",      "vx",    "vy",
                                                     "vz", "omegax", "omegay", "omegaz"};

}  // namespace

void SphereCommands::warn(const char* command, int group_bit) const {
  LAMMPS_NS::FixMultisphere* const bodies = engine::find_multisphere(*lmp);
  if (bodies == nullptr) return;
  int mine = 0, all = 0;
  for (int k = 0; k < atom->nlocal; ++k)
    if ((atom->mask[k] & group_bit) != 0 && bodies->belongs_to(k) >= 0) mine = 1;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  if (all == 0 || comm->me != 0) return;
  error->warning(FLERR, (std::string(command) +
                         ": has no effect on blocks, whose spheres go where the block goes; use "
                         "block_motion")
                            .c_str());
}

void SphereCommands::velocity(int narg, char** arg) {
  const int group_number = narg > 0 ? group->find(arg[0]) : -1;
  if (group_number >= 0) warn("velocity", group->bitmask[group_number]);
  LAMMPS_NS::Velocity(lmp).command(narg, arg);
}

void SphereCommands::displace_atoms(int narg, char** arg) {
  const int group_number = narg > 0 ? group->find(arg[0]) : -1;
  if (group_number >= 0) warn("displace_atoms", group->bitmask[group_number]);
  LAMMPS_NS::DisplaceAtoms(lmp).command(narg, arg);
}

void SphereCommands::set(int narg, char** arg) {
  const bool moves = std::any_of(arg, arg + narg, [](const char* word) {
    return std::find(kMotion.begin(), kMotion.end(), word) != kMotion.end();
  });
  constexpr int kAll = 1;  // bit of the group `all`
  if (moves) warn("set", kAll);
  LAMMPS_NS::Set(lmp).command(narg, arg);
}

}  // namespace muckpile
