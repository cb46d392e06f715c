// SPDX-License-Identifier: GPL-2.0-or-later
// Figures of summary.json and scene.json in words.
// Scope: see the header.
#include "page/figures_table.h"

#include <algorithm>
#include <cmath>

#include "draw/axes.h"

namespace muckpile {
namespace {

struct Unit {
  const char *ending, *text;
};

// Longer endings first.
constexpr Unit kUnits[] = {{"_kg_m3", "kg/m³"}, {"_J_kg", "J/kg"}, {"_rad_s", "rad/s"},
                           {"_m_s", "m/s"},     {"_m3", "m³"},     {"_m2", "m²"},
                           {"_deg", "°"},       {"_kg", "kg"},     {"_Pa", "Pa"},
                           {"_fraction", "%"},  {"_share", "%"},   {"_m", "m"},
                           {"_s", "s"},         {"_J", "J"},       {"_t", "t"}};

constexpr const char* kNoBreak = "\u202f";  // narrow no-break space

std::string with_prefix(double value, const std::string& unit) {
  constexpr struct {
    double size;
    const char* letter;
  } kPrefixes[] = {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}};
  for (const auto& [size, letter] : kPrefixes) {
    if (std::abs(value) >= size) return rounded(value / size) + kNoBreak + letter + unit;
  }
  return rounded(value) + kNoBreak + unit;
}

std::string number_in_words(double value, const std::string& unit) {
  if (unit.empty()) return rounded(value);
  if (unit == "%") return rounded(100.0 * value) + kNoBreak + "%";
  if (unit == "°") return rounded(value) + unit;
  if (unit == "J" || unit == "Pa" || unit == "J/kg") return with_prefix(value, unit);
  return rounded(value) + kNoBreak + unit;
}

}  // namespace

KeyAndUnit split_unit(const std::string& key) {
  KeyAndUnit split{key, ""};
  const size_t dot = key.find("_J.");  // terms of the audit
  if (dot != std::string::npos) split = {key.substr(0, dot) + " " + key.substr(dot + 3), "J"};
  for (const Unit& unit : kUnits) {
    if (!split.unit.empty() || !key.ends_with(unit.ending)) continue;
    split = {key.substr(0, key.size() - std::string(unit.ending).size()), unit.text};
  }
  std::ranges::replace(split.name, '_', ' ');
  return split;
}

std::string rounded(double value) {
  if (std::abs(value) < 1000.0) return spelled(value);
  if (std::abs(value) >= 1e15) return spelled(value);
  std::string digits = std::to_string(std::llround(value));
  for (auto at = static_cast<long>(digits.size()) - 3; at > (value < 0.0 ? 1 : 0); at -= 3)
    digits.insert(static_cast<size_t>(at), kNoBreak);
  return digits;
}

std::string in_words(const std::string& key, const check::Json& value) {
  if (value.is_null()) return "none";
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number()) return number_in_words(value.get<double>(), split_unit(key).unit);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

const std::vector<NamedKey>& key_figures() {
  static const std::vector<NamedKey> figures{{"throw_cg_m", "Throw of the mass centre"},
                                             {"pile_height_m", "Height of the pile"},
                                             {"pile_toe_m", "Toe, from the face"},
                                             {"swell_factor", "Swell"},
                                             {"repose_angle_deg", "Angle of repose"},
                                             {"beyond_toe_fraction", "Beyond the old toe"},
                                             {"face_velocity_m_s", "Face velocity"},
                                             {"crater_radius_m", "Radius of the crater"},
                                             {"crater_depth_m", "Depth of the crater"},
                                             {"crater_volume_m3", "Volume of the crater"},
                                             {"ejecta_mass_kg", "Mass of the ejecta"},
                                             {"ejecta_p90_m", "90 % of the ejecta within"},
                                             {"sieve_p50_m", "Sieve P50"},
                                             {"sieve_p80_m", "Sieve P80"},
                                             {"pile_mass_kg", "Rock in the pile"},
                                             {"joints_broken_fraction", "Joints broken"},
                                             {"explosive_energy_J", "Energy of the explosive"},
                                             {"gas_work_J", "Work of the gas"},
                                             {"joint_crushing_J", "Taken by crushed joint walls"}};
  return figures;
}

}  // namespace muckpile
