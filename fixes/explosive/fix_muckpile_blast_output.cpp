// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/blast: energies and their audit, outputs, restart.
// Scope: what has been booked; nothing here changes the load.
#include <array>
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

// What compute_array() returns of a hole, by column, before what its gas took into joints and the
// rest.
constexpr std::array kHoleColumns = {&EnergyAudit::explosive, &EnergyAudit::not_released,
                                     &EnergyAudit::filling,   &EnergyAudit::crushing,
                                     &EnergyAudit::wall_work, &EnergyAudit::in_holes,
                                     &EnergyAudit::vented};

constexpr std::size_t kMoreHoleColumns = 6;

/// Those after kHoleColumns.
std::array<double, kMoreHoleColumns> more_of(const HoleAudit& hole) {
  return {hole.into_joints,  hole.energy.stemming, hole.energy.air_work,
          hole.stemming_out, hole.stemming_speed,  hole.error()};
}

}  // namespace

const int FixMuckpileBlast::kOutputs = kOutputCount;
const int FixMuckpileBlast::kHoleOutputs = static_cast<int>(kHoleColumns.size() + kMoreHoleColumns);

BlastEnergies::Energies FixMuckpileBlast::energies() const {
  Energies energies;
  energies.explosive = holes_.explosive_energy();
  if (const BlastSurface* surface = engine::find_view<BlastSurface>(*lmp)) {
    energies.wave = engine::sum_over_ranks(surface->wave_work(), world);
    energies.gas = engine::sum_over_ranks(surface->pressure_work(), world) - energies.wave;
  }
  return energies;
}

EnergyAudit FixMuckpileBlast::audit() const {
  EnergyAudit all;
  for (std::size_t hole = 0; hole < holes_.count(); ++hole) all += holes_.audit(hole, last_clock());
  if (const auto* joints = engine::find_view<JointGasEnergies>(*lmp)) {
    const JointGasEnergies::Sums gas = joints->gas_energies();
    all.joint_work += gas.work;
    all.air_work += gas.air_work;
    all.rock_heat += gas.heat;
    all.in_joints += gas.contained;
    all.vented += gas.vented;
  }
  return all;
}

std::vector<HoleAudit> FixMuckpileBlast::hole_audits() const {
  std::vector<HoleAudit> audits;
  for (std::size_t hole = 0; hole < holes_.count(); ++hole)
    audits.push_back(holes_.hole_audit(hole, last_clock()));
  return audits;
}

double FixMuckpileBlast::compute_array(int row, int column) {
  const auto hole = static_cast<std::size_t>(row), term = static_cast<std::size_t>(column);
  if (hole >= holes_.count()) return 0.0;
  const HoleAudit audit = holes_.hole_audit(hole, last_clock());
  return term < kHoleColumns.size() ? audit.energy.*kHoleColumns[term]
                                    : more_of(audit).at(term - kHoleColumns.size());
}

double FixMuckpileBlast::compute_vector(int index) {
  const BlastSurface* surface =
      engine::find_view<BlastSurface>(*lmp);  // between runs it may have been unfixed
  if (surface == nullptr || holes_.count() == 0) return 0.0;
  if (index >= kAudit) {
    const EnergyAudit all = audit();
    const auto term = static_cast<std::size_t>(index - kAudit) + 1;
    return term < EnergyAudit::kTerms.size() ? all.*EnergyAudit::kTerms[term].value : all.error();
  }
  switch (index) {
    case kMaximumPressure:
      return greatest_pressure();
    case kGasPressure:
      return holes_.gas_pressure(0);
    case kSweptVolume:
      return holes_.swept_volume();
    case kWork:
      return engine::sum_over_ranks(surface->pressure_work(), world);
    case kActiveHoles:
      return clock_started_ ? holes_.active(clock()) : 0;
    case kOver:
      return over_ ? 1.0 : 0.0;
    case kWaveWork:
      return energies().wave;
    case kGasWork:
      return energies().gas;
    case kExplosiveEnergy:
      return energies().explosive;
    case kExplosiveMass:
      return holes_.explosive_mass();
    case kGasLeft:
      return holes_.state().gas.front().mass_left;
    default:
      return 0.0;
  }
}

void FixMuckpileBlast::write_restart(FILE* file) {
  const BlastHoles::State& holes = holes_.state();
  const BlastState state{last_clock(), holes.swept,    holes.gas, holes.over,
                         over_,        walls_checked_, softened_, holes.books};
  engine::write_state(*lmp, style, file, state);
}

void FixMuckpileBlast::restart(char* bytes) {
  auto state = engine::read_state<BlastState>(*lmp, style, bytes);
  clock_restarted_ = state.clock;
  holes_.resume({std::move(state.swept), std::move(state.gas), std::move(state.hole_over),
                 std::move(state.books)});
  over_ = state.over;
  walls_checked_ = state.walls_checked;
  walls_swept_ = state.clock > 0.0;
  softened_ = state.softened;
}

}  // namespace muckpile
