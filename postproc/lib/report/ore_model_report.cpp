// SPDX-License-Identifier: GPL-2.0-or-later
// A block model of ore carried into the pile.
// Scope: see the header.
#include "report/ore_model_report.h"

#include <limits>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "io/csv_writer.h"
#include "measure/block_finder.h"

namespace muckpile {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> words_of(const CsvTable& table, size_t row) {
  std::vector<std::string> words;
  for (size_t column = 0; column < table.header().size(); ++column)
    words.emplace_back(table.word(row, column));
  return words;
}

}  // namespace

nlohmann::ordered_json write_ore_model(const ResultFolder& folder, const RunData& run,
                                       const std::string& file, const SurveyPose& pose) {
  const std::filesystem::path path = folder.file("model_moved.csv");
  std::filesystem::remove(path);
  if (file.empty()) return nlohmann::ordered_json::object();
  const CsvTable table = CsvTable::read(file);
  const size_t x = table.column("x_m"), y = table.column("y_m"), z = table.column("z_m");
  std::vector<std::string> header(table.header().begin(), table.header().end());
  for (const char* each : {"end_x_m", "end_y_m", "end_z_m", "block", "moved_m", "broken_out"})
    header.emplace_back(each);
  CsvWriter csv(path, joined(header, ","));
  const BlockFinder finder(run.blocks);
  size_t found = 0;
  for (size_t row = 0; row < table.rows(); ++row) {
    const Vec3 from = pose.of({table.number(row, x), table.number(row, y), table.number(row, z)});
    std::vector<std::string> words = words_of(table, row);
    const auto block = finder.at(from);
    if (!block) {
      words.insert(words.end(), {"", "", ""});
      csv.row(words, {kNone, kNone, kNone});
      continue;
    }
    ++found;
    const Vec3 end = moved_point(run.blocks[*block], run.last.states[*block], from);
    for (const double place : pose.back(end)) words.push_back(place_text(place));
    csv.row(words, {static_cast<double>(run.blocks[*block].id), (end - from).norm(),
                    run.moved[*block] != 0 ? 1.0 : 0.0});
  }
  if (found == 0) {
    std::filesystem::remove(path);
    refuse(file, "no cell's middle lies in a block of the run; see --shift and --turn");
  }
  return {{"model_cells", table.rows()}, {"model_cells_in_blocks", found}};
}

}  // namespace muckpile
