// SPDX-License-Identifier: GPL-2.0-or-later
// charge_design: an explosive's numbers and its crushed zone as variables of the input script.
// Scope: looks up, prints and sets variables; the load itself is fix muckpile/blast.
#pragma once

#include <pointers.h>

namespace muckpile {

class ChargeDesignCommand : protected LAMMPS_NS::Pointers {
 public:
  explicit ChargeDesignCommand(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);
};

}  // namespace muckpile
