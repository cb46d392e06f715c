// SPDX-License-Identifier: GPL-2.0-or-later
// Id and knobs of a run.
// Scope: see the header.
#include "fixes/output/run_record.h"

#include <comm.h>
#include <error.h>
#include <lammps.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "args/suggestion.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/script_variables.h"
#include "fixes/engine/style_args.h"
#include "fixes/run/build_info.h"
#include "provenance/fingerprint.h"

namespace muckpile {
namespace {

/// `text` with every `folder`/ in it as /.
std::string without_folder(std::string text, const std::string& folder) {
  if (folder.empty()) return text;
  for (std::size_t at = 0; (at = text.find(folder + '/', at)) != std::string::npos; ++at)
    text.erase(at, folder.size());
  return text;
}

/// Of the file that `value` names, "" if it names none.
std::string content_print(const std::string& value) {
  std::error_code unheeded;
  if (!std::filesystem::is_regular_file(value, unheeded)) return "";
  std::ifstream in(value, std::ios::binary);
  std::ostringstream content;
  content << in.rdbuf();
  return Fingerprint().add(content.str()).text();
}

}  // namespace

std::string make_run_id(LAMMPS_NS::LAMMPS& lmp, const std::vector<std::string>& words,
                        const RockModel& model) {
  const std::string folder = engine::knob_value(lmp, "out");
  Fingerprint print;
  print.add(MUCKPILE_VERSION).add(build_info().commit);
  print.add(static_cast<std::uint64_t>(lmp.comm->nprocs));
  for (const auto& [name, text] : engine::script_definitions(lmp)) {
    if (name != "out") print.add(name).add(without_folder(text, folder));
  }
  for (const std::string& word : words) print.add(without_folder(word, folder));
  for (const auto* blocks : {&model.rock.blocks, &model.muck.blocks}) {
    for (const Block& block : *blocks) {
      print.add(static_cast<std::uint64_t>(block.shape.vertices.size()));
      for (const Vec3& vertex : block.shape.vertices)
        print.add(vertex.x()).add(vertex.y()).add(vertex.z());
    }
  }
  return engine::of_first_rank(print.text(), lmp.world);
}

void RunRecord::begin(const std::string& id) {
  if (id_.empty()) id_ = id;
}

void RunRecord::allow_changes(std::vector<std::string> names) {
  strict_ = true;
  may_change_ = std::move(names);
}

/// Behind a knob that names a file, such as a table of holes, its content as one more.
Knobs RunRecord::knobs_of(LAMMPS_NS::LAMMPS& lmp) const {
  Knobs knobs;
  for (const Knob& knob : engine::script_knobs(lmp)) {
    knobs.push_back(knob);
    const bool free = std::ranges::find(may_change_, knob.name) != may_change_.end();
    if (free || !knob.value) continue;
    const std::string print =
        engine::of_first_rank(lmp.comm->me == 0 ? content_print(*knob.value) : "", lmp.world);
    if (!print.empty()) knobs.push_back({"content of " + knob.name, print});
  }
  return knobs;
}

RecordedRun RunRecord::recorded(LAMMPS_NS::LAMMPS& lmp) const { return {id_, knobs_of(lmp)}; }

void RunRecord::go_on_from(RecordedRun run) {
  goes_on_ = true;
  id_ = std::move(run.id);
  before_ = std::move(run.knobs);
}

std::string RunRecord::refusal(const std::vector<KnobChange>& changes) const {
  return "the run goes on with other knobs than the restart file has: " + describe(changes) +
         ". Give them as they were, or start anew; only these may change: " +
         (may_change_.empty() ? "none" : joined(may_change_));
}

void RunRecord::check_values(LAMMPS_NS::LAMMPS& lmp, const std::string& where) const {
  if (!goes_on_) return;
  auto changes = knob_changes(before_, knobs_of(lmp), may_change_).other;
  std::erase_if(changes, [](const KnobChange& change) { return !change.before || !change.now; });
  if (!changes.empty()) engine::stop(lmp, where + ": " + refusal(changes));
}

void RunRecord::check_all(LAMMPS_NS::LAMMPS& lmp) {
  check_against_file(lmp);
  if (complete_) complete_();
  complete_ = nullptr;
}

void RunRecord::check_against_file(LAMMPS_NS::LAMMPS& lmp) {
  if (!goes_on_ || has_run_) return;
  has_run_ = true;  // what the script changes later is its own affair
  const KnobChanges changes = knob_changes(before_, knobs_of(lmp), may_change_);
  if (strict_ && !changes.other.empty())
    engine::stop(lmp, "read_restart: " + refusal(changes.other));
  std::string told;
  if (!changes.other.empty()) told += "; other: " + describe(changes.other);
  if (!changes.missing.empty()) told += "; only in the file: " + joined(changes.missing);
  if (!changes.added.empty()) told += "; not in the file: " + joined(changes.added);
  if (!told.empty() && lmp.comm->me == 0)
    lmp.error->warning(
        FLERR, ("read_restart: knobs of the restart file and of this script" + told).c_str());
}

}  // namespace muckpile
