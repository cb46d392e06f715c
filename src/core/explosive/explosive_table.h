// SPDX-License-Identifier: GPL-2.0-or-later
// Named explosives: the shipped table (explosives.csv, compiled in and installed) and the user's
// own in the same form. Scope: numbers and their sources; what is made of them is
// borehole_pressure.h and others.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "args/csv_table.h"
#include "args/range.h"
#include "explosive/jwl_isentrope.h"

namespace muckpile {

constexpr double kUsualGasVolume = 0.9;  ///< [m3/kg]
/// Around all that detonates, aluminised explosives (0.3) and hydrogen-rich ones (1.2) included.
inline const Range kGasVolumes = Range::closed(0.1, 2.0);  // [m3/kg]

struct NamedExplosive {
  std::string name;
  double density = 0.0;              ///< [kg/m3]
  double detonation_velocity = 0.0;  ///< [m/s]
  double energy = 0.0;               ///< per mass [J/kg]
  std::optional<double> gamma{};     ///< of the products at the Chapman-Jouguet point [-]
  /// Products per mass as a gas at 273.15 K and 101325 Pa, water as steam [m3/kg]. Not given: the
  /// middle of what industrial explosives have, 0.7 to 1.1 (explosives.csv).
  double gas_volume = kUsualGasVolume;
  double reacts = 1.0;  ///< share of its mass that turns into gas in time [-]
  std::optional<JwlParameters> jwl{};
  std::string source{};
};

/// Specific gas constant of the products, p v/T of gas_volume at its own temperature and pressure
/// [J/(kg K)].
[[nodiscard]] double gas_constant(const NamedExplosive& explosive);

class ExplosiveTable {
 public:
  /// InputError, with file and line, on a number out of range, a name twice, or a JWL set that is
  /// neither whole nor empty.
  explicit ExplosiveTable(const CsvTable& csv);

  /// What Muckpile ships.
  [[nodiscard]] static const ExplosiveTable& shipped();
  /// The shipped table, before it the entries of a user's file: those win. "none": no file.
  [[nodiscard]] static ExplosiveTable with_file(const std::string& path);

  /// InputError that lists the known names and the nearest; `where` starts it.
  [[nodiscard]] const NamedExplosive& find(const std::string& name, const std::string& where) const;
  [[nodiscard]] const std::vector<NamedExplosive>& entries() const { return entries_; }

 private:
  std::vector<NamedExplosive> entries_;
};

}  // namespace muckpile
