// SPDX-License-Identifier: GPL-2.0-or-later
// Keys of summary.json that every sub-command writes: size of the run, joints, energy, speed,
// times. Scope: copied from dump/run.json, or totals of dump/history.csv.
#include "args/input_error.h"
#include "io/history.h"
#include "report/hole_audit.h"
#include "report/notes.h"
#include "report/reports.h"

namespace muckpile {

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
  for (const char* key :
       {"explosive_energy_J", "wave_work_J", "gas_work_J", "energy_audit_J", "energy_audit_error",
        "blocks_left_scene", "mass_left_scene_kg", "blocks_in_solid", "ranks", "still"}) {
    if (run.contains(key)) keys[key] = run[key];
  }
  keys.update(hole_audit_keys(run));
  keys["still_note"] = nullptr;
  if (!folder.is_still()) keys["still_note"] = motion_note(run["physical_time_s"].get<double>());
  return keys;
}

}  // namespace muckpile
