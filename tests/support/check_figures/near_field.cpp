// SPDX-License-Identifier: GPL-2.0-or-later
// Peak particle velocity beside an endless charge.
// Scope: see the header.
#include "check_figures/near_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "check_figures/positive_number.h"
#include "check_figures/power_exponent.h"

namespace muckpile::check {
namespace {

struct Peak {
  double distance, speed, charge;  // [m], [m/s], [kg/m]
};

std::vector<Peak> peaks_between(const std::filesystem::path& file, double near, double far) {
  const CsvTable table = CsvTable::read(file);
  std::vector<Peak> peaks;
  for (size_t row = 0; row < table.rows(); ++row) {
    const double distance = positive_number(table, row, "distance_m");
    if (distance < near || distance > far) continue;
    const double root_of_charge = distance / positive_number(table, row, "scaled_distance_m_kg05");
    peaks.push_back(
        {distance, positive_number(table, row, "ppv_m_s"), root_of_charge * root_of_charge});
  }
  if (peaks.size() < 2)
    refuse(file.string(),
           "needs two gauges between " + text_of(near) + " and " + text_of(far) + " m");
  return peaks;
}

}  // namespace

double holmberg_persson(double charge_per_metre, double distance) {
  return 0.7 * std::pow(std::numbers::pi * charge_per_metre / distance, 0.7);
}

Json near_field(const std::vector<std::filesystem::path>& folders, double near, double far) {
  if (!(0.0 < near && near < far && std::isfinite(far)))
    refuse("near_field",
           "must have 0 < NEAREST < FARTHEST [m], got " + text_of(near) + " and " + text_of(far));
  Json result = Json::object();
  for (const std::filesystem::path& folder : folders) {
    const std::vector<Peak> peaks = peaks_between(folder / "ppv.csv", near, far);
    std::vector<double> ratios;
    std::vector<std::pair<double, double>> speeds;
    double mean = 0.0;
    for (const Peak& peak : peaks) {
      speeds.emplace_back(peak.distance, peak.speed);
      ratios.push_back(peak.speed / holmberg_persson(peak.charge, peak.distance));
      mean += std::log(ratios.back()) / static_cast<double>(peaks.size());
    }
    const std::string name = (folder / "").parent_path().filename().string();
    if (result.contains(name + "_over_law")) refuse(folder.string(), name + " is there twice");
    result[name + "_over_law"] = std::exp(mean);
    result[name + "_over_law_least"] = *std::min_element(ratios.begin(), ratios.end());
    result[name + "_over_law_most"] = *std::max_element(ratios.begin(), ratios.end());
    const auto exponent = power_exponent(speeds);
    if (!exponent) refuse(folder.string(), "has gauges at one distance only");
    result[name + "_distance_exponent"] = *exponent;
  }
  return result;
}

}  // namespace muckpile::check
