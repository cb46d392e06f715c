// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS regions by name.
// Scope: see the header.
#include "fixes/engine/region.h"

#include <domain.h>
#include <lammps.h>
#include <region.h>

#include "fixes/engine/style_args.h"

namespace muckpile::engine {

void require_region(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& name) {
  if (lmp.domain->find_region(name.c_str()) < 0)
    stop(lmp, where + ": region must exist, got '" + name + "'");
}

bool in_region(LAMMPS_NS::LAMMPS& lmp, const std::string& name, const Vec3& point) {
  LAMMPS_NS::Region& region = *lmp.domain->regions[lmp.domain->find_region(name.c_str())];
  return region.match(point.x(), point.y(), point.z()) != 0;
}

}  // namespace muckpile::engine
