// SPDX-License-Identifier: GPL-2.0-or-later
// write_panels: words to the core, its text to a file.
// Scope: see the header.
#include "fixes/output/write_panels.h"

#include <string>
#include <tuple>
#include <utility>

#include "fixes/engine/output_file.h"
#include "fixes/engine/script_variables.h"
#include "fixes/engine/style_args.h"
#include "geometry/files/panel_mesh.h"
#include "geometry/surface/ground_panels.h"

namespace muckpile {

void WritePanelsCommand::command(int narg, char** arg) {
  const std::string where = "write_panels";
  const auto [file, text, ground] = engine::or_engine_error(*lmp, [&] {
    const ArgValues words = parse_args(write_panels_table(), where, engine::words_of(narg, arg, 0));
    GroundPanels made = ground_panels(words, where);
    std::string panels =
        stl_text(words.word("name"), panels_of(words, where), made.floor.triangles);
    return std::tuple(words.word("file"), std::move(panels), std::move(made));
  });
  engine::write_file(*lmp, where, file, text);
  if (ground.told.empty()) return;
  engine::print_once(*lmp, ground.told);
  engine::set_script_variable(*lmp, "panels_lowest", ground.floor.lowest);
  engine::set_script_variable(*lmp, "panels_highest", ground.floor.highest);
}

}  // namespace muckpile
