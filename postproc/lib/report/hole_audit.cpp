// SPDX-License-Identifier: GPL-2.0-or-later
// Energies of the charges hole by hole.
// Scope: see the header.
#include "report/hole_audit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/csv_writer.h"

namespace muckpile {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<Json> audited_holes(const Json& run) {
  std::vector<Json> holes;
  const auto all = run.find("holes");
  if (all == run.end() || !all->is_array()) return holes;
  std::ranges::copy_if(*all, std::back_inserter(holes),
                       [](const Json& hole) { return hole.contains("energy_audit_J"); });
  return holes;
}

double number(const Json& object, const char* key) {
  const auto value = object.find(key);
  return value != object.end() && value->is_number() ? value->get<double>() : kNone;
}

}  // namespace

Json hole_audit_keys(const Json& run) {
  const std::vector<Json> holes = audited_holes(run);
  Json keys = Json::object();
  if (holes.empty()) return keys;
  double worst = 0.0, first = kNone, fastest = kNone;
  for (const Json& hole : holes) {
    const double error = number(hole, "energy_audit_error");
    if (std::abs(error) > std::abs(worst)) worst = error;
    const double out = number(hole, "stemming_out_s");
    if (std::isnan(out)) continue;
    first = std::fmin(first, out);
    fastest = std::fmax(fastest, number(hole, "stemming_speed_m_s"));
  }
  keys["energy_audit_error_worst_hole"] = worst;
  keys["stemming_out_s"] = nullptr;
  keys["stemming_speed_m_s"] = nullptr;
  if (!std::isnan(first)) keys["stemming_out_s"] = first;
  if (!std::isnan(fastest)) keys["stemming_speed_m_s"] = fastest;
  return keys;
}

void write_hole_audits(const ResultFolder& folder) {
  const std::filesystem::path path = folder.file("energy_holes.csv");
  const std::vector<Json> holes = audited_holes(read_json_object(folder.dump("run.json")));
  if (holes.empty()) {
    std::filesystem::remove(path);
    return;
  }
  std::vector<std::string> terms;
  std::string header = "hole";
  for (const auto& [term, energy] : holes.front().at("energy_audit_J").items()) {
    terms.push_back(term);
    header += "," + term + "_J";
  }
  CsvWriter table(path, header + ",error_share,stemming_out_s,stemming_speed_m_s");
  double count = 0.0;
  for (const Json& hole : holes) {
    std::vector<double> row{count += 1.0};
    for (const std::string& term : terms)
      row.push_back(number(hole.at("energy_audit_J"), term.c_str()));
    for (const char* key : {"energy_audit_error", "stemming_out_s", "stemming_speed_m_s"})
      row.push_back(number(hole, key));
    table.row(row);
  }
}

}  // namespace muckpile
