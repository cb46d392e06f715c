// SPDX-License-Identifier: GPL-2.0-or-later
// velocity, displace_atoms and set: the warning, and LIGGGHTS' commands.
// Scope: see the header.
#include "fixes/contact/sphere_commands.h"

#include <atom.h>
#include <comm.h>
#include <displace_atoms.h>
#include <domain.h>
#include <error.h>
#include <fix_multisphere.h>
#include <force.h>
#include <group.h>
#include <region.h>
#include <set.h>
#include <velocity.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "fixes/engine/bodies.h"
#include "fixes/engine/over_ranks.h"

namespace muckpile {
namespace {

/// That `set` may change, of those that blocks prescribe to their spheres.
constexpr std::array<std::string_view, 9> kMotion = {"x",  "y",      "z",      "vx",    "vy",
                                                     "vz", "omegax", "omegay", "omegaz"};

}  // namespace

SphereCommands::Selection SphereCommands::in_group(const char* name) const {
  const int number = group->find(name);
  const int bit = number >= 0 ? group->bitmask[number] : 0;
  return [this, bit](int k) { return (atom->mask[k] & bit) != 0; };
}

SphereCommands::Selection SphereCommands::selected(const std::string& style, char* id) const {
  if (style == "group") return in_group(id);
  const int region_number = style == "region" ? domain->find_region(id) : -1;
  if (region_number >= 0) {
    domain->regions[region_number]->prematch();
    return [this, region = domain->regions[region_number]](int k) {
      const double* const x = atom->x[k];
      return region->match(x[0], x[1], x[2]) != 0;
    };
  }
  int low = 0, high = 0;
  if (style == "type") {
    force->bounds(id, atom->ntypes, low, high);
    return [this, low, high](int k) { return atom->type[k] >= low && atom->type[k] <= high; };
  }
  if (style == "atom") {
    force->bounds(id, std::numeric_limits<int>::max(), low, high);
    return [this, low, high](int k) { return atom->tag[k] >= low && atom->tag[k] <= high; };
  }
  return [](int) { return false; };
}

void SphereCommands::warn(const char* command, const Selection& selection) const {
  LAMMPS_NS::FixMultisphere* const bodies = engine::find_multisphere(*lmp);
  if (bodies == nullptr) return;
  bool mine = false;
  for (int k = 0; k < atom->nlocal; ++k)
    if (bodies->belongs_to(k) >= 0 && selection(k)) mine = true;
  if (!engine::on_any_rank(mine, world) || comm->me != 0) return;
  error->warning(FLERR, (std::string(command) +
                         ": has no effect on blocks, whose spheres go where the block goes; use "
                         "block_motion")
                            .c_str());
}

void SphereCommands::velocity(int narg, char** arg) {
  if (narg > 0) warn("velocity", in_group(arg[0]));
  LAMMPS_NS::Velocity(lmp).command(narg, arg);
}

void SphereCommands::displace_atoms(int narg, char** arg) {
  if (narg > 0) warn("displace_atoms", in_group(arg[0]));
  LAMMPS_NS::DisplaceAtoms(lmp).command(narg, arg);
}

void SphereCommands::set(int narg, char** arg) {
  const bool moves = narg > 2 && std::any_of(arg + 2, arg + narg, [](const char* word) {
                       return std::find(kMotion.begin(), kMotion.end(), word) != kMotion.end();
                     });
  if (moves) warn("set", selected(arg[0], arg[1]));
  LAMMPS_NS::Set(lmp).command(narg, arg);
}

}  // namespace muckpile
