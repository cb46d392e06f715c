// SPDX-License-Identifier: GPL-2.0-or-later
// What formulas of fly rock ask of each hole of a bench.
// Scope: see the header.
#include "report/flyrock_holes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/charges.h"
#include "io/fired_charges.h"
#include "io/pattern_charges.h"
#include "measure/hole_rock.h"
#include "report/not_measurable.h"

namespace muckpile {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct ChargedDeck {
  const Deck* deck;
  double length;     // of its charge [m]
  double per_metre;  // [kg/m]
};

void require_mass(const std::string& hole, double mass) {
  if (mass > 0.0) return;
  throw NotMeasurable(
      "flyrock: needs the mass of every charge of hole '" + hole +
      "': neither dump/explosives.csv, the shipped explosives nor scene.json give its density");
}

std::vector<ChargedDeck> decks_of(const std::string& hole, const HoleTable& table,
                                  const std::vector<TimedCharge>& charges) {
  std::vector<ChargedDeck> decks;
  for (size_t k = 0; k < charges.size(); ++k) {
    const Deck& deck = table.decks()[k];
    if (deck.hole != hole) continue;
    require_mass(hole, charges[k].mass);
    const double length = deck.charge_length.value_or(deck.to - deck.from);
    decks.push_back({&deck, length, charges[k].mass / length});
  }
  return decks;
}

std::vector<FlyrockHole> holes_of_table(const ResultFolder& folder) {
  const HoleTable table = hole_table_of(folder);
  const std::vector<TimedCharge> charges = charges_of_decks(folder, table);
  const double burden = folder.scene_number("burden_m");
  std::vector<double> masses;
  for (const TimedCharge& charge : charges) masses.push_back(charge.mass);
  std::vector<FlyrockHole> holes;
  for (const PatternHole& hole : pattern_holes(table, masses, burden)) {
    const std::vector<ChargedDeck> decks = decks_of(hole.name, table, charges);
    const ChargedDeck top =
        *std::ranges::min_element(decks, {}, [](const ChargedDeck& d) { return d.deck->from; });
    const double heaviest = std::ranges::max(decks, {}, &ChargedDeck::per_metre).per_metre;
    // An air deck above a shorter charge holds nothing back.
    const double stemming = top.deck->from;
    holes.push_back({hole.name, hole.row, top.deck->diameter, hole.row == 0 ? burden : kNaN,
                     stemming, heaviest, top.per_metre, top.length});
  }
  return holes;
}

std::vector<FlyrockHole> holes_of_scene(const ResultFolder& folder) {
  const double length = folder.scene_number("charge_length_m");
  const double mass = fired_charges(folder).front().mass;
  require_mass("all", mass);
  const double per_metre = mass / length;
  return {{"all", 0, folder.scene_number("hole_diameter_m"), folder.scene_number("burden_m"),
           folder.scene_number("stemming_m"), per_metre, per_metre, length}};
}

}  // namespace

std::vector<FlyrockHole> flyrock_holes(const ResultFolder& folder) {
  if (folder.scene_word("case") != "bench")
    throw NotMeasurable("flyrock: the formulas are for a bench, got '" + folder.scene_word("case") +
                        "'");
  const bool table = std::filesystem::exists(folder.dump("holes.csv"));
  if (!table && !folder.scene_has("charge_mass_kg") && !folder.scene_has("explosive_density_kg_m3"))
    throw NotMeasurable("flyrock: needs charge_mass_kg in " + folder.dump("scene.json").string() +
                        ", by write_scene");
  return table ? holes_of_table(folder) : holes_of_scene(folder);
}

}  // namespace muckpile
