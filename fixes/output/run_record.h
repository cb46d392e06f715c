// SPDX-License-Identifier: GPL-2.0-or-later
// Which run this is: its id, and the knobs of the run that it goes on from.
// Scope: a part of fix muckpile/blocks, which keeps it in restart files. All members are
// collective.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "provenance/knobs.h"
#include "rock/rock_model.h"
#include "state/encoding.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile {

/// 16 hexadecimal digits of what decides the run when its rock is cut: the program, the ranks, the
/// script's variables, the words of create_blocks, and the blocks as rank 0 has cut them. The
/// folder of the results, the variable `out`, is left out: the same run into another folder gives
/// the same files.
[[nodiscard]] std::string make_run_id(LAMMPS_NS::LAMMPS& lmp, const std::vector<std::string>& words,
                                      const RockModel& model);

/// What a restart file tells of the run that wrote it.
struct RecordedRun {
  std::string id;
  Knobs knobs;
};
template <>
struct Stored<RecordedRun> {
  static constexpr std::string_view kName = "recorded_run";
  static constexpr int kVersion = 1;
  static auto fields(auto& run) { return std::tie(run.id, run.knobs); }
};

class RunRecord {
 public:
  [[nodiscard]] const std::string& id() const { return id_; }  ///< "" before there is rock
  /// The id of the first rock stays, also when more is cut.
  void begin(const std::string& id);
  /// Names of the knobs that may have other values than in the run that this one goes on from.
  void allow_changes(std::vector<std::string> names);

  /// To be called once all knobs are known, as the first run begins.
  void complete_with(std::function<void()> complete) { complete_ = std::move(complete); }

  [[nodiscard]] RecordedRun recorded(LAMMPS_NS::LAMMPS& lmp) const;
  void go_on_from(RecordedRun run);
  [[nodiscard]] bool goes_on() const { return goes_on_; }

  /// Stops the run if a knob has another value than in the restart file; `where` begins the
  /// message.
  void check_values(LAMMPS_NS::LAMMPS& lmp, const std::string& where) const;
  /// Before the first run, when all knobs are known: looks also at those that only one of the two
  /// scripts has. Of a script that does not say what may change the user is only warned.
  void check_all(LAMMPS_NS::LAMMPS& lmp);

 private:
  void check_against_file(LAMMPS_NS::LAMMPS& lmp);
  [[nodiscard]] Knobs knobs_of(LAMMPS_NS::LAMMPS& lmp) const;
  [[nodiscard]] std::string refusal(const std::vector<KnobChange>& changes) const;

  std::string id_;
  Knobs before_;  ///< of the restart file
  bool goes_on_ = false, strict_ = false, has_run_ = false;
  std::vector<std::string> may_change_;
  std::function<void()> complete_;
};

}  // namespace muckpile
