// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/gas: gas of the charges flows from the crushed zones into broken joints.
// Scope: drives core's JointGas between fix muckpile/blast, whose chambers it empties, and fix
// muckpile/joint, whose broken facets it presses; one message and one sum a step while there is
// gas.
#pragma once

#include <fix.h>

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "fixes/interfaces/gas_chambers.h"
#include "fixes/interfaces/joint_gas_energies.h"
#include "fixes/interfaces/joint_pressure.h"
#include "fixes/interfaces/joints_with_gas.h"
#include "gas/crushed_bed.h"
#include "gas/joint_gas.h"
#include "state/encoding.h"

namespace muckpile {

/// The gas of a block, on its way to another rank or into a restart file.
struct BlockGas {
  int tag = 0;
  GasContent content;
};
template <>
struct Stored<BlockGas> {
  static constexpr std::string_view kName = "block_gas";
  static constexpr int kVersion = 1;
  static auto fields(auto& gas) { return std::tie(gas.tag, gas.content); }
};

/// What a restart file holds of the fix that is the same on all ranks.
struct JointGasState {
  bool active = false, spent = false;
  std::vector<char> fed;                ///< per hole
  std::vector<CrushedBed::State> beds;  ///< per hole
  GasFlow taken, vented, lost;
  double work = 0.0;  ///< [J]
  GasSpent spent_energy;
  double softened = 1.0;                 ///< [-]
  double in_open = 0.0, could_do = 0.0;  ///< [J]
  double greatest_pressure = 0.0;        ///< [Pa]
  double waited = 0.0;                   ///< since the last flow [s]
  std::int64_t measured_at = -1;         ///< step whose pressures hold; -1: none yet
};
template <>
struct Stored<JointGasState> {
  static constexpr std::string_view kName = "joint_gas_state";
  static constexpr int kVersion = 5;
  static auto fields(auto& state) {
    return std::tie(state.active, state.spent, state.fed, state.beds, state.taken, state.vented,
                    state.lost, state.work, state.spent_energy, state.softened,
                    state.greatest_pressure, state.in_open, state.could_do, state.waited,
                    state.measured_at);
  }
};

class FixMuckpileGas : public LAMMPS_NS::Fix, public JointPressure, public JointGasEnergies {
 public:
  FixMuckpileGas(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup_pre_neighbor() override;
  void pre_neighbor() override { follow_blocks(); }
  void end_of_step() override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;

  [[nodiscard]] std::span<const double> pressure_in_joints() override;
  [[nodiscard]] double greatest_in_joints() const override;
  [[nodiscard]] double longest_step() const override { return longest_step_; }
  [[nodiscard]] bool acts() const override { return active_; }
  [[nodiscard]] Sums gas_energies() const override;

 private:
  static const int kOutputs;  // entries of the vector

  void follow_blocks();
  [[nodiscard]] std::unordered_map<int, GasContent> contents_here(const std::vector<int>& tags);
  [[nodiscard]] bool is_due() const;
  void read_chambers();
  void book_work();
  void step_of_gas();
  void count_chamber_ways();
  void refresh();
  void flow(double dt);
  void pass_beds(const RockLayers::Step& step);
  void heat_beds(std::vector<GasFlow>& from_hole, const double* out, const RockLayers::Step& step);
  [[nodiscard]] double heat_of_beds() const;
  [[nodiscard]] double greatest_pressure() const;
  void release_from_softened_joints(double in_joints);
  void end_of_gas(const std::string& how);
  void look_whether_spent();
  [[nodiscard]] double over_ranks(double mine, bool greatest = false) const;
  [[nodiscard]] GasFlow over_ranks(const GasFlow& mine) const;
  [[nodiscard]] GasSpent spent_by_all() const;

  std::string where_;
  JointGas gas_;
  double ambient_;                // [Pa]
  int every_;                     // steps of the blocks in one of the gas, at most
  double longest_step_;           // of the gas, if it is longer than one of the blocks [s]
  int substeps_;                  // of the flow in a step of the gas
  GasChambers* blast_ = nullptr;  // looked up in every init()
  JointsWithGas* joints_ = nullptr;
  std::uint64_t version_ = 0;
  std::vector<int> tags_;  // of the owned blocks, in the order of their cells
  std::unordered_map<int, GasContent> restored_;  // by tag, until the first follow_blocks()
  bool active_ = false, spent_ = false;
  LAMMPS_NS::bigint measured_at_ = -1;  // step whose pressures hold; -1: none yet
  double waited_ = 0.0;                 // since the last flow [s]
  std::vector<char> fed_;               // per hole
  CrushedBed bed_;
  std::vector<CrushedBed::State> beds_;     // per hole, the same on all ranks
  std::vector<GasChamber> chambers_;        // per hole; joints get what has passed the bed
  std::vector<double> kept_;                // per hole: of the enthalpy, behind the bed [-]
  std::vector<double> numbers_, contents_;  // of the cells, for messages
  std::vector<double> ways_, sums_;         // of the chambers, for sums
  double softened_ = 1.0;                   // stiffness of the joints that the gas has seen [-]
  GasFlow taken_, vented_;                  // all ranks, so far
  double restored_pressure_ =
      0.0;             // greatest in joints, of a restart file, until the next step [Pa]
  GasFlow lost_;       // with blocks that left the box, not yet in vented_
  double work_ = 0.0;  // on the blocks of this rank, so far [J]
  // Of wide joints of this rank, so far: energy of the gas that they released, and the work that it
  // could still have done [J].
  double in_open_ = 0.0, could_do_ = 0.0;
};

}  // namespace muckpile
