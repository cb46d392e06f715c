// SPDX-License-Identifier: GPL-2.0-or-later
// Crushed zones of charges that may be thinner or shorter than their chambers.
// Scope: one radius per chamber, by the pressure of the products that fill it, as the load has one.
#pragma once

#include <string>
#include <vector>

#include "args/csv_table.h"
#include "explosive/charge_options.h"
#include "explosive/crushed_zone.h"
#include "explosive/hole_table.h"

namespace muckpile {

/// Peak on the wall over that of a charge that fills its chamber [-]: 1 for one that does.
/// InputError as check_shape() and, for a decoupled charge, product_expansion().
[[nodiscard]] double pressure_share(const ChargeOptions& options, const NamedExplosive& explosive,
                                    const ChargeShape& shape, double attenuation_exponent);

/// Crushed zones of a pattern's decks.
struct PatternZones {
  std::vector<double> radii{};  ///< r1 of each deck [m]
  double smallest = 0.0;        ///< of them [m]
  double smallest_full = 0.0;   ///< the same, if all charges filled their chambers [m]
  long narrower = 0;            ///< decks whose zones are narrower than if they did
  long from_table = 0;          ///< decks that have the radius of the table
};

/// By `strength` or `multiple`, with the numbers of `rock`; a radius of the table stays. With
/// `by_pressure` off all are those of full chambers. InputError names the row's hole.
[[nodiscard]] PatternZones pattern_zones(const HoleTable& pattern, const ChargeOptions& options,
                                         CrushedZone model, CrushedZoneInput rock,
                                         bool by_pressure);

/// The table with the zones in its column crushed_radius_m.
[[nodiscard]] std::string with_zones(const CsvTable& table, const PatternZones& zones);

}  // namespace muckpile
