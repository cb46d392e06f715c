// SPDX-License-Identifier: GPL-2.0-or-later
// Crushed zones of the decks of a pattern; see the header.
#include "explosive/design_zones.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "args/input_error.h"
#include "args/numbers.h"
#include "explosive/deck_charge.h"

namespace muckpile {
namespace {

constexpr const char* kColumn = "crushed_radius_m";

/// With the hole and the pressure of a charge that fills the deck's chamber.
CrushedZoneInput full_deck(const ChargeOptions& options, const Deck& deck, CrushedZoneInput rock) {
  rock.hole_radius = 0.5 * deck.diameter;
  rock.borehole_pressure =
      initial_pressure(deck_options(options, deck), deck_explosive(options, deck));
  return rock;
}

double deck_share(const ChargeOptions& options, const Deck& deck, double attenuation_exponent) {
  return pressure_share(deck_options(options, deck), deck_explosive(options, deck),
                        deck_shape(options, deck, (deck.collar - deck.toe).norm()),
                        attenuation_exponent);
}

void add_deck(PatternZones& zones, const ChargeOptions& options, const Deck& deck,
              CrushedZone model, const CrushedZoneInput& rock, bool by_pressure) {
  // What the load would refuse of a deck's explosive, before rock is cut for it.
  if (options.expansion == Expansion::jwl)
    (void)product_expansion(deck_options(options, deck), deck_explosive(options, deck));
  double full = 0.0, radius = 0.0;
  if (deck.crushed_radius) {
    full = radius = *deck.crushed_radius;
    ++zones.from_table;
  } else {
    CrushedZoneInput in = full_deck(options, deck, rock);
    full = radius = crushed_zone_radius(model, in);
    if (by_pressure) {
      in.pressure_share = deck_share(options, deck, rock.attenuation_exponent);
      radius = crushed_zone_radius(model, in);
    }
  }
  zones.radii.push_back(radius);
  zones.smallest = std::min(zones.smallest, radius);
  zones.smallest_full = std::min(zones.smallest_full, full);
  if (radius < full) ++zones.narrower;
}

void write_row(std::ostream& text, const std::vector<std::string_view>& words) {
  for (std::size_t k = 0; k < words.size(); ++k) text << (k > 0 ? "," : "") << words[k];
  text << '\n';
}

}  // namespace

double pressure_share(const ChargeOptions& options, const NamedExplosive& explosive,
                      const ChargeShape& shape, double attenuation_exponent) {
  check_shape(shape);
  const DecouplingRule rule = decoupling_rule(options, attenuation_exponent);
  const bool fills = shape.charge_radius == shape.hole_radius;
  if (fills && free_volume_ratio(shape, rule) <= 1.0) return 1.0;
  const double full = initial_pressure(options, explosive);
  return wall_pressure(full, product_expansion(options, explosive), shape, rule) / full;
}

PatternZones pattern_zones(const HoleTable& pattern, const ChargeOptions& options,
                           CrushedZone model, CrushedZoneInput rock, bool by_pressure) {
  PatternZones zones;
  zones.smallest = zones.smallest_full = std::numeric_limits<double>::infinity();
  for (const Deck& deck : pattern.decks()) {
    try {
      add_deck(zones, options, deck, model, rock, by_pressure);
    } catch (const InputError& error) {
      throw InputError("hole '" + deck.hole + "' of hole_table: " + error.what());
    }
  }
  return zones;
}

std::string with_zones(const CsvTable& table, const PatternZones& zones) {
  std::ostringstream text;
  for (const std::string_view remark : table.remarks()) text << '#' << remark << '\n';
  const auto column = table.find_column(kColumn);
  const std::size_t place = column.value_or(table.header().size());
  std::vector<std::string_view> words = table.header();
  if (!column) words.emplace_back(kColumn);
  write_row(text, words);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t k = 0; k < table.header().size(); ++k) words[k] = table.word(row, k);
    const std::string radius = number_text(zones.radii[row]);
    words[place] = radius;
    write_row(text, words);
  }
  return text.str();
}

}  // namespace muckpile
