// SPDX-License-Identifier: GPL-2.0-or-later
// Whether anything keeps blocks without joints from passing through each other.
// Scope: looks at the pair style; walls are no matter of it.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// False without any pair style.
[[nodiscard]] bool has_contact_law(LAMMPS_NS::LAMMPS& lmp);

/// Warns, on rank 0, where blocks have no pair style muckpile/block.
void warn_without_contact_law(LAMMPS_NS::LAMMPS& lmp);

}  // namespace muckpile::engine
