// SPDX-License-Identifier: GPL-2.0-or-later
// The rock of a script, its charges and gas, as the phases of a blast ask for them.
// Scope: core's BlastedRock, from the interfaces of the styles. Collective.
#pragma once

#include <pointers.h>

#include <optional>

#include "run/blasted_rock.h"

namespace muckpile {

class BlastEnergies;
class BlastSurface;
class JointEnergies;
class JointPressure;

class ScriptRock : public BlastedRock, protected LAMMPS_NS::Pointers {
 public:
  /// Needs fix muckpile/joint and fix muckpile/blast. `sleep_distance` of fix muckpile/sleep [m].
  ScriptRock(LAMMPS_NS::LAMMPS* engine, double sleep_distance);

  [[nodiscard]] double stiffness() const override;
  [[nodiscard]] double elastic_energy() const override;
  /// Needs fix muckpile/ledger.
  [[nodiscard]] double kinetic_energy() const override;
  [[nodiscard]] double blast_work() const override;
  [[nodiscard]] double wall_pressure() const override;
  [[nodiscard]] double joint_pressure() const override;

  void soften(double factor, std::optional<double> damping) override;
  void let_blocks_rest() override;

 private:
  double sleep_distance_;
  const BlastSurface* surface_;
  const JointEnergies* joints_;
  const BlastEnergies* blast_;
  const JointPressure* gas_;  ///< no gas in joints: null
};

}  // namespace muckpile
