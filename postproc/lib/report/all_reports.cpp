// SPDX-License-Identifier: GPL-2.0-or-later
// Which reports a scene has, and what they have left.
// Scope: see the header.
#include "report/all_reports.h"

#include <algorithm>
#include <functional>
#include <map>

#include "args/input_error.h"
#include "provenance/run_files.h"
#include "report/burden_report.h"
#include "report/plan_report.h"
#include "report/reports.h"

namespace muckpile {
namespace {

using MakeReport = std::function<void(const ResultFolder&)>;

const std::map<std::string, MakeReport>& makers() {
  static const std::map<std::string, MakeReport> all{
      {"profile", [](const ResultFolder& f) { report_profile(f, {}, {}); }},
      {"movement", [](const ResultFolder& f) { report_movement(f, {}, {}); }},
      {"rows", [](const ResultFolder& f) { report_rows(f, {}); }},
      {"heights", [](const ResultFolder& f) { report_heights(f, {}); }},
      {"trough", [](const ResultFolder& f) { report_trough(f, {}); }},
      {"crater", [](const ResultFolder& f) { report_crater(f, {}, {}); }},
      {"heap", [](const ResultFolder& f) { report_heap(f, {}, {}); }},
      {"fragments", [](const ResultFolder& f) { report_fragments(f, {}); }},
      {"flyrock", [](const ResultFolder& f) { report_flyrock(f); }},
      {"energy", report_energy},
      {"momentum", report_momentum},
      {"render", [](const ResultFolder& f) { report_picture(f, {}); }},
      {"series", [](const ResultFolder& f) { report_series(f, 1); }},
      {"plan", [](const ResultFolder& f) { report_plan(f.file("")); }},
      {"burden", report_burden},
      {"waves", [](const ResultFolder& f) { report_waves(f); }},
      {"report", report_page},
  };
  return all;
}

// Behind its last snapshot.
bool has_impulses(const ResultFolder& folder) {
  const auto snapshots = snapshot_files(folder.dump(""));
  if (snapshots.empty()) return false;
  const long long step = snapshot_step(snapshots.back().filename().string());
  return std::filesystem::exists(folder.dump(impulses_name(step)));
}

}  // namespace

std::vector<std::string> reports_of(const ResultFolder& folder, bool with_series) {
  static const std::map<std::string, std::vector<std::string>> measures{
      {"bench", {"profile", "movement", "fragments"}},
      {"crater", {"crater", "fragments"}},
      {"heap", {"heap"}},
      {"other", {"fragments"}}};
  const std::string scene = folder.scene_word("case");
  const auto found = measures.find(scene);
  if (found == measures.end()) {
    throw InputError(folder.dump("scene.json").string() +
                     ": case must be bench, crater, heap or other, got '" + scene + "'");
  }
  std::vector<std::string> names = found->second;
  const bool pattern = std::filesystem::exists(folder.dump("holes.csv"));
  if (pattern && scene == "bench") names.insert(names.end(), {"rows", "heights"});
  const bool ended = std::filesystem::exists(folder.dump("run.json"));
  if (pattern && scene == "bench" && ended && folder.is_still()) names.emplace_back("trough");
  if (scene == "bench" && folder.scene_has("explosive_density_kg_m3"))
    names.emplace_back("flyrock");
  names.insert(names.end(), {"energy", "render"});
  if (with_series) names.emplace_back("series");
  if (pattern) names.emplace_back("plan");
  if (std::filesystem::exists(folder.dump("burden.csv"))) names.emplace_back("burden");
  if (std::filesystem::exists(folder.dump("gauges.csv"))) names.emplace_back("waves");
  if ((scene == "bench" || scene == "crater") && has_impulses(folder))
    names.emplace_back("momentum");
  names.emplace_back("report");  // shows what the others have left
  return names;
}

void make_report(const ResultFolder& folder, const std::string& name) { makers().at(name)(folder); }

std::string summary_lines(const ResultFolder& folder) {
  constexpr std::size_t kValueColumn = 28;
  std::string text;
  const nlohmann::ordered_json summary = read_json_object(folder.file("summary.json"));
  for (const auto& [key, value] : summary.items()) {
    text += "  " + key + std::string(kValueColumn - std::min(kValueColumn, key.size()), ' ') + " " +
            (value.is_string() ? value.get<std::string>() : value.dump()) + "\n";
  }
  return text;
}

std::vector<std::filesystem::path> pictures_in(const ResultFolder& folder) {
  std::vector<std::filesystem::path> pictures;
  for (const auto& entry : std::filesystem::directory_iterator(folder.file(""))) {
    if (entry.path().extension() == ".png") pictures.push_back(entry.path());
  }
  std::ranges::sort(pictures);
  return pictures;
}

}  // namespace muckpile
