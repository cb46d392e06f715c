// SPDX-License-Identifier: GPL-2.0-or-later
// BlastedRock on LIGGGHTS.
// Scope: see the header.
#include "fixes/run/script_rock.h"

#include <string>

#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/interfaces/blast_energies.h"
#include "fixes/interfaces/blast_surface.h"
#include "fixes/interfaces/energy_account.h"
#include "fixes/interfaces/joint_energies.h"
#include "fixes/interfaces/joint_pressure.h"
#include "fixes/run/script_words.h"

namespace muckpile {

ScriptRock::ScriptRock(LAMMPS_NS::LAMMPS* engine, double sleep_distance)
    : Pointers(engine),
      sleep_distance_(sleep_distance),
      surface_(engine::find_view<BlastSurface>(*lmp)),
      joints_(engine::find_view<JointEnergies>(*lmp)),
      blast_(engine::find_view<BlastEnergies>(*lmp)),
      gas_(engine::find_view<JointPressure>(*lmp)) {}

double ScriptRock::stiffness() const { return surface_->softened(); }

double ScriptRock::elastic_energy() const {
  return engine::sum_over_ranks(joints_->energies().elastic, world);
}

double ScriptRock::kinetic_energy() const {
  return engine::find_view<EnergyAccount>(*lmp)->ledger().kinetic;
}

double ScriptRock::blast_work() const {
  return engine::sum_over_ranks(surface_->pressure_work(), world);
}

double ScriptRock::wall_pressure() const { return blast_->greatest_pressure(); }

double ScriptRock::joint_pressure() const {
  return gas_ == nullptr ? 0.0 : gas_->greatest_in_joints();
}

void ScriptRock::soften(double factor, std::optional<double> damping) {
  const std::string id = fix_of(*lmp, "muckpile/joint")->id;
  tell_script(*lmp, "fix_modify " + id + " soften " + script_number(factor) +
                        (damping ? " damping " + script_number(*damping) : std::string()));
}

void ScriptRock::let_blocks_rest() {
  make_fix(*lmp, "muckpile/sleep", "sleep", "distance " + script_number(sleep_distance_));
}

}  // namespace muckpile
