// SPDX-License-Identifier: GPL-2.0-or-later
// hole_pattern: a hole table from rows, burden, spacing, angles and delays.
// Scope: writes the file; create_blocks, charge_design and fix muckpile/blast read it.
#pragma once

#include <pointers.h>

namespace muckpile {

class HolePatternCommand : protected LAMMPS_NS::Pointers {
 public:
  explicit HolePatternCommand(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);
};

}  // namespace muckpile
