// SPDX-License-Identifier: GPL-2.0-or-later
// What the runs of ladder.sh have given: a table of all, their scatter, and the report for the
// page. Scope: ladder_report OUT SECONDS; lines "name|knob|setting|..." of all runs on standard
// input, OUT/runs/<name> holds summary.json and `seconds` (CPU time of user and system). Writes
// OUT/ladder.csv, ladder.md, scatter.md and cases/ladder.json. Errors are distances from the run
// `finest`; the runs of the knob `standard` differ by their seed only.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "format.h"

namespace muckpile::benchmark {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Quantity {
  const char *name, *unit;
};
constexpr std::array kQuantities{Quantity{"face_velocity_m_s", "m/s"}, Quantity{"throw_cg_m", "m"},
                                 Quantity{"beyond_toe_fraction", ""},
                                 Quantity{"joints_broken_fraction", ""}};
/// So many of them stand in the table of the page.
constexpr std::size_t kOnPage = 2;

struct Rung {
  std::string name, knob, setting;
  Json blocks, steps;
  double cpu;  // [s]
  std::array<Json, kQuantities.size()> values;
  [[nodiscard]] double value(std::size_t q) const { return values[q].get<double>(); }
};

std::ifstream opened(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path.string() + ": cannot be opened");
  return in;
}

Rung rung_of(const std::string& line, const fs::path& runs) {
  Rung rung;
  std::istringstream words(line);
  for (std::string* word : {&rung.name, &rung.knob, &rung.setting}) {
    if (!std::getline(words, *word, '|'))
      throw std::runtime_error("a run must be name|knob|setting, got '" + line + "'");
  }
  const fs::path path = runs / rung.name / "summary.json";
  std::ifstream file = opened(path);
  const Json summary = Json::parse(file);
  const auto number = [&](const char* key) {
    if (!summary.contains(key) || !summary[key].is_number())
      throw std::runtime_error(path.string() + ": has no number '" + key + "'");
    return summary[key];
  };
  rung.blocks = number("blocks");
  rung.steps = number("steps");
  for (std::size_t q = 0; q < kQuantities.size(); ++q) rung.values[q] = number(kQuantities[q].name);
  double user = 0.0, system = 0.0;
  if (!(opened(runs / rung.name / "seconds") >> user >> system))
    throw std::runtime_error((runs / rung.name / "seconds").string() + ": must hold two times");
  rung.cpu = user + system;
  return rung;
}

class Ladder {
 public:
  Ladder(std::istream& lines, const fs::path& runs) {
    for (std::string line; std::getline(lines, line);) rungs_.push_back(rung_of(line, runs));
    for (const Rung& rung : rungs_) {
      if (rung.name == "finest") finest_ = rung;
    }
    if (finest_.name.empty()) throw std::runtime_error("there is no run 'finest'");
  }

  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string table() const;
  [[nodiscard]] std::string scatter() const;
  [[nodiscard]] Json report(double seconds) const;

 private:
  // Share of the finest run's value.
  [[nodiscard]] double error(const Rung& rung, std::size_t q) const {
    return rung.value(q) / finest_.value(q) - 1.0;
  }
  [[nodiscard]] Json rows() const;
  [[nodiscard]] Json curves() const;
  [[nodiscard]] std::vector<std::string> knobs() const;
  [[nodiscard]] Json points(const std::string& knob, std::size_t q) const;

  std::vector<Rung> rungs_;
  Rung finest_;
};

std::string Ladder::csv() const {
  std::string text = "name,knob,setting,blocks,steps,cpu_s";
  for (const Quantity& quantity : kQuantities) text += "," + std::string(quantity.name);
  for (const Rung& rung : rungs_) {
    std::string setting = rung.setting;
    for (char& letter : setting) letter = letter == ',' ? ';' : letter;
    text += "\n" + rung.name + "," + rung.knob + "," + setting + "," + rung.blocks.dump() + "," +
            rung.steps.dump() + "," + formatted("%.6g", rung.cpu);
    for (const Json& value : rung.values) text += "," + value.dump();
  }
  return text + "\n";
}

std::string Ladder::table() const {
  std::string text =
      "| knob | setting | steps | CPU s | face velocity, m/s | throw of the mass centre, m |\n"
      "|---|---|---|---|---|---|\n";
  for (const Rung& rung : rungs_) {
    text += "| " + rung.knob + " | " + rung.setting + " | " + rung.steps.dump() + " | " +
            formatted("%.1f", rung.cpu);
    for (std::size_t q = 0; q < kOnPage; ++q) {
      text += " | " + formatted("%.4g", rung.value(q)) +
              formatted(" (%+.1f %%)", 100.0 * error(rung, q));
    }
    text += " |\n";
  }
  return text;
}

