// SPDX-License-Identifier: GPL-2.0-or-later
// What an account of energy needs of the joints.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/ledger and
// fix muckpile/progress read it.
#pragma once

#include <span>

#include "math/types.h"

namespace muckpile {

/// Of this rank [J]. Every joint is counted once over all ranks.
struct JointEnergySums {
  double elastic = 0.0;                                  ///< stored now
  double fracture = 0.0, friction = 0.0, damping = 0.0;  ///< lost so far
  double crushing = 0.0;                                 ///< of friction, taken by walls that crush
  double quiet = 0.0;          ///< given to the rock behind yielding supports so far
  double pressure_work = 0.0;  ///< done by blast and gas so far
};

class JointEnergies {
 public:
  virtual ~JointEnergies() = default;
  [[nodiscard]] virtual JointEnergySums energies() const = 0;
  /// What the last force computation put on each body of this rank, in body order [N], [N m].
  [[nodiscard]] virtual std::span<const Vec3> joint_forces() const = 0;
  [[nodiscard]] virtual std::span<const Vec3> joint_torques() const = 0;
};

}  // namespace muckpile
