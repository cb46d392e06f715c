// SPDX-License-Identifier: GPL-2.0-or-later
// hole_pattern: words to the core, its text to a file.
// Scope: see the header.
#include "fixes/explosive/hole_pattern.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include "explosive/hole_pattern.h"
#include "explosive/hole_table.h"
#include "fixes/engine/output_file.h"
#include "fixes/engine/style_args.h"

namespace muckpile {
namespace {

struct TableText {
  std::string text, report;
};

TableText table_and_report(const ArgValues& values, const std::string& where) {
  const std::string& own = values.word("take");
  if (own == "none") {
    const HolePattern pattern = hole_pattern(values, where);
    return {hole_table_text(pattern), describe(pattern)};
  }
  const HoleTable table = HoleTable::read(own);  // finds what is wrong with it
  std::ostringstream text;
  text << std::ifstream(own).rdbuf();
  return {text.str(), where + ": " + std::to_string(table.holes()) + " holes, " +
                          std::to_string(table.decks().size()) + " decks of " + own + "\n"};
}

}  // namespace

void HolePatternCommand::command(int narg, char** arg) {
  const std::string where = "hole_pattern";
  const ArgValues values = engine::or_engine_error(*lmp, [&] {
    return parse_args(hole_pattern_table(), where, engine::words_of(narg, arg, 0));
  });
  const auto [text, report] =
      engine::or_engine_error(*lmp, [&] { return table_and_report(values, where); });
  const std::filesystem::path file = values.word("file");
  std::error_code unheeded;  // write_file tells what is wrong with the folder
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), unheeded);
  engine::write_file(*lmp, where, file.string(), text);
  engine::print_once(*lmp, report + "  table: " + file.string() + "\n");
}

}  // namespace muckpile
