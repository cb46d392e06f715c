// SPDX-License-Identifier: GPL-2.0-or-later
// velocity, displace_atoms and set: LIGGGHTS' commands, after a warning where they are about
// blocks. Scope: what they do to spheres that belong to no block is LIGGGHTS' own.
#pragma once

#include <pointers.h>

#include <functional>
#include <string>

namespace muckpile {

class SphereCommands : protected LAMMPS_NS::Pointers {
 public:
  explicit SphereCommands(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void velocity(int narg, char** arg);
  void displace_atoms(int narg, char** arg);
  void set(int narg, char** arg);

 private:
  using Selection = std::function<bool(int sphere)>;
  [[nodiscard]] Selection in_group(const char* name) const;
  /// What `set STYLE ID` acts on; nothing if that is none of LIGGGHTS' words.
  [[nodiscard]] Selection selected(const std::string& style, char* id) const;
  void warn(const char* command, const Selection& selection) const;
};

}  // namespace muckpile
