// SPDX-License-Identifier: GPL-2.0-or-later
// velocity, displace_atoms and set: LIGGGHTS' commands, after a warning where they are about
// blocks. Scope: what they do to spheres that belong to no block is LIGGGHTS' own.
#pragma once

#include <pointers.h>

namespace muckpile {

class SphereCommands : protected LAMMPS_NS::Pointers {
 public:
  explicit SphereCommands(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void velocity(int narg, char** arg);
  void displace_atoms(int narg, char** arg);
  void set(int narg, char** arg);

 private:
  void warn(const char* command, int group_bit) const;
};

}  // namespace muckpile
