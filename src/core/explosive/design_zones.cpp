// SPDX-License-Identifier: GPL-2.0-or-later
// Crushed zones of decoupled charges; see the header.
#include "explosive/design_zones.h"

#include <algorithm>
#include <sstream>

#include "args/input_error.h"
#include "args/numbers.h"
#include "explosive/deck_charge.h"

namespace muckpile {
namespace {

constexpr const char* kColumn = "crushed_radius_m";

/// Nothing where the deck has the zone of a full chamber, or the table says.
std::optional<double> own_radius(const ChargeOptions& options, const Deck& deck,
                                 CrushedZoneInput rock) {
  if (deck.crushed_radius) return std::nullopt;
  const ChargeShape shape = deck_shape(options, deck, (deck.collar - deck.toe).norm());
  rock.hole_radius = shape.hole_radius;
  rock.pressure_share = pressure_share(deck_options(options, deck), deck_explosive(options, deck),
                                       shape, rock.attenuation_exponent);
  if (rock.pressure_share == 1.0) return std::nullopt;
  return crushed_zone_radius(CrushedZone::multiple, rock);
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
                           CrushedZoneInput rock, bool by_pressure) {
  PatternZones zones;
  const std::vector<Hole> full = pattern.crushed_zones(rock.multiple);
  zones.smallest = zones.smallest_full = full.front().radius;  // a table has at least one deck
  for (std::size_t k = 0; k < full.size(); ++k) {
    const Deck& deck = pattern.decks()[k];
    try {
      // What the load would refuse of a deck's explosive, before rock is cut for it.
      if (options.expansion == Expansion::jwl)
        (void)product_expansion(deck_options(options, deck), deck_explosive(options, deck));
      zones.own.push_back(by_pressure ? own_radius(options, deck, rock) : std::nullopt);
    } catch (const InputError& error) {
      throw InputError("hole '" + deck.hole + "' of hole_table: " + error.what());
    }
    zones.smallest_full = std::min(zones.smallest_full, full[k].radius);
    zones.smallest = std::min(zones.smallest, zones.own.back().value_or(full[k].radius));
  }
  return zones;
}

std::string with_zones(const CsvTable& table, const PatternZones& zones) {
  const auto known = [](const std::optional<double>& own) { return own.has_value(); };
  if (std::none_of(zones.own.begin(), zones.own.end(), known)) return table.text();
  std::ostringstream text;
  for (const std::string_view remark : table.remarks()) text << '#' << remark << '\n';
  const auto column = table.find_column(kColumn);
  const std::size_t place = column.value_or(table.header().size());
  std::vector<std::string_view> words = table.header();
  if (!column) words.emplace_back(kColumn);
  write_row(text, words);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t k = 0; k < table.header().size(); ++k) words[k] = table.word(row, k);
    const std::string own = zones.own[row] ? number_text(*zones.own[row]) : std::string();
    if (zones.own[row] || !column) words[place] = own;
    write_row(text, words);
  }
  return text.str();
}

}  // namespace muckpile
