// SPDX-License-Identifier: GPL-2.0-or-later
// How far the joints of the whole model have broken or been softened.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/progress reads it.
#pragma once

namespace muckpile {

class JointDamage {
 public:
  virtual ~JointDamage() = default;
  /// Joints with at least one broken point, of all ranks. Collective.
  [[nodiscard]] virtual double joints_broken() const = 0;
  /// Stiffness of the joints over that at the start [-].
  [[nodiscard]] virtual double softened() const = 0;
};

}  // namespace muckpile