// Differences below this standard deviation say nothing.
std::string Ladder::scatter() const {
  std::vector<const Rung*> seeds;
  for (const Rung& rung : rungs_) {
    if (rung.knob == "standard") seeds.push_back(&rung);
  }
  const auto count = static_cast<double>(seeds.size());
  std::string text = "| quantity | mean of " + std::to_string(seeds.size()) +
                     " seeds | standard deviation |\n|---|---|---|\n";
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    double sum = 0.0, squares = 0.0;
    for (const Rung* rung : seeds) sum += rung->value(q);
    const double mean = sum / count;
    for (const Rung* rung : seeds) squares += std::pow(rung->value(q) - mean, 2);
    const double deviation = std::sqrt(squares / (count - 1.0));
    text += "| " + std::string(kQuantities[q].name) + " | " + formatted("%.4g", mean) + " | " +
            formatted("%.2g", deviation) + formatted(" (%.1f %%) |\n", 100.0 * deviation / mean);
  }
  return text;
}

Json row(const Rung& rung, const char* quantity, const char* unit) {
  return {{"case", rung.name}, {"quantity", quantity}, {"unit", unit},
          {"value", nullptr},  {"reference", 0.0},     {"source", "none"},
          {"error", nullptr},  {"tolerance", nullptr}, {"pass", true}};
}

Json Ladder::rows() const {
  Json all = Json::array();
  for (const Rung& rung : rungs_) {
    all.push_back(row(rung, "CPU time", "s"));
    all.back()["value"] = rung.cpu;
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
      Json each = row(rung, kQuantities[q].name, kQuantities[q].unit);
      each["value"] = rung.value(q);
      each["reference"] = finest_.value(q);
      each["source"] = "finest run";
      each["error"] = error(rung, q);
      all.push_back(each);
    }
  }
  return all;
}

// In order of their first run, without that of the finest.
std::vector<std::string> Ladder::knobs() const {
  std::vector<std::string> all;
  for (const Rung& rung : rungs_) {
    if (rung.name != "finest" && std::ranges::find(all, rung.knob) == all.end())
      all.push_back(rung.knob);
  }
  return all;
}

Json Ladder::points(const std::string& knob, std::size_t q) const {
  // A logarithmic axis has no 0: what is nearer than 0.01 % is drawn there.
  constexpr double kLeast = 1e-4;
  Json all = Json::array();
  for (const Rung& rung : rungs_) {
    if (rung.name == "finest" || rung.knob != knob) continue;
    all.push_back({rung.cpu, 100.0 * std::max(std::abs(error(rung, q)), kLeast)});
  }
  return all;
}

Json Ladder::curves() const {
  const std::vector<std::string> labels = knobs();
  Json all = Json::array();
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    const std::string name = kQuantities[q].name;
    for (std::size_t k = 0; k < labels.size(); ++k) {
      all.push_back({{"plot", "ladder_" + name},
                     {"title", name + ": run time against distance from the finest run"},
                     {"x_label", "CPU time, s"},
                     {"y_label", "distance, %"},
                     {"x_scale", "logarithmic"},
                     {"y_scale", "logarithmic"},
                     {"label", labels[k]},
                     {"style", "points"},
                     {"colour", k},
                     {"points", points(labels[k], q)}});
    }
  }
  return all;
}

Json Ladder::report(double seconds) const {
  return {{"report", "ladder"}, {"seconds", seconds}, {"rows", rows()}, {"curves", curves()}};
}

}  // namespace
}  // namespace muckpile::benchmark

int main(int argc, char** argv) {
  using namespace muckpile::benchmark;
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " OUT SECONDS < RUNS\n";
    return 2;
  }
  try {
    const fs::path out = argv[1];
    const Ladder ladder(std::cin, out / "runs");
    write_text(out / "ladder.csv", ladder.csv());
    write_text(out / "ladder.md", ladder.table());
    write_text(out / "scatter.md", ladder.scatter());
    fs::create_directories(out / "cases");
    write_text(out / "cases/ladder.json", ladder.report(std::stod(argv[2])).dump(1) + "\n");
  } catch (const std::exception& error) {
    std::cerr << "ladder_report: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
