// SPDX-License-Identifier: GPL-2.0-or-later
// What the phases of a blast ask of the rock and its gas, and change there.
// Scope: an interface only, as RunEngine, and collective like it.
#pragma once

#include <optional>

namespace muckpile {

class BlastedRock {
 public:
  virtual ~BlastedRock() = default;

  /// Stiffness of the joints over that at the start [-]; 1 until they are softened.
  [[nodiscard]] virtual double stiffness() const = 0;
  [[nodiscard]] virtual double elastic_energy() const = 0;  ///< of the joints [J]
  [[nodiscard]] virtual double kinetic_energy() const = 0;  ///< [J]
  [[nodiscard]] virtual double blast_work() const = 0;      ///< done on the rock so far [J]
  [[nodiscard]] virtual double wall_pressure() const = 0;   ///< greatest on a hole's wall [Pa]
  [[nodiscard]] virtual double joint_pressure() const = 0;  ///< of gas in any joint, or 0 [Pa]

  /// Multiplies the stiffness of the joints; `damping` of closed ones as a share of the softer
  /// rock's impedance [-].
  virtual void soften(double factor, std::optional<double> damping) = 0;
  virtual void let_blocks_rest() = 0;  ///< blocks at rest are left alone from now on
};

}  // namespace muckpile
