// SPDX-License-Identifier: GPL-2.0-or-later
// write_scene: what a run is about, as one JSON file: the case, its measures, every knob, and the
// program that runs it.
// Scope: once per run, behind create_blocks or read_restart; says as well which knobs a run that
// goes on may change.
#pragma once

#include <pointers.h>

namespace muckpile {

class WriteScene : protected LAMMPS_NS::Pointers {
 public:
  explicit WriteScene(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);
};

}  // namespace muckpile
