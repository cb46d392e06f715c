// SPDX-License-Identifier: GPL-2.0-or-later
// The runs of ./muckpile sweep.
// Scope: see the header.
#include "sweep/sweep_runs.h"

#include <algorithm>
#include <set>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "args/suggestion.h"
#include "compare/run_figures.h"
#include "page/figures_table.h"
#include "provenance/knobs.h"

namespace muckpile {
namespace {

constexpr const char* kSeed = "seed";
constexpr size_t kFirstVariable = 2;  // columns before: folder, state

CsvTable read_list(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "sweep_runs.csv";
  if (!std::filesystem::exists(path))
    refuse(path.string(), "is not there; './muckpile sweep' writes it");
  CsvTable table = CsvTable::read(path);
  const auto& header = table.header();
  if (header.size() <= kFirstVariable || header[0] != "folder" || header[1] != "state")
    refuse(path.string(), "must have the columns folder, state and one for each swept variable");
  if (table.rows() == 0) refuse(path.string(), "has no row");
  return table;
}

// Empty unless each value is a number.
std::vector<double> numbers_of(const std::vector<std::string>& values) {
  std::vector<double> numbers;
  for (const std::string& value : values) {
    const Spelt spelt = read_spelling(value);
    if (const auto* whole = std::get_if<long>(&spelt))
      numbers.push_back(static_cast<double>(*whole));
    if (const auto* real = std::get_if<double>(&spelt)) numbers.push_back(*real);
  }
  if (numbers.size() != values.size()) numbers.clear();
  return numbers;
}

SweptVariable read_variable(const CsvTable& table, size_t column) {
  SweptVariable variable{std::string(table.header()[column]), "", {}, {}};
  for (size_t row = 0; row < table.rows(); ++row) {
    const std::string value(table.word(row, column));
    if (value.empty()) throw InputError(table.where(row) + variable.name + " has no value");
    if (std::ranges::find(variable.values, value) == variable.values.end())
      variable.values.push_back(value);
  }
  variable.numbers = numbers_of(variable.values);
  return variable;
}

SweepRun read_run(const CsvTable& table, size_t row, const std::vector<size_t>& columns,
                  const Sweep& sweep) {
  static const std::vector<std::string> kStates{"done", "failed", "interrupted", "waiting",
                                                "measure"};
  SweepRun run;
  run.folder = table.word(row, 0);
  std::ranges::replace(run.folder, ';', ',');  // a table without quotes has no commas in its fields
  run.state = table.word(row, 1);
  if (std::ranges::find(kStates, run.state) == kStates.end())
    throw InputError(table.where(row) + "state must be one of " + joined(kStates) + ", got '" +
                     run.state + "'");
  for (size_t k = 0; k < columns.size(); ++k) {
    const auto& values = sweep.variables[k].values;
    const auto found = std::ranges::find(values, table.word(row, columns[k]));
    run.place.push_back(static_cast<size_t>(found - values.begin()));
  }
  if (sweep.has_seeds) run.seed = table.word(row, table.column(kSeed));
  return run;
}

std::string text_of_knob(const check::Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// A folder may hold the results of a run of its own, with other values.
void require_values(const check::Json& scene, const std::filesystem::path& file,
                    const CsvTable& table, size_t row) {
  if (!scene.contains("knobs") || !scene["knobs"].is_object())
    refuse(file.string(), "has no object 'knobs': it is no scene of write_scene");
  const check::Json& knobs = scene["knobs"];
  for (size_t column = kFirstVariable; column < table.header().size(); ++column) {
    const std::string name(table.header()[column]), wanted(table.word(row, column));
    const std::string found = knobs.contains(name) ? text_of_knob(knobs[name]) : "missing";
    if (!same_value(found, wanted))
      refuse(file.string(), "is of another run: " + name + " is '" + found + "', the sweep has '" +
                                wanted + "'; './muckpile sweep' with the same words runs it anew");
  }
}

// By a key of the scene that is the variable's name and a unit.
void take_units(const check::Json& scene, std::vector<SweptVariable>& variables) {
  for (SweptVariable& variable : variables) {
    std::string name = variable.name;
    std::ranges::replace(name, '_', ' ');
    for (const auto& [key, value] : scene.items()) {
      const KeyAndUnit split = split_unit(key);
      if (variable.unit.empty() && split.name == name) variable.unit = split.unit;
    }
  }
}

void read_results(SweepRun& run, Sweep& sweep, const CsvTable& table, size_t row) {
  const std::filesystem::path folder = sweep.folder / run.folder;
  const std::filesystem::path scene_file = folder / "dump" / "scene.json";
  const check::Json scene = check::read_json_object(scene_file);
  require_values(scene, scene_file, table, row);
  take_units(scene, sweep.variables);
  const RunFigures figures = read_run_figures(folder / "summary.json");
  const auto id = figures.values.find("run_id");
  if (id != figures.values.end() && scene.contains("run_id") && id->second != scene["run_id"])
    refuse(figures.name, "is of another run than " + scene_file.string());
  const std::string kind = figures.values.at("case").get<std::string>();
  if (sweep.kind.empty()) sweep.kind = kind;
  if (kind != sweep.kind)
    refuse(figures.name,
           "is of a case '" + kind + "', those before it are of '" + sweep.kind + "'");
  for (const auto& [key, value] : figures.values) {
    if (value.is_number()) run.figures[key] = value.get<double>();
    if (value.is_boolean()) run.figures[key] = value.get<bool>() ? 1.0 : 0.0;
  }
}

}  // namespace

std::string SweptVariable::label() const {
  std::string words = name;
  std::ranges::replace(words, '_', ' ');
  return unit.empty() ? words : words + " [" + unit + "]";
}

std::optional<double> SweepRun::figure(const std::string& key) const {
  const auto found = figures.find(key);
  return found == figures.end() ? std::nullopt : std::optional(found->second);
}

std::string Sweep::words_for(const SweepRun& run, size_t first_variable) const {
  std::vector<std::string> words;
  for (size_t k = first_variable; k < variables.size(); ++k) {
    const SweptVariable& variable = variables[k];
    std::string name = variable.name;
    std::ranges::replace(name, '_', ' ');
    words.push_back(name + " " + variable.values[run.place[k]] +
                    (variable.unit.empty() ? "" : " " + variable.unit));
  }
  return joined(words);
}

Sweep read_sweep(const std::filesystem::path& folder) {
  const CsvTable table = read_list(folder);
  Sweep sweep;
  sweep.folder = folder;
  sweep.is_sampled = std::ranges::any_of(
      table.remarks(), [](std::string_view remark) { return remark.starts_with(" sampled "); });
  sweep.has_seeds =
      table.find_column(kSeed).has_value() && table.header().size() > kFirstVariable + 1;
  std::vector<size_t> columns;
  for (size_t column = kFirstVariable; column < table.header().size(); ++column) {
    if (sweep.has_seeds && table.header()[column] == kSeed) continue;
    columns.push_back(column);
    sweep.variables.push_back(read_variable(table, column));
  }
  std::set<std::string> figures;
  for (size_t row = 0; row < table.rows(); ++row) {
    sweep.runs.push_back(read_run(table, row, columns, sweep));
    SweepRun& run = sweep.runs.back();
    if (!run.is_done()) continue;
    read_results(run, sweep, table, row);
    for (const auto& [key, value] : run.figures) figures.insert(key);
  }
  sweep.figures.assign(figures.begin(), figures.end());
  if (sweep.kind.empty()) refuse(folder.string(), "holds no run that has ended well");
  return sweep;
}

}  // namespace muckpile
