// SPDX-License-Identifier: GPL-2.0-or-later
// run_blast: runs a blast from its first wave until the rock rests.
// Scope: from the words and the styles of the script to core's BlastRun.
#pragma once

#include <pointers.h>

#include "run/blast_scene.h"

namespace muckpile {

class RunBlastCommand : protected LAMMPS_NS::Pointers {
 public:
  static constexpr const char* kStyle = "run_blast";

  explicit RunBlastCommand(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);

 private:
  [[nodiscard]] BlastScene scene() const;
  void warn_without_gravity() const;
  void warn_of_missing_energy() const;
};

}  // namespace muckpile
