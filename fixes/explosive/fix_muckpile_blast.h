// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/blast: the charge's pressure on the block faces that line the crushed zones.
// Scope: decides the pressures from time and swept volume (core/explosive); fix muckpile/joint
// turns them into forces. Idle before the first hole fires and after the last has vented.
#pragma once

#include <fix.h>

#include <cstdint>
#include <string>
#include <vector>

#include "explosive/blast_holes.h"
#include "fixes/interfaces/blast_energies.h"
#include "fixes/interfaces/blast_surface.h"
#include "fixes/interfaces/charge_timing.h"
#include "fixes/interfaces/gas_chambers.h"
#include "gas/joint_gas.h"
#include "state/encoding.h"

namespace muckpile {

/// What a restart file holds of the fix.
struct BlastState {
  double clock = 0.0;           ///< since the first run with the fix [s]
  std::vector<double> swept;    ///< per hole [m3]
  std::vector<GasState> gas;    ///< per hole
  std::vector<char> hole_over;  ///< per hole
  bool over = false, walls_checked = false;
  double softened = 1.0;         ///< [-]
  std::vector<HoleBooks> books;  ///< per hole
};
template <>
struct Stored<BlastState> {
  static constexpr std::string_view kName = "blast_state";
  static constexpr int kVersion = 2;
  static auto fields(auto& state) {
    return std::tie(state.clock, state.swept, state.gas, state.hole_over, state.over,
                    state.walls_checked, state.softened, state.books);
  }
};

class FixMuckpileBlast : public LAMMPS_NS::Fix,
                         public BlastEnergies,
                         public GasChambers,
                         public ChargeTiming {
 public:
  FixMuckpileBlast(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int vflag) override;
  void setup_pre_force(int vflag) override;
  void pre_force(int vflag) override;
  void end_of_step() override;
  double compute_vector(int index) override;
  double compute_array(int hole, int column) override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;

  [[nodiscard]] Energies energies() const override;
  [[nodiscard]] EnergyAudit audit() const override;
  [[nodiscard]] std::vector<HoleAudit> hole_audits() const override;
  [[nodiscard]] double greatest_pressure() const override;
  [[nodiscard]] bool over() const override { return over_; }
  [[nodiscard]] BlastTiming timing() const override;
  [[nodiscard]] bool vents_by_flow() const override { return options_.vent_by_flow; }
  void expect_step(double longest) override { expected_step_ = longest; }

  void let_gas_into_joints(double ambient) override;
  void keep_gas_out_of_joints() override;
  [[nodiscard]] double gas_gamma() const override;
  [[nodiscard]] double gas_constant() const override;
  [[nodiscard]] GasChamber chamber(std::size_t hole) const override;
  void take_gas(std::span<const GasFlow> per_hole) override;
  void release_gas() override;

 private:
  static const int kOutputs, kHoleOutputs;  // entries of the vector, columns of the array

  void check_timestep();
  void check_walls() const;
  void require_fired(double bearable) const;
  void release_from_softened_walls();
  [[nodiscard]] double clock() const;        // since the first run with this fix [s]
  [[nodiscard]] double last_clock() const {  // before a run, too
    return clock_started_ ? clock() : clock_restarted_;
  }
  void refresh_arrivals();
  void sum_over_walls();
  void load_faces(double time);
  void finish();

  std::string where_;
  BlastOptions options_;
  double crack_discharge_ = 0.0;     // that of its words, which options_ lacks with gas in joints
  BlastSurface* surface_ = nullptr;  // looked up in every init()
  double softened_ = 1.0;            // what the walls have been looked at for [-]
  // Swept volumes are those of the last force computation: the faces of a block cannot tell once it
  // has changed rank.
  BlastHoles holes_;
  bool described_ = false;

  bool clock_started_ = false;
  bool walls_checked_ = false;
  double clock_zero_ = 0.0;       // engine time at clock 0 [s]
  double clock_restarted_ = 0.0;  // clock taken over from a restart file [s]

  std::uint64_t arrivals_version_ = 0;
  bool arrivals_known_ = false;
  std::vector<double> arrivals_;    // per loaded face of this rank [s]
  std::vector<double> pressures_;   // per loaded face of this rank [Pa]
  std::vector<double> wave_share_;  // per loaded face of this rank
  bool over_ = false;               // all holes are
  bool walls_swept_ = false;        // the first charges know where their walls are
  bool warned_ = false;             // of a step too long for the pulse
  double expected_step_ = 0.0;      // steps up to this need no warning [s]
};

}  // namespace muckpile
