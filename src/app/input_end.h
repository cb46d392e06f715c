// SPDX-License-Identifier: GPL-2.0-or-later
// Whether all of an input script has run: LIGGGHTS ends well, too, where a signal has made it leave
// out the rest.
// Scope: the script behind -in, or of the standard input; of what a script does after a signal
// nothing is known.
#pragma once

#include <cstdio>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile {

class InputEnd {
 public:
  /// Before the script is read.
  explicit InputEnd(const LAMMPS_NS::LAMMPS& lmp);

  /// The line that says how it ended, on the first rank, which alone reads.
  [[nodiscard]] std::string line(const LAMMPS_NS::LAMMPS& lmp) const;

 private:
  [[nodiscard]] bool nothing_left(const LAMMPS_NS::LAMMPS& lmp) const;
  std::FILE* script_ = nullptr;
  int number_ = -1;           // of the open file
  bool ends_plainly_ = true;  // its last command runs no others
};

/// In the log, and on the screen where something was cut short.
void tell_end(const LAMMPS_NS::LAMMPS& lmp, const std::string& line);

}  // namespace muckpile
