// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/gas, a step: pressures before the forces, the flow after them.
// Scope: messages and sums over ranks; the laws are in core/gas.
#include <update.h>

#include <algorithm>
#include <array>

#include "fixes/engine/exchange.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/explosive/fix_muckpile_gas.h"

namespace muckpile {
namespace {

constexpr int kCellWidth = 4;                  // mass, energy, volume, ways
constexpr int kContentWidth = 2;               // mass, energy
constexpr LAMMPS_NS::bigint kLookEvery = 100;  // steps between looks whether the gas is spent
constexpr double kSpentShare = 0.2;  // spent: nowhere more than that share above the atmosphere

}  // namespace

/// The step of the gas ends with this one of the blocks: it would be too long with one more.
bool FixMuckpileGas::is_due() const {
  if (measured_at_ < 0) return true;
  if (update->setupflag != 0) return false;
  const bool last = update->ntimestep - measured_at_ >= every_;
  return last || waited_ + 2.0 * update->dt > (1.0 + 1e-9) * longest_step_;
}

/// A set-up for a run, after a restart file too, finds what the last step pressed.
std::span<const double> FixMuckpileGas::pressure_in_joints() {
  if (!active_) return {};
  if (!is_due()) return gas_.pressed();
  measured_at_ = update->ntimestep;
  const engine::BlockHalo& halo = joints_->halo();
  gas_.measure(joints_->rooms(), fed_);
  numbers_.resize(halo.size() * kCellWidth);
  const std::span<GasCell> cells = gas_.cells();
  for (std::size_t b = 0; b < halo.owned(); ++b) {
    const GasCell& cell = cells[b];
    const std::array<double, kCellWidth> row = {cell.content.mass, cell.content.energy, cell.volume,
                                                cell.ways};
    std::copy(row.begin(), row.end(), numbers_.data() + b * kCellWidth);
  }
  halo.forward(numbers_, kCellWidth);
  for (std::size_t b = halo.owned(); b < halo.size(); ++b) {
    const double* row = numbers_.data() + b * kCellWidth;
    cells[b] = {{row[0], row[1]}, row[2], row[3]};
  }
  return gas_.press();
}

void FixMuckpileGas::end_of_step() {
  if (spent_) return;
  restored_pressure_ = 0.0;
  read_chambers();
  if (!active_) {  // the gas flows from the step after the first hole fires
    active_ = std::any_of(fed_.begin(), fed_.end(), [](char fed) { return fed != 0; });
    return;
  }
  book_work();
  waited_ += update->dt;
  if (measured_at_ == update->ntimestep) step_of_gas();  // the step may have changed since
  if (update->ntimestep % kLookEvery == 0) look_whether_spent();
}

/// What flows and cools in the time since the last one.
void FixMuckpileGas::step_of_gas() {
  count_chamber_ways();
  for (int k = 0; k < substeps_; ++k) {
    if (k > 0) refresh();
    flow(waited_ / substeps_);
  }
  gas_.cool(waited_);
  waited_ = 0.0;
  const JointGas::Opened opened = gas_.open_wide();
  joints_->release_gas(opened.joints);
  lost_ += opened.vented;
  in_open_ += opened.vented.energy;
  could_do_ += opened.could_do;
}

void FixMuckpileGas::read_chambers() {
  for (std::size_t hole = 0; hole < chambers_.size(); ++hole) {
    GasChamber& chamber = chambers_[hole];
    chamber = blast_->chamber(hole);
    fed_[hole] = chamber.gas.pressure > 0.0 ? 1 : 0;
  }
}

/// Joints get the gas as it is behind the crushed rock.
void FixMuckpileGas::pass_beds(const RockLayers::Step& step) {
  for (std::size_t hole = 0; hole < chambers_.size(); ++hole) {
    if (fed_[hole] == 0) continue;
    GasChamber& chamber = chambers_[hole];
    kept_[hole] =
        bed_.kept(beds_[hole], chamber.crushed_rock, chamber.enthalpy / gas_.heat_capacity(), step);
    chamber.enthalpy *= kept_[hole];
    chamber.gas.density /= kept_[hole];
  }
}

void FixMuckpileGas::book_work() {
  const double work = joints_->gas_power() * update->dt;
  work_ += work;
  joints_->book_gas_work(work);
}

/// Sums the conductance of the ways out of each chamber over ranks, in the pose that measure() saw.
void FixMuckpileGas::count_chamber_ways() {
  if (std::none_of(fed_.begin(), fed_.end(), [](char hole) { return hole != 0; })) return;
  ways_.assign(chambers_.size(), 0.0);
  std::ranges::copy(gas_.chamber_ways(), ways_.begin());
  engine::sum_over_ranks_in_place(ways_, world);
  for (std::size_t hole = 0; hole < ways_.size(); ++hole) chambers_[hole].ways = ways_[hole];
}

/// Pressures of blocks and chambers after a substep of the flow, for the next one.
void FixMuckpileGas::refresh() {
  const std::vector<GasChamber> before = chambers_;
  read_chambers();
  for (std::size_t hole = 0; hole < chambers_.size(); ++hole)
    chambers_[hole].ways = before[hole].ways;
  const engine::BlockHalo& halo = joints_->halo();
  contents_.resize(halo.size() * kContentWidth);
  const std::span<GasCell> cells = gas_.cells();
  for (std::size_t b = 0; b < halo.owned(); ++b) {
    contents_[b * kContentWidth] = cells[b].content.mass;
    contents_[b * kContentWidth + 1] = cells[b].content.energy;
  }
  halo.forward(contents_, kContentWidth);
  for (std::size_t b = halo.owned(); b < halo.size(); ++b)
    cells[b].content = {contents_[b * kContentWidth], contents_[b * kContentWidth + 1]};
  gas_.refresh();
}

void FixMuckpileGas::flow(double dt) {
  const RockLayers::Step in_grains = bed_.step(dt);
  pass_beds(in_grains);
  JointGas::Flows flows = gas_.flow(chambers_, dt);
  flows.vented += lost_;
  lost_ = {};
  flows.from_hole.push_back(flows.vented);
  sums_ = flows.out_of_hole;
  for (const GasFlow& flow : flows.from_hole) sums_.insert(sums_.end(), {flow.mass, flow.energy});
  engine::sum_over_ranks_in_place(sums_, world);
  const double* sum = sums_.data() + flows.out_of_hole.size();
  for (GasFlow& flow : flows.from_hole) {
    flow = {sum[0], sum[1]};
    sum += 2;
  }
  vented_ += flows.from_hole.back();
  flows.from_hole.pop_back();
  heat_beds(flows.from_hole, sums_.data(), in_grains);
  for (const GasFlow& flow : flows.from_hole) taken_ += flow;
  blast_->take_gas(flows.from_hole);
}

/// What left the holes, `out` [kg], brought its joints the enthalpy behind the crushed rock; the
/// holes lose what it had before.
void FixMuckpileGas::heat_beds(std::vector<GasFlow>& from_hole, const double* out,
                               const RockLayers::Step& step) {
  for (std::size_t hole = 0; hole < from_hole.size(); ++hole) {
    const double heat = out[hole] * chambers_[hole].enthalpy * (1.0 / kept_[hole] - 1.0);
    from_hole[hole].energy += heat;
    bed_.take(beds_[hole], chambers_[hole].crushed_rock, heat,
              out[hole] * gas_.heat_capacity() / step.length(), step);
  }
}

double FixMuckpileGas::heat_of_beds() const {
  double heat = 0.0;
  for (const CrushedBed::State& bed : beds_) heat += bed.heat;
  return heat;
}

void FixMuckpileGas::look_whether_spent() {
  const bool fed = std::any_of(fed_.begin(), fed_.end(), [](char hole) { return hole != 0; });
  const double greatest = greatest_in_joints();
  if (fed || !blast_->over() || greatest > (1.0 + kSpentShare) * ambient_) return;
  end_of_gas("is spent");
}

}  // namespace muckpile
