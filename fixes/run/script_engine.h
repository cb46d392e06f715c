// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS as the phases of a run drive it: by the commands that a user's script would give.
// Scope: core's RunEngine; when a phase ends is decided there. Collective.
#pragma once

#include <pointers.h>

#include <string>

#include "args/parse_args.h"
#include "run/run_engine.h"

namespace LAMMPS_NS {
class Fix;
}

namespace muckpile {

class ScriptEngine : public RunEngine, protected LAMMPS_NS::Pointers {
 public:
  /// `words` of the command, with those of run/run_words.h.
  ScriptEngine(LAMMPS_NS::LAMMPS* engine, std::string command, const ArgValues& words);

  [[nodiscard]] double time() const override;
  [[nodiscard]] double step() const override;
  [[nodiscard]] bool still() const override;
  [[nodiscard]] bool interrupted() const override;

  void prepare(const PhaseNews& first, const StepRule& rule) override;
  void set_up() override;
  void run(long steps, bool afresh) override;
  void bound_step(const StepRule& rule) override;
  void cap_step(double longest) override;
  void begin_phase(const PhaseNews& news) override;
  void take_snapshots_every(long steps) override;
  void say(const std::string& line) override;
  void warn(const std::string& line) override;

  /// A signal has cut a command short. LIGGGHTS does not know of a run that was left before its
  /// first step, nor rank 0 of a signal to another rank.
  static void note_cut() { has_been_cut_ = true; }
  [[nodiscard]] static bool has_been_cut() { return has_been_cut_; }

 private:
  void tell(const std::string& line) const;
  void write_table() const;
  [[nodiscard]] std::string id_of(const std::string& style) const;

  static bool has_been_cut_;
  std::string command_;
  ArgValues words_;
  std::string directory_;
  LAMMPS_NS::Fix* progress_ = nullptr;                 ///< known after prepare()
  bool own_snapshots_ = false, own_progress_ = false;  ///< made by prepare()
};

}  // namespace muckpile
