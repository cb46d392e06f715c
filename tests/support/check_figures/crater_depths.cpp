// SPDX-License-Identifier: GPL-2.0-or-later
// Craters of one charge at several depths beside rules of practice.
// Scope: see the header.
#include "check_figures/crater_depths.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile::check {
namespace {

constexpr double kBoreskov = 1.5;     // K, of hard rock [kg/m3]
constexpr double kPokrovskii = 0.33;  // [-]

struct Crater {
  double mass = 0.0, depth = 0.0;  // [kg], [m]
  double radius = 0.0, volume = 0.0, apparent = 0.0, seeds = 0.0, at_rest = 0.0;
};

/// By depth in hundredths of m/kg^(1/3).
std::map<int, Crater> mean_craters(const CsvTable& table) {
  std::map<int, Crater> craters;
  const auto number = [&](size_t row, const char* name, double least) {
    const double value = table.number(row, table.column(name));
    if (!(value >= least))
      throw InputError(table.where(row) + name + " must be >= " + text_of(least) + ", got " +
                       text_of(value));
    return value;
  };
  for (size_t row = 0; row < table.rows(); ++row) {
    const double mass = number(row, "charge_mass_kg", 1e-6),
                 depth = number(row, "burial_depth_m", 1e-6);
    Crater& c = craters[static_cast<int>(std::lround(100.0 * depth / std::cbrt(mass)))];
    c.mass = mass;
    c.depth = depth;
    c.radius += number(row, "crater_radius_m", 0.0);
    c.volume += number(row, "crater_volume_m3", -1e9);
    c.seeds += 1.0;
    if (table.word(row, table.column("apparent_crater_depth_m")).empty()) continue;
    c.apparent += number(row, "apparent_crater_depth_m", 0.0);
    c.at_rest += 1.0;
  }
  for (auto& [at, c] : craters) {
    for (double* sum : {&c.radius, &c.volume}) *sum /= c.seeds;
    c.apparent /= c.at_rest;
  }
  return craters;
}

/// n of the crater, radius over depth; 0 where the charge throws none out.
double boreskov_index(const Crater& c) {
  const double cube = (c.mass / (kBoreskov * std::pow(c.depth, 3)) - 0.4) / 0.6;
  return cube > 0.0 ? std::cbrt(cube) : 0.0;
}

}  // namespace

Json crater_depths(const std::filesystem::path& table) {
  const std::map<int, Crater> craters = mean_craters(CsvTable::read(table));
  if (craters.size() < 3) refuse(table.string(), "needs three depths at least");
  Json figures;
  std::vector<double> volumes;
  double largest = -1e300;
  for (const auto& [at, c] : craters) {
    volumes.push_back(c.volume);
    if (c.volume > largest) figures["largest_volume_at_m_kg13"] = 0.01 * at;
    largest = std::max(largest, c.volume);
    const std::string of = "_at_" + std::to_string(at);
    figures["crater_radius_m" + of] = c.radius;
    figures["crater_volume_m3" + of] = c.volume;
    if (c.at_rest > 0.0) figures["apparent_depth_m" + of] = c.apparent;
    const double n = boreskov_index(c), visible = kPokrovskii * c.depth * (2.0 * n - 1.0);
    if (n > 0.0) figures["radius_over_boreskov" + of] = c.radius / (n * c.depth);
    if (visible > 0.0 && c.at_rest > 0.0)
      figures["apparent_over_pokrovskii" + of] = c.apparent / visible;
  }
  int maxima = 0;
  for (size_t k = 0; k < volumes.size(); ++k) {
    const bool up = k == 0 || volumes[k] > volumes[k - 1];
    const bool down = k + 1 == volumes.size() || volumes[k] >= volumes[k + 1];
    maxima += up && down ? 1 : 0;
  }
  figures["volume_maxima"] = maxima;
  return figures;
}

}  // namespace muckpile::check
