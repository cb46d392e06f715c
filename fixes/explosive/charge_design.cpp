// SPDX-License-Identifier: GPL-2.0-or-later
// charge_design: words to the core, its numbers to variables.
// Scope: see the header.
#include "fixes/explosive/charge_design.h"

#include <mpi.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "explosive/charge_design.h"
#include "fixes/engine/output_file.h"
#include "fixes/engine/script_variables.h"
#include "fixes/engine/style_args.h"

namespace muckpile {

void ChargeDesignCommand::command(int narg, char** arg) {
  const std::string where = "charge_design";
  const ArgValues values = engine::or_engine_error(*lmp, [&] {
    return parse_args(charge_design_table(), where, engine::words_of(narg, arg, 0));
  });
  const ChargeDesign design =
      engine::or_engine_error(*lmp, [&] { return charge_design(values, where); });
  if (const std::string& word = values.word("crushed_table"); word != "none") {
    const std::filesystem::path file = word;
    MPI_Barrier(world);        // a late rank must not read what the first one writes
    std::error_code unheeded;  // write_file tells what is wrong with the folder
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), unheeded);
    engine::write_file(*lmp, where, word, design.crushed_table);
  }
  engine::print_once(*lmp, design.report);
  const auto set_variable = [&](const std::string& name, double value) {
    engine::set_script_variable(*lmp, name, value);
  };
  set_variable("charge_density", design.density);
  set_variable("charge_vod", design.detonation_velocity);
  set_variable("charge_energy", design.energy);
  if (design.crushed_radius) {
    set_variable("crushed_radius", *design.crushed_radius);
    set_variable("full_crushed_radius", design.full_radius);
  }
  if (design.harries_strain) set_variable("harries_strain", *design.harries_strain);
  if (!design.pattern) return;
  set_variable("pattern_holes", static_cast<double>(design.pattern->holes()));
  set_variable("pattern_last_firing", design.pattern->last_firing_time());
  set_variable("pattern_mass", design.pattern_mass);
  set_variable("pattern_window_mass", design.window_mass);
  set_variable("pattern_crushed_radius", design.pattern_crushed_radius);
  set_variable("pattern_full_radius", design.pattern_full_radius);
  const Eigen::AlignedBox3d box = design.pattern->chambers();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const std::string axis = std::string("pattern_") + "xyz"[k];
    set_variable(axis + "_lo", box.min()[k]);
    set_variable(axis + "_hi", box.max()[k]);
  }
}

}  // namespace muckpile
