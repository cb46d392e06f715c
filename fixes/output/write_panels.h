// SPDX-License-Identifier: GPL-2.0-or-later
// write_panels: writes floors, walls and gates of a scene as an STL file.
// Scope: words to the core, its text to a file.
#pragma once

#include <pointers.h>

namespace muckpile {

class WritePanelsCommand : protected LAMMPS_NS::Pointers {
 public:
  explicit WritePanelsCommand(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);
};

}  // namespace muckpile
