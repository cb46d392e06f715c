// SPDX-License-Identifier: GPL-2.0-or-later
// Whoever knows the pressure of gas in the broken joints.
// Scope: an interface only; fix muckpile/gas implements it, fix muckpile/joint, fix
// muckpile/sleep and run_blast call it.
#pragma once

#include <span>

namespace muckpile {

class JointPressure {
 public:
  virtual ~JointPressure() = default;
  /// What the gas of each block, owned ones and copies, the ground last, presses beyond the
  /// atmosphere [Pa], in the pose of now, just before the forces. Empty: as it was set before.
  /// Valid until the next call. Collective.
  [[nodiscard]] virtual std::span<const double> pressure_in_joints() = 0;
  /// Of the gas in joints, of all ranks [Pa]. Collective.
  [[nodiscard]] virtual double greatest_in_joints() const = 0;
  /// Pressures hold no longer than this, or for one step of the blocks [s].
  [[nodiscard]] virtual double longest_step() const = 0;
  /// True while there is gas that may reach more joints.
  [[nodiscard]] virtual bool acts() const = 0;
};

}  // namespace muckpile
