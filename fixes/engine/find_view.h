// SPDX-License-Identifier: GPL-2.0-or-later
// Finds the fix that implements one of the interfaces in fixes/interfaces.
// Scope: pointers hold until a fix is deleted; look them up anew in init().
#pragma once

#include <fix.h>
#include <lammps.h>
#include <modify.h>

namespace muckpile::engine {

/// Place of the last such fix among the fixes, -1 if there is none.
template <class View>
[[nodiscard]] int place_of(const LAMMPS_NS::LAMMPS& lmp) {
  for (int i = lmp.modify->nfix - 1; i >= 0; --i) {
    if (dynamic_cast<View*>(lmp.modify->fix[i]) != nullptr) return i;
  }
  return -1;
}

/// That fix, nullptr if there is none.
template <class View>
[[nodiscard]] View* find_view(const LAMMPS_NS::LAMMPS& lmp) {
  const int place = place_of<View>(lmp);
  return place < 0 ? nullptr : dynamic_cast<View*>(lmp.modify->fix[place]);
}

}  // namespace muckpile::engine
