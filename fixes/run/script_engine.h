// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS as the phases of a blast drive it: by the commands that a user's script would give.
// Scope: core's BlastEngine; what a phase decides is BlastRun's. Collective.
#pragma once

#include <pointers.h>

#include <optional>
#include <string>

#include "args/parse_args.h"
#include "run/blast_engine.h"

namespace LAMMPS_NS {
class Fix;
}

namespace muckpile {

class BlastEnergies;
class BlastSurface;
class EnergyAccount;
class JointEnergies;
class JointPressure;

class ScriptEngine : public BlastEngine, protected LAMMPS_NS::Pointers {
 public:
  /// `words` of run_blast. Needs fix muckpile/joint and fix muckpile/blast.
  ScriptEngine(LAMMPS_NS::LAMMPS* engine, const ArgValues& words);

  [[nodiscard]] double time() const override;
  [[nodiscard]] double step() const override;
  [[nodiscard]] double stiffness() const override;
  [[nodiscard]] double elastic_energy() const override;
  [[nodiscard]] double kinetic_energy() const override;
  [[nodiscard]] double blast_work() const override;
  [[nodiscard]] double wall_pressure() const override;
  [[nodiscard]] double joint_pressure() const override;
  [[nodiscard]] bool still() const override;
  [[nodiscard]] bool interrupted() const override;

  void prepare(const PhaseNews& first, const StepRule& rule) override;
  void set_up() override;
  void run(long steps, bool afresh) override;
  void bound_step(const StepRule& rule) override;
  void soften(double factor, std::optional<double> damping) override;
  void begin_phase(const PhaseNews& news) override;
  void take_snapshots_every(long steps) override;
  void let_blocks_rest() override;
  void say(const std::string& line) override;
  void warn(const std::string& line) override;

 private:
  void tell(const std::string& command) const;
  [[nodiscard]] LAMMPS_NS::Fix* find(const std::string& style) const;
  /// True if it was not there.
  bool make(const std::string& style, const std::string& id, const std::string& words) const;
  void write_table() const;
  [[nodiscard]] std::string id_of(const std::string& style) const;

  ArgValues words_;
  std::string directory_;
  const BlastSurface* surface_;
  const JointEnergies* joints_;
  const BlastEnergies* blast_;
  const JointPressure* gas_;          ///< no gas in joints: null
  EnergyAccount* account_ = nullptr;  ///< known after prepare(), as the next
  LAMMPS_NS::Fix* progress_ = nullptr;
  bool own_snapshots_ = false, own_progress_ = false;  ///< made by prepare()
};

}  // namespace muckpile
