// SPDX-License-Identifier: GPL-2.0-or-later
// Which run wrote the files of a dump folder.
// Scope: of blocks.vtk and the snapshots only the first lines are read.
#include "io/run_id.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "io/result_folder.h"
#include "io/snapshot.h"
#include "provenance/run_files.h"

namespace muckpile {
namespace {

struct Origin {
  std::string file;
  std::string run;  // "" if the file has no id
};

// The id in line `number`, counted from 1. VTK lets the title of a file be any words.
std::string id_in_line(const std::filesystem::path& path, int number) {
  std::ifstream in(path);
  std::string line;
  for (int k = 0; k < number; ++k) std::getline(in, line);
  return run_id_in(line);
}

// One for each id that the rows have: a second run may have gone on writing at the end.
void add_table(const std::filesystem::path& path, std::vector<Origin>& origins) {
  const CsvTable table = CsvTable::read(path);
  const auto column = table.find_column("run_id");
  if (!column) {
    origins.push_back({path.string(), {}});
    return;
  }
  std::string before = "none";
  for (size_t row = 0; row < table.rows(); ++row) {
    const std::string_view word = table.word(row, *column);
    const std::string id(is_run_id(word) ? word : std::string_view());
    if (id == before) continue;
    const std::string where = table.where(row);  // ends in ": "
    origins.push_back({row == 0 ? path.string() : where.substr(0, where.size() - 2), id});
    before = id;
  }
}

std::vector<Origin> origins_in(const std::filesystem::path& dump) {
  std::vector<Origin> origins;
  const auto add = [&](const std::filesystem::path& path, auto&& id_of) {
    if (std::filesystem::exists(path)) origins.push_back({path.string(), id_of(path)});
  };
  add(dump / "blocks.vtk", [](const auto& path) { return id_in_line(path, 2); });
  add(dump / "run.json", run_id_in_json);
  // A script that prints this file by itself gives it no id.
  if (std::filesystem::exists(dump / "scene.json") && !run_id_in_json(dump / "scene.json").empty())
    add(dump / "scene.json", run_id_in_json);
  for (const char* name : {"history.csv", "gauges.csv", "burden.csv"})
    if (std::filesystem::exists(dump / name)) add_table(dump / name, origins);
  const auto id_in_first_line = [](const auto& path) { return id_in_line(path, 1); };
  add(dump / kJointsFile, id_in_first_line);
  for (const auto& path : snapshot_files(dump)) add(path, id_in_first_line);
  return origins;
}

std::string words_for(const Origin& origin) {
  return origin.file + (origin.run.empty() ? " has no run id" : " is of run " + origin.run);
}

}  // namespace

std::string run_id_in_json(const std::filesystem::path& path) {
  const nlohmann::ordered_json object = read_json_object(path);
  const auto found = object.find("run_id");
  if (found == object.end() || !found->is_string()) return {};
  const auto id = found->get<std::string>();
  return is_run_id(id) ? id : std::string();
}

std::string run_id_of(const std::filesystem::path& dump) {
  const std::vector<Origin> origins = origins_in(dump);
  const auto known = std::ranges::find_if(origins, [](const Origin& o) { return !o.run.empty(); });
  if (known == origins.end()) return {};
  for (const Origin& origin : origins) {
    if (origin.run == known->run) continue;
    throw InputError(words_for(origin) + ", but " + words_for(*known) +
                     ": files of two runs lie in one folder; run the input again into a folder "
                     "that is empty, or take away what the other run has left");
  }
  return known->run;
}

}  // namespace muckpile
