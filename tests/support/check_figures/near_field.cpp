// SPDX-License-Identifier: GPL-2.0-or-later
// Peak particle velocity beside one charge.
// Scope: see the header.
#include "check_figures/near_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "analytic/cavity.h"
#include "args/csv_table.h"
#include "args/input_error.h"
#include "check_figures/positive_number.h"
#include "check_figures/power_exponent.h"

namespace muckpile::check {
namespace {

struct Peak {
  double distance, speed, charge;  // [m], [m/s], [kg/m]
  double height, scaled;           // [m], [m/kg^0.5]
};

/// `length` [m] is the charge's.
std::vector<Peak> peaks_between(const std::filesystem::path& folder, double length, double near,
                                double far) {
  const std::filesystem::path file = folder / "ppv.csv";
  const CsvTable table = CsvTable::read(file);
  std::vector<Peak> peaks;
  for (size_t row = 0; row < table.rows(); ++row) {
    const double distance = positive_number(table, row, "distance_m");
    if (distance < near || distance > far) continue;
    const double scaled = positive_number(table, row, "scaled_distance_m_kg05");
    const double mass = distance * distance / (scaled * scaled);
    peaks.push_back({distance, positive_number(table, row, "ppv_m_s"), mass / length,
                     table.number(row, table.column("z_m")), scaled});
  }
  if (peaks.size() < 2)
    refuse(file.string(),
           "needs two gauges between " + text_of(near) + " and " + text_of(far) + " m");
  return peaks;
}

FigureFile scene_of(const std::filesystem::path& folder) {
  return FigureFile(folder / "dump" / "scene.json");
}

std::string name_of(const std::filesystem::path& folder) {
  return (folder / "").parent_path().filename().string();
}

template <class Number>
double log_mean(const std::vector<Peak>& peaks, Number&& number) {
  double mean = 0.0;
  for (const Peak& peak : peaks) mean += std::log(number(peak)) / static_cast<double>(peaks.size());
  return std::exp(mean);
}

/// n of y = c r^n.
template <class Number>
double exponent_over_distance(const std::vector<Peak>& peaks, const std::filesystem::path& folder,
                              Number&& number) {
  std::vector<std::pair<double, double>> points;
  for (const Peak& peak : peaks) points.emplace_back(peak.distance, number(peak));
  const auto exponent = power_exponent(points);
  if (!exponent) refuse(folder.string(), "has gauges at one distance only");
  return *exponent;
}

double speed_of(const Peak& peak) { return peak.speed; }

/// Of the load at a distance [m], within 0.1 %: the peak comes within three rises of the front.
double elastic_peak(const ElasticLoad& load, double distance) {
  constexpr double kWait = 3.0, kStep = 0.02;  // in rises
  const ElasticMedium rock = elastic_medium(load.density, load.youngs_modulus, load.poisson_ratio);
  const PressureTransform pressure = starfield_pressure(load.peak, load.rise_time);
  const double arrival = (distance - load.radius) / rock.p_speed;
  double peak = 0.0;
  for (double since = kStep; since < kWait; since += kStep)
    peak = std::max(peak, cavity_response(CavityShape::cylinder, rock, load.radius, pressure,
                                          distance, arrival + since * load.rise_time)
                              .velocity);
  return peak;
}

std::string hundredths(double metres) { return std::to_string(std::lround(100.0 * metres)); }

}  // namespace

double holmberg_persson(double charge_per_metre, double distance) {
  return 0.7 * std::pow(std::numbers::pi * charge_per_metre / distance, 0.7);
}

double holmberg_persson(double charge_per_metre, double distance, double above_toe,
                        double below_top) {
  const double angle = std::atan(above_toe / distance) + std::atan(below_top / distance);
  return 0.7 * std::pow(charge_per_metre / distance * angle, 0.7);
}

Json near_field(const std::vector<std::filesystem::path>& folders, double near, double far,
                const std::optional<ElasticLoad>& load) {
  if (!(0.0 < near && near < far && std::isfinite(far)))
    refuse("near_field",
           "must have 0 < NEAREST < FARTHEST [m], got " + text_of(near) + " and " + text_of(far));
  Json result = Json::object();
  for (const std::filesystem::path& folder : folders) {
    const double length = scene_of(folder).get("charge_length_m");
    const std::vector<Peak> peaks = peaks_between(folder, length, near, far);
    const std::string name = name_of(folder);
    if (result.contains(name + "_over_law")) refuse(folder.string(), name + " is there twice");
    const auto over_law = [](const Peak& peak) {
      return peak.speed / holmberg_persson(peak.charge, peak.distance);
    };
    std::vector<double> ratios;
    for (const Peak& peak : peaks) ratios.push_back(over_law(peak));
    result[name + "_over_law"] = log_mean(peaks, over_law);
    result[name + "_over_law_least"] = *std::min_element(ratios.begin(), ratios.end());
    result[name + "_over_law_most"] = *std::max_element(ratios.begin(), ratios.end());
    result[name + "_distance_exponent"] = exponent_over_distance(peaks, folder, speed_of);
    if (!load) continue;
    const auto exact = [&](const Peak& peak) { return elastic_peak(*load, peak.distance); };
    result[name + "_over_elastic"] = log_mean(peaks, speed_of) / log_mean(peaks, exact);
    result[name + "_elastic_exponent"] = exponent_over_distance(peaks, folder, exact);
  }
  return result;
}

Json hole_vibration(const std::vector<std::filesystem::path>& folders,
                    const std::vector<double>& distances) {
  if (distances.size() < 2 || !(distances.front() > 0.0) ||
      !std::is_sorted(distances.begin(), distances.end()))
    refuse("hole_vibration", "must have two distances [m] or more, the least first, all > 0");
  Json result = Json::object();
  for (const std::filesystem::path& folder : folders) {
    const std::string name = name_of(folder);
    if (result.contains(name + "_over_bureau_most"))
      refuse(folder.string(), name + " is there twice");
    const FigureFile scene = scene_of(folder);
    const double length = scene.get("charge_length_m"), toe = -scene.get("subdrill_m");
    const std::vector<Peak> all =
        peaks_between(folder, length, distances.front(), distances.back());
    const auto law = [&](const Peak& peak) {
      // From the axis: the way to an end of the charge has a part along it.
      const double beyond = std::max({0.0, toe - peak.height, peak.height - toe - length});
      return holmberg_persson(peak.charge,
                              std::sqrt(peak.distance * peak.distance - beyond * beyond),
                              peak.height - toe, toe + length - peak.height);
    };
    std::map<std::pair<long, size_t>, std::vector<Peak>> groups;
    double most = 0.0;
    for (const Peak& peak : all) {
      const auto next = std::upper_bound(distances.begin(), distances.end(), peak.distance);
      const auto place = static_cast<size_t>(next - distances.begin());
      groups[{std::lround(100.0 * peak.height), std::min(place, distances.size() - 1)}].push_back(
          peak);
      most = std::max(most, peak.speed / (1.65 * std::pow(peak.scaled, -1.62)));
    }
    for (const auto& [of, peaks] : groups) {
      const std::string group = name + "_at_" + std::to_string(of.first) + "_from_" +
                                hundredths(distances[of.second - 1]);
      result[group + "_over_law"] =
          log_mean(peaks, [&](const Peak& peak) { return peak.speed / law(peak); });
      result[group + "_distance_exponent"] = exponent_over_distance(peaks, folder, speed_of);
      result[group + "_law_exponent"] = exponent_over_distance(peaks, folder, law);
    }
    result[name + "_over_bureau_most"] = most;
  }
  return result;
}

}  // namespace muckpile::check
