// SPDX-License-Identifier: GPL-2.0-or-later
// block_motion: gives blocks velocity, spin and pushes.
// Scope: bodies of the one fix multisphere, picked by a region of their centres; before the first
// run and between runs.
#pragma once

#include <pointers.h>

#include <string>
#include <vector>

#include "motion/given_motion.h"

namespace muckpile {

class BlockMotionCommand : protected LAMMPS_NS::Pointers {
 public:
  explicit BlockMotionCommand(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);

 private:
  [[nodiscard]] std::vector<std::string> words_with_values(int narg, char** arg) const;
  [[nodiscard]] double value_of(const std::string& name) const;
  [[nodiscard]] std::vector<int> bodies_in(const std::string& region) const;
  void check_count(const std::string& region, const std::vector<int>& bodies, bool only_one) const;
  /// What they have then; stops the run where one would be too fast.
  [[nodiscard]] std::vector<MovingBody> moved_bodies(const std::vector<int>& bodies,
                                                     const GivenMotion& given) const;
  void hand_over(const std::vector<int>& bodies, const std::vector<MovingBody>& states);
  void tell_spheres(const std::vector<int>& bodies) const;
};

}  // namespace muckpile
