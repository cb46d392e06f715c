// SPDX-License-Identifier: GPL-2.0-or-later
// write_panels: words to the core, its text to a file.
// Scope: see the header.
#include "fixes/output/write_panels.h"

#include <string>

#include "fixes/engine/output_file.h"
#include "fixes/engine/style_args.h"
#include "geometry/files/panel_mesh.h"

namespace muckpile {

void WritePanelsCommand::command(int narg, char** arg) {
  const std::string where = "write_panels";
  const auto [file, text] = engine::or_engine_error(*lmp, [&] {
    const ArgValues words = parse_args(write_panels_table(), where, engine::words_of(narg, arg, 0));
    return std::pair(words.word("file"), stl_text(words.word("name"), panels_of(words, where)));
  });
  engine::write_file(*lmp, where, file, text);
}

}  // namespace muckpile
