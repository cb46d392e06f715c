// SPDX-License-Identifier: GPL-2.0-or-later
// require: stops an input script whose variable is not a number in the range that the script needs.
// Scope: a check only; nothing is kept.
#pragma once

#include <pointers.h>

#include <string>
#include <vector>

namespace muckpile {

class Require : protected LAMMPS_NS::Pointers {
 public:
  explicit Require(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);

 private:
  void set_flag(std::string name, bool value) const;
  /// Of a variable, which must be set.
  void require_set(char* variable) const;
  [[nodiscard]] std::string text_of(char* variable) const;
  void look_at_needed(char* name, const std::vector<char*>& words) const;
  void look_at_run(const std::string& name, const std::string& folder,
                   const std::vector<std::string>& words) const;
  void look_at_folder(const std::string& name, const std::string& value,
                      const std::vector<std::string>& words) const;
};

}  // namespace muckpile
