// SPDX-License-Identifier: GPL-2.0-or-later
// hole_pattern: words to the core, its text to a file.
// Scope: see the header.
#include "fixes/explosive/hole_pattern.h"

#include <filesystem>
#include <string>
#include <system_error>

#include "explosive/hole_pattern.h"
#include "fixes/engine/output_file.h"
#include "fixes/engine/style_args.h"

namespace muckpile {

void HolePatternCommand::command(int narg, char** arg) {
  const std::string where = "hole_pattern";
  const ArgValues values = engine::or_engine_error(*lmp, [&] {
    return parse_args(hole_pattern_table(), where, engine::words_of(narg, arg, 0));
  });
  const HolePattern pattern =
      engine::or_engine_error(*lmp, [&] { return hole_pattern(values, where); });
  const std::filesystem::path file = values.word("file");
  std::error_code unheeded;  // write_file tells what is wrong with the folder
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), unheeded);
  engine::write_file(*lmp, where, file.string(), hole_table_text(pattern));
  engine::print_once(*lmp, describe(pattern) + "  table: " + file.string() + "\n");
}

}  // namespace muckpile
