// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS regions by name.
// Scope: regions may be deleted between runs, so the pointer is not kept.
#pragma once

#include <string>

#include "math/types.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// Stops the run, with a message that begins with `where`, if there is no such region.
void require_region(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& name);

[[nodiscard]] bool in_region(LAMMPS_NS::LAMMPS& lmp, const std::string& name, const Vec3& point);

}  // namespace muckpile::engine
