// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/blast: energies and their audit, outputs, restart.
// Scope: what has been booked; nothing here changes the load.
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/restart_file.h"
#include "fixes/explosive/fix_muckpile_blast.h"
#include "fixes/interfaces/joint_gas_energies.h"

namespace muckpile {
namespace {

// What compute_vector() returns, by position.
enum Output {
  kMaximumPressure,
  kGasPressure,
  kSweptVolume,
  kWork,
  kActiveHoles,
  kOver,
  kWaveWork,
  kGasWork,
  kExplosiveEnergy,
  kExplosiveMass,
  kGasLeft,
  kAudit,  // all terms of EnergyAudit but the first, then its error
  kOutputCount = kAudit + static_cast<int>(EnergyAudit::kTerms.size())
};

// What compute_array() returns of a hole, by column.
constexpr std::array kHoleColumns = {&EnergyAudit::explosive, &EnergyAudit::not_released,
                                     &EnergyAudit::filling,   &EnergyAudit::crushing,
                                     &EnergyAudit::wall_work, &EnergyAudit::in_holes,
                                     &EnergyAudit::vented};

}  // namespace

const int FixMuckpileBlast::kOutputs = kOutputCount;
const int FixMuckpileBlast::kHoleOutputs = static_cast<int>(kHoleColumns.size()) + 1;

BlastEnergies::Energies FixMuckpileBlast::energies() const {
  Energies energies;
  for (const HoleCharge& charge : charges_) energies.explosive += charge.energy;
  if (const BlastSurface* surface = engine::find_view<BlastSurface>(*lmp)) {
    energies.wave = engine::sum_over_ranks(surface->wave_work(), world);
    energies.gas = engine::sum_over_ranks(surface->pressure_work(), world) - energies.wave;
  }
  return energies;
}

/// Without what its gas has done in joints.
EnergyAudit FixMuckpileBlast::audit_of(std::size_t hole) const {
  const HoleBlast& blast = blasts_[hole];
  const double now = clock_started_ ? clock() : clock_restarted_;
  if (now < blast.firing_time()) return {};
  const double in_hole =
      hole_over_[hole] ? 0.0 : blast.gas_energy(swept_[hole], now, states_[hole]);
  return audit_of_hole(blast.load(), charges_[hole].energy, in_hole, states_[hole], books_[hole],
                       ambient_);
}

EnergyAudit FixMuckpileBlast::audit() const {
  EnergyAudit all;
  for (std::size_t hole = 0; hole < blasts_.size(); ++hole) all += audit_of(hole);
  if (const auto* joints = engine::find_view<JointGasEnergies>(*lmp)) {
    const JointGasEnergies::Sums gas = joints->gas_energies();
    all.joint_work += gas.work;
    all.air_work += gas.air_work;
    all.rock_heat += gas.heat;
    all.in_joints += gas.held;
    all.vented += gas.vented;
  }
  return all;
}

double FixMuckpileBlast::compute_array(int row, int column) {
  const auto hole = static_cast<std::size_t>(row), term = static_cast<std::size_t>(column);
  if (hole >= blasts_.size()) return 0.0;
  return term < kHoleColumns.size() ? audit_of(hole).*kHoleColumns[term] : books_[hole].into_joints;
}

double FixMuckpileBlast::compute_vector(int index) {
  const BlastSurface* surface =
      engine::find_view<BlastSurface>(*lmp);  // between runs it may have been unfixed
  if (surface == nullptr || blasts_.empty()) return 0.0;
  if (index >= kAudit) {
    const EnergyAudit all = audit();
    const auto term = static_cast<std::size_t>(index - kAudit) + 1;
    return term < EnergyAudit::kTerms.size() ? all.*EnergyAudit::kTerms[term].value : all.error();
  }
  switch (index) {
    case kMaximumPressure:
      return greatest_pressure();
    case kGasPressure:
      return gas_.front();
    case kSweptVolume:
      return std::accumulate(swept_.begin(), swept_.end(), 0.0);
    case kWork:
      return engine::sum_over_ranks(surface->pressure_work(), world);
    case kActiveHoles:
      return active_holes_;
    case kOver:
      return over_ ? 1.0 : 0.0;
    case kWaveWork:
      return energies().wave;
    case kGasWork:
      return energies().gas;
    case kExplosiveEnergy:
      return energies().explosive;
    case kExplosiveMass:
      return std::accumulate(charges_.begin(), charges_.end(), 0.0,
                             [](double sum, const HoleCharge& c) { return sum + c.mass; });
    case kGasLeft:
      return states_.front().mass_left;
    default:
      return 0.0;
  }
}

void FixMuckpileBlast::write_restart(FILE* file) {
  const double now = clock_started_ ? clock() : clock_restarted_;
  const BlastState state{now,   swept_,         states_,   hole_over_,
                         over_, walls_checked_, softened_, books_};
  engine::write_state(*lmp, style, file, state);
}

void FixMuckpileBlast::restart(char* bytes) {
  auto state = engine::read_state<BlastState>(*lmp, style, bytes);
  clock_restarted_ = state.clock;
  swept_ = std::move(state.swept);
  states_ = std::move(state.gas);
  hole_over_ = std::move(state.hole_over);
  over_ = state.over;
  walls_checked_ = state.walls_checked;
  softened_ = state.softened;
  books_ = std::move(state.books);
}

}  // namespace muckpile
