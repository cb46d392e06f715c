// SPDX-License-Identifier: GPL-2.0-or-later
// Reading of the explosive table; see the header.
#include "explosive/explosive_table.h"

#include <algorithm>
#include <array>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "explosive/shipped_explosives.h"  // made of explosives.csv at configuration

namespace muckpile {
namespace {

const std::vector<std::string> kJwlColumns = {"jwl_a_Pa",
                                              "jwl_b_Pa",
                                              "jwl_r1",
                                              "jwl_r2",
                                              "jwl_omega",
                                              "jwl_energy_J_m3",
                                              "jwl_cj_pressure_Pa",
                                              "jwl_density_kg_m3",
                                              "jwl_vod_m_s"};

std::vector<std::string> known_columns() {
  std::vector<std::string> known = {"name",  "density_kg_m3",    "vod_m_s", "energy_J_kg",
                                    "gamma", "gas_volume_m3_kg", "source"};
  known.insert(known.end(), kJwlColumns.begin(), kJwlColumns.end());
  return known;
}

/// A field that may be empty or whose column may be missing.
std::optional<double> in_range_or_empty(const CsvTable& csv, size_t row, const std::string& name,
                                        Range range = Range::positive()) {
  const auto column = csv.find_column(name);
  if (!column || csv.word(row, *column).empty()) return std::nullopt;
  return csv.real(row, *column, "", range);
}

double in_range(const CsvTable& csv, size_t row, const std::string& name, Range range) {
  (void)csv.column(name);
  if (const auto value = in_range_or_empty(csv, row, name, range)) return *value;
  throw InputError(csv.where(row) + name + " must be " + range.text() + ", got ''");
}

std::optional<JwlParameters> jwl(const CsvTable& csv, size_t row) {
  JwlParameters p;
  const std::array<double*, 9> places = {&p.a,           &p.b,       &p.r1,
                                         &p.r2,          &p.omega,   &p.energy,
                                         &p.cj_pressure, &p.density, &p.detonation_velocity};
  std::size_t given = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (const auto value = in_range_or_empty(csv, row, kJwlColumns[k])) {
      *places[k] = *value;
      ++given;
    }
  }
  if (given == 0) return std::nullopt;
  if (given < places.size()) {
    throw InputError(csv.where(row) + "needs all of " + joined(kJwlColumns) + " or none");
  }
  try {
    (void)JwlIsentrope(p);
  } catch (const InputError& error) {
    throw InputError(csv.where(row) + error.what());
  }
  return p;
}

NamedExplosive entry(const CsvTable& csv, size_t row) {
  NamedExplosive read;
  read.name = std::string(csv.word(row, csv.column("name")));
  if (read.name.empty()) throw InputError(csv.where(row) + "name is empty");
  read.density = in_range(csv, row, "density_kg_m3", Range::closed(10.0, 1e4));
  read.detonation_velocity = in_range(csv, row, "vod_m_s", Range::closed(100.0, 1e5));
  read.energy = in_range(csv, row, "energy_J_kg", Range::closed(1e4, 1e9));
  read.gamma = in_range_or_empty(csv, row, "gamma", Range::left_open(1.0, 10.0));
  if (const auto volume = in_range_or_empty(csv, row, "gas_volume_m3_kg", kGasVolumes)) {
    read.gas_volume = *volume;
  }
  read.jwl = jwl(csv, row);
  if (const auto source = csv.find_column("source")) read.source = csv.word(row, *source);
  return read;
}

}  // namespace

double gas_constant(const NamedExplosive& explosive) {
  constexpr double kPressure = 101325.0, kTemperature = 273.15;  // [Pa], [K]
  return explosive.gas_volume * kPressure / kTemperature;
}

ExplosiveTable::ExplosiveTable(const CsvTable& csv) {
  csv.require_known_columns(known_columns());
  for (size_t row = 0; row < csv.rows(); ++row) {
    NamedExplosive read = entry(csv, row);
    for (const NamedExplosive& before : entries_) {
      if (before.name == read.name) {
        throw InputError(csv.where(row) + "explosive '" + read.name + "' is given twice");
      }
    }
    entries_.push_back(std::move(read));
  }
}

const ExplosiveTable& ExplosiveTable::shipped() {
  static const ExplosiveTable table(CsvTable::parse(kShippedExplosives, "explosives.csv"));
  return table;
}

ExplosiveTable ExplosiveTable::with_file(const std::string& path) {
  if (path == "none") return shipped();
  ExplosiveTable table(CsvTable::read(path));
  const auto& more = shipped().entries();
  table.entries_.insert(table.entries_.end(), more.begin(), more.end());  // find() takes the first
  return table;
}

const NamedExplosive& ExplosiveTable::find(const std::string& name,
                                           const std::string& where) const {
  std::vector<std::string> names;
  for (const NamedExplosive& candidate : entries_) {
    if (candidate.name == name) return candidate;
    names.push_back(candidate.name);
  }
  throw InputError(where + ": unknown explosive '" + name + "'" + did_you_mean(name, names) +
                   " (known: " + joined(names) + ")");
}

}  // namespace muckpile
