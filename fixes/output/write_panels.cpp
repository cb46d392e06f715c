// SPDX-License-Identifier: GPL-2.0-or-later
// write_panels: words to the core, its text to a file.
// Scope: see the header.
#include "fixes/output/write_panels.h"

#include <array>
#include <string>

#include "fixes/engine/exchange.h"
#include "fixes/engine/first_rank.h"
#include "fixes/engine/output_file.h"
#include "fixes/engine/script_variables.h"
#include "fixes/engine/style_args.h"
#include "geometry/files/panel_mesh.h"
#include "geometry/surface/ground_panels.h"

namespace muckpile {

void WritePanelsCommand::command(int narg, char** arg) {
  const std::string where = "write_panels";
  const ArgValues words = engine::or_engine_error(*lmp, [&] {
    return parse_args(write_panels_table(), where, engine::words_of(narg, arg, 0));
  });
  // A survey and its panels are many times as large as what the other ranks know of them.
  std::string text, told;
  std::array<double, 3> heights{};  // [m]
  engine::on_first_rank(*lmp, [&] {
    const GroundPanels made = ground_panels(words, where);
    text = stl_text(words.word("name"), panels_of(words, where), made.floor.triangles);
    if (!made.under_rock.empty()) text += stl_text("under_the_rock", {}, made.under_rock);
    told = made.told;
    heights = {made.floor.lowest, made.floor.highest, made.front};
  });
  engine::write_file(*lmp, where, words.word("file"), text);
  if (!words.given("ground")) return;
  engine::print_once(*lmp, told);
  engine::take_from_first_rank(heights, world);
  engine::set_script_variable(*lmp, "panels_lowest", heights[0]);
  engine::set_script_variable(*lmp, "panels_highest", heights[1]);
  engine::set_script_variable(*lmp, "panels_front", heights[2]);
}

}  // namespace muckpile
