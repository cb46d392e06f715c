// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of runs of one blast.
// Scope: see the header.
#include "tables.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>

#include "args/input_error.h"
#include "figures/figures.h"

namespace muckpile::check {
namespace {

std::ifstream opened(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) refuse(path.string(), "cannot be opened");
  return in;
}

/// The summaries of one run's cuts.
class Cuts {
 public:
  Cuts(const std::filesystem::path& results, const std::string& run) {
    const std::filesystem::path folder = results / run;
    std::set<std::filesystem::path> cuts;
    std::error_code unheeded;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unheeded))
      if (entry.is_directory()) cuts.insert(entry.path());
    if (cuts.empty()) refuse(folder.string(), "has no folder of a cut");
    for (const auto& cut : cuts) cuts_.emplace_back(cut / "summary.json");
  }

  /// Mean over the cuts.
  [[nodiscard]] double get(const std::string& quantity) const {
    double sum = 0.0;
    for (const FigureFile& cut : cuts_) sum += figure_in(cut, quantity);
    return sum / static_cast<double>(cuts_.size());
  }
  /// Nothing where a cut has none.
  [[nodiscard]] std::optional<double> find(const std::string& quantity) const {
    const auto lacks = [&](const FigureFile& cut) {
      return cut.is_null(quantity) || !cut.find(quantity);
    };
    return std::ranges::any_of(cuts_, lacks) ? std::nullopt : std::optional(get(quantity));
  }

 private:
  [[nodiscard]] static double figure_in(const FigureFile& summary, const std::string& quantity) {
    if (quantity == "burden_speed_m_s")
      return summary.get("throw_cg_m") / summary.get("physical_time_s");
    if (quantity == "load_work_J") return summary.get("wave_work_J") + summary.get("gas_work_J");
    return summary.get(quantity);
  }

  std::vector<FigureFile> cuts_;
};

std::string formatted(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// Figures of one run as text, in the order of kColumns.
std::vector<std::string> figures_of_run(const Cuts& run, const Cuts& base) {
  const double speed = run.get("burden_speed_m_s");
  const double energy = run.get("explosive_energy_J");
  std::vector<std::string> figures{formatted("%.1f", run.get("face_velocity_mean_m_s")),
                                   formatted("%.2f", speed),
                                   formatted("%.2f", speed / base.get("burden_speed_m_s"))};
  for (const char* part :
       {"wave_work_J", "gas_work_J", "energy_audit_J.crushing", "energy_audit_J.rock_heat",
        "energy_audit_J.vented", "energy_audit_J.stemming"})
    figures.push_back(formatted("%.1f", 100.0 * run.get(part) / energy));
  figures.push_back(formatted("%.2f", 100.0 * run.get("energy_audit_error")));
  // Stemming that is in the hole at the end has no such time.
  const auto out = run.find("stemming_out_s");
  figures.push_back(out ? formatted("%.1f", 1000.0 * *out) : std::string());
  return figures;
}

struct Column {
  const char* in_csv;
  const char* on_page;  // nullptr: in the CSV file only
};

constexpr std::array<Column, 11> kColumns{{{"face_velocity_mean_m_s", nullptr},
                                           {"burden_speed_m_s", "burden, m/s"},
                                           {"burden_speed_over_base", "over base"},
                                           {"wave_work_percent", "wave"},
                                           {"gas_work_percent", "gas"},
                                           {"crushing_percent", nullptr},
                                           {"rock_heat_percent", nullptr},
                                           {"vented_percent", nullptr},
                                           {"stemming_percent", nullptr},
                                           {"missing_percent", nullptr},
                                           {"stemming_out_ms", nullptr}}};

/// Calls each(name, figures) for the run `base` and those of the scene.
template <class Each>
void for_each_run(const std::filesystem::path& runs, const std::filesystem::path& results,
                  const std::string& scene, const Each& each) {
  const Cuts base(results, "base");
  for (const auto& row : rows_of(runs)) {
    if (row.size() < 2) refuse(runs.string(), "run '" + row[0] + "' has no scene");
    if (row[0] == "base" || row[1] == scene)
      each(row[0], figures_of_run(Cuts(results, row[0]), base));
  }
}

}  // namespace

std::vector<std::vector<std::string>> rows_of(const std::filesystem::path& file) {
  std::ifstream in = opened(file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<std::string> row{std::istream_iterator<std::string>(words), {}};
    if (!row.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

double figure_of(const std::filesystem::path& results, const std::string& run,
                 const std::string& quantity) {
  return Cuts(results, run).get(quantity);
}

std::string answers_table(const std::filesystem::path& answers,
                          const std::filesystem::path& results) {
  std::string table = "name,factor,value,base\n";
  for (const auto& row : rows_of(answers)) {
    if (row.size() != 5)
      refuse(answers.string(), "a row must be NAME FACTOR QUANTITY RUN BASE, got '" + row[0] +
                                   "' with " + std::to_string(row.size()) + " words");
    const auto figure = [&](const std::string& run) {
      return run == "-" ? std::string() : text_of(figure_of(results, run, row[2]));
    };
    table += row[0] + "," + (row[1] == "-" ? "" : row[1]) + "," + figure(row[3]) + "," +
             figure(row[4]) + "\n";
  }
  return table;
}

std::string runs_csv(const std::filesystem::path& runs, const std::filesystem::path& results,
                     const std::string& scene) {
  std::string table = "run";
  for (const Column& column : kColumns) table += std::string(",") + column.in_csv;
  table += "\n";
  for_each_run(runs, results, scene,
               [&](const std::string& name, const std::vector<std::string>& figures) {
                 table += name;
                 for (const std::string& figure : figures) table += "," + figure;
                 table += "\n";
               });
  return table;
}

std::string runs_table(const std::filesystem::path& runs, const std::filesystem::path& results,
                       const std::string& scene) {
  std::string table = "| run |", rule = "|---|";
  for (const Column& column : kColumns) {
    if (column.on_page == nullptr) continue;
    table += std::string(" ") + column.on_page + " |";
    rule += "---|";
  }
  table += "\n" + rule + "\n";
  for_each_run(runs, results, scene,
               [&](const std::string& name, const std::vector<std::string>& figures) {
                 table += "| " + name + " |";
                 for (std::size_t k = 0; k < kColumns.size(); ++k)
                   if (kColumns[k].on_page != nullptr) table += " " + figures[k] + " |";
                 table += "\n";
               });
  return table;
}

std::string with_table(const std::filesystem::path& page, const std::string& scene,
                       const std::string& table) {
  const std::string begin = "<!-- runs: " + scene + " -->", end = "<!-- end of runs -->";
  std::ifstream in = opened(page);
  std::string text;
  bool inside = false, begun = false;
  for (std::string line; std::getline(in, line);) {
    if (line == end) inside = false;
    if (!inside) text += line + "\n";
    if (line != begin) continue;
    text += table;
    inside = begun = true;
  }
  if (!begun) refuse(page.string(), "has no line '" + begin + "'");
  if (inside) refuse(page.string(), "has no line '" + end + "' behind '" + begin + "'");
  return text;
}

}  // namespace muckpile::check
