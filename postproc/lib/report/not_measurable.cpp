// SPDX-License-Identifier: GPL-2.0-or-later
// What a refused report leaves behind: a reason, and no figures.
// Scope: see the header.
#include "report/not_measurable.h"

#include "report/reports.h"

namespace muckpile {

std::string refusal_key(const std::string& report) { return report + "_refused"; }

void take_back(const ResultFolder& folder, const std::string& report,
               const nlohmann::ordered_json& own_keys, const NotMeasurable& why) {
  for (const char* ending : {".csv", ".png"}) std::filesystem::remove(folder.file(report + ending));
  std::vector<std::string> names;
  for (const auto& [name, value] : own_keys.items()) names.push_back(name);
  nlohmann::ordered_json keys = common_keys(folder);
  keys[refusal_key(report)] = why.what();
  folder.merge_into_summary(keys, names);
}

void refuse_to_measure(const ResultFolder& folder, const std::string& report,
                       const std::string& words) {
  const NotMeasurable why(report + ": " + words);
  if (std::filesystem::exists(folder.dump("run.json"))) take_back(folder, report, {}, why);
  throw why;
}

}  // namespace muckpile
