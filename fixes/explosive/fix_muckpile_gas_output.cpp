// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/gas, its restart state and what it tells.
// Scope: sums over ranks of what core/gas keeps.
#include <comm.h>

#include "fixes/engine/over_ranks.h"
#include "fixes/engine/restart_file.h"
#include "fixes/explosive/fix_muckpile_gas.h"

namespace muckpile {
namespace {

enum Output {
  kInJoints,
  kTaken,
  kVented,
  kWork,
  kGreatest,
  kBlocks,
  kSpent,
  kEnergyTaken,
  kHeat,
  kEnergyInJoints,
  kEnergyVented,
  kAirWork,
  kBedHeat,
  kInOpen,
  kCouldDo,
  kOutputCount
};

}  // namespace

const int FixMuckpileGas::kOutputs = kOutputCount;

/// Which blocks are calm is not in the file.
void FixMuckpileGas::write_restart(FILE* file) {
  gas_.look_at_all();
  const JointGasState state{active_,
                            spent_,
                            fed_,
                            beds_,
                            taken_,
                            vented_,
                            over_ranks(lost_),
                            over_ranks(work_),
                            spent_by_all(),
                            softened_,
                            greatest_pressure(),
                            over_ranks(in_open_),
                            over_ranks(could_do_),
                            waited_,
                            measured_at_};
  ByteWriter mine;
  for (std::size_t b = 0; b < tags_.size(); ++b)
    mine.put(BlockGas{tags_[b], gas_.cells()[b].content});
  // Between read_restart and the first run every rank has the gas of all blocks.
  for (const auto& [tag, content] : restored_) {
    if (comm->me == 0) mine.put(BlockGas{tag, content});
  }
  engine::write_state<BlockGas>(*lmp, style, file, state, std::move(mine));
}

/// The contents of all blocks, until follow_blocks() picks those of this rank.
void FixMuckpileGas::restart(char* bytes) {
  JointGasState state;
  engine::read_state<BlockGas>(*lmp, style, bytes, state,
                               [this](const BlockGas& gas) { restored_[gas.tag] = gas.content; });
  active_ = state.active;
  spent_ = state.spent;
  fed_ = std::move(state.fed);
  beds_ = std::move(state.beds);
  taken_ = state.taken;
  vented_ = state.vented;
  const auto mine = [this](double total) { return engine::share_of_total(*lmp, total); };
  lost_ = {mine(state.lost.mass), mine(state.lost.energy)};
  const GasSpent& spent = state.spent_energy;
  gas_.resume({mine(spent.work), mine(spent.swept_volume), mine(spent.air_work), mine(spent.heat)});
  work_ = mine(state.work);
  in_open_ = mine(state.in_open);
  could_do_ = mine(state.could_do);
  softened_ = state.softened;
  restored_pressure_ = state.greatest_pressure;
  waited_ = state.waited;
  measured_at_ = state.measured_at;
}

double FixMuckpileGas::over_ranks(double mine, bool greatest) const {
  return greatest ? engine::greatest_over_ranks(mine, world) : engine::sum_over_ranks(mine, world);
}

GasFlow FixMuckpileGas::over_ranks(const GasFlow& mine) const {
  return {over_ranks(mine.mass), over_ranks(mine.energy)};
}

GasSpent FixMuckpileGas::spent_by_all() const {
  const GasSpent& mine = gas_.spent();
  return {over_ranks(mine.work), over_ranks(mine.swept_volume), over_ranks(mine.air_work),
          over_ranks(mine.heat)};
}

JointGasEnergies::Sums FixMuckpileGas::gas_energies() const {
  const GasSpent spent = spent_by_all();
  return {.work = over_ranks(work_),
          .air_work = spent.air_work,
          .heat = spent.heat + heat_of_beds(),
          .contained = over_ranks(gas_.contained().energy),
          .vented = vented_.energy + over_ranks(lost_.energy)};
}

double FixMuckpileGas::compute_vector(int n) {
  switch (n) {
    case kInJoints:
      return over_ranks(gas_.contained().mass);
    case kTaken:
      return taken_.mass;
    case kVented:
      return vented_.mass + over_ranks(lost_.mass);
    case kEnergyTaken:
      return taken_.energy;
    case kHeat:
      return over_ranks(gas_.spent().heat) + heat_of_beds();
    case kBedHeat:
      return heat_of_beds();
    case kEnergyInJoints:
      return over_ranks(gas_.contained().energy);
    case kEnergyVented:
      return vented_.energy + over_ranks(lost_.energy);
    case kAirWork:
      return over_ranks(gas_.spent().air_work);
    case kInOpen:
      return over_ranks(in_open_);
    case kCouldDo:
      return over_ranks(could_do_);
    case kWork:
      return over_ranks(work_);
    case kGreatest:
      return greatest_in_joints();
    case kBlocks:
      return over_ranks(gas_.blocks_with_gas());
    case kSpent:
      return spent_ ? 1.0 : 0.0;
    default:
      return 0.0;
  }
}

}  // namespace muckpile
