// SPDX-License-Identifier: GPL-2.0-or-later
// What others ask of the blast: whether it goes on, and what it has done.
// Scope: an interface only; fix muckpile/blast implements it, fix muckpile/sleep, fix
// muckpile/progress and run_blast read it.
#pragma once

#include <vector>

#include "explosive/energy_audit.h"

namespace muckpile {

class BlastEnergies {
 public:
  virtual ~BlastEnergies() = default;
  /// [J]
  struct Energies {
    double explosive = 0.0;        ///< of all charges, fired or not; 0 if not known
    double wave = 0.0, gas = 0.0;  ///< work on the blocks so far
  };
  /// Collective.
  [[nodiscard]] virtual Energies energies() const = 0;
  /// Where the energy of the charges that have fired is. Collective.
  [[nodiscard]] virtual EnergyAudit audit() const = 0;
  /// The same hole by hole; zeros before a hole fires.
  [[nodiscard]] virtual std::vector<HoleAudit> hole_audits() const = 0;
  /// On a wall of a crushed zone now, of all ranks [Pa]. Collective.
  [[nodiscard]] virtual double greatest_pressure() const = 0;
  /// True once no hole will press any more.
  [[nodiscard]] virtual bool over() const = 0;
};

}  // namespace muckpile
