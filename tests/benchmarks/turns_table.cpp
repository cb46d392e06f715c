// SPDX-License-Identifier: GPL-2.0-or-later
// Figures of two builds that ran in turns, side by side, as the rows of a Markdown table.
// Scope: turns_table RESULTS TURNS NAME...; RESULTS/old/NAME_K.json and RESULTS/new/NAME_K.json
// with K from 1 to TURNS are what the programs have printed. Times only; a figure that one build
// lacks is left out. A ratio is the median of those of the turns, as a machine's speed drifts
// between them.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;
using Figures = std::map<std::string, double>;  // by their place in the file

Json read(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path.string() + ": cannot be opened");
  return Json::parse(in);
}

bool is_time(const std::string& place) {
  const std::string key = place.substr(place.rfind('/') + 1);
  return key.find("target") == std::string::npos &&
         (key.starts_with("ns_per_") || key.find("_ns_per_") != std::string::npos ||
          key == "rebuild_wall_s" || key == "cpu_s");
}

Figures times_of(const std::filesystem::path& path) {
  Figures times;
  const Json flat = read(path).flatten();
  for (const auto& [place, value] : flat.items())
    if (value.is_number() && is_time(place)) times[place.substr(1)] = value.get<double>();
  return times;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void write_rows(const std::filesystem::path& results, int turns, const std::string& name) {
  std::map<std::string, std::vector<double>> before, after, ratios;
  for (int k = 1; k <= turns; ++k) {
    const std::string file = name + "_" + std::to_string(k) + ".json";
    const Figures old_times = times_of(results / "old" / file);
    const Figures new_times = times_of(results / "new" / file);
    for (const auto& [place, value] : new_times) {
      const auto old_time = old_times.find(place);
      if (old_time == old_times.end()) continue;
      before[place].push_back(old_time->second);
      after[place].push_back(value);
      ratios[place].push_back(value / old_time->second);
    }
  }
  for (const auto& [place, values] : ratios) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    std::printf("| %s | %s | %.4g | %.4g | %.3f | %.3f to %.3f |\n", name.c_str(), place.c_str(),
                median(before[place]), median(after[place]), median(values), *least, *most);
  }
}

void write(int argc, char** argv) {
  const int turns = std::stoi(argv[2]);
  if (turns < 1) throw std::invalid_argument("TURNS must be at least 1");
  std::puts("| program | figure | old | new | new over old | of the turns |");
  std::puts("|---|---|---|---|---|---|");
  for (int k = 3; k < argc; ++k) write_rows(argv[1], turns, argv[k]);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s RESULTS TURNS NAME...\n", argv[0]);
    return 2;
  }
  try {
    write(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "turns_table: %s\n", error.what());
    return 1;
  }
  return 0;
}
