// SPDX-License-Identifier: GPL-2.0-or-later
// Keys of summary.json that every sub-command writes: size of the run, joints, energy, speed,
// times. Scope: copied from dump/run.json, or totals of dump/history.csv.
#include "args/input_error.h"
#include "io/history.h"
#include "report/hole_audit.h"
#include "report/notes.h"
#include "report/reports.h"

namespace muckpile {
namespace {

// What is extensive is the model's in the run's files, and the whole blast's here.
nlohmann::ordered_json of_whole_blast(nlohmann::ordered_json value, int symmetry) {
  if (value.is_number() && symmetry > 1) return symmetry * value.get<double>();
  if (value.is_object()) {
    for (auto& [key, part] : value.items()) part = of_whole_blast(part, symmetry);
  }
  return value;
}

}  // namespace

nlohmann::ordered_json common_keys(const ResultFolder& folder) {
  const nlohmann::ordered_json run = read_json_object(folder.dump("run.json"));
  const History history = read_history(folder.dump("history.csv"));
  nlohmann::ordered_json keys;
  keys["case"] = folder.scene_word("case");
  for (const char* key : {"blocks", "spheres", "joints", "energy_balance_error", "physical_time_s",
                          "wall_time_s", "steps"}) {
    if (!run.contains(key)) {
      throw InputError(folder.dump("run.json").string() + ": has no key '" + key + "'");
    }
    keys[key] = run[key];
  }
  keys["joints_broken_fraction"] = history.joints_broken_fraction;
  keys["fastest_block_m_s"] = history.fastest_block;
  keys["energy_balance_error_worst"] = history.worst_balance_error;
  const int symmetry = folder.symmetry();
  if (symmetry > 1) keys["symmetry"] = symmetry;
  for (const char* key :
       {"explosive_energy_J", "wave_work_J", "gas_work_J", "joint_crushing_J", "energy_audit_J"}) {
    if (run.contains(key)) keys[key] = of_whole_blast(run[key], symmetry);
  }
  for (const char* key : {"energy_audit_error", "blocks_left_scene", "mass_left_scene_kg",
                          "blocks_in_solid", "ranks", "still"}) {
    if (run.contains(key)) keys[key] = run[key];
  }
  keys.update(hole_audit_keys(run));
  if (keys.contains("mass_left_scene_kg"))
    keys["mass_left_scene_kg"] = of_whole_blast(keys["mass_left_scene_kg"], symmetry);
  keys["still_note"] = nullptr;
  if (!folder.is_still()) keys["still_note"] = motion_note(run["physical_time_s"].get<double>());
  return keys;
}

}  // namespace muckpile
