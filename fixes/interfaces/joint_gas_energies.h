// SPDX-License-Identifier: GPL-2.0-or-later
// Where the energy of the gas that flowed into joints is.
// Scope: an interface only; fix muckpile/gas implements it, fix muckpile/blast reads it.
#pragma once

namespace muckpile {

class JointGasEnergies {
 public:
  virtual ~JointGasEnergies() = default;
  /// Of all ranks so far [J].
  struct Sums {
    double work = 0.0;       ///< on the blocks
    double air_work = 0.0;   ///< on the atmosphere
    double heat = 0.0;       ///< into the walls of joints, net
    double contained = 0.0;  ///< internal energy in joints now
    double vented = 0.0;     ///< let into the open
  };
  /// Collective.
  [[nodiscard]] virtual Sums gas_energies() const = 0;
};

}  // namespace muckpile
