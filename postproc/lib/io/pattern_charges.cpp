// SPDX-License-Identifier: GPL-2.0-or-later
// The explosive in the decks of a run's hole table.
// Scope: see the header.
#include "io/pattern_charges.h"

#include <cmath>

#include "args/input_error.h"
#include "explosive/explosive_table.h"

namespace muckpile {

double density_of(const std::string& explosive, const ExplosiveTable& table) {
  try {
    return table.find(explosive, "").density;
  } catch (const InputError&) {
    return std::nan("");
  }
}

std::vector<TimedCharge> charges_of_decks(const ResultFolder& folder, const HoleTable& table) {
  constexpr const char* kDensity = "explosive_density_kg_m3";
  const double usual = folder.scene_has(kDensity) ? folder.scene_number(kDensity) : std::nan("");
  const std::filesystem::path own = folder.dump("explosives.csv");
  const ExplosiveTable explosives =
      ExplosiveTable::with_file(std::filesystem::exists(own) ? own.string() : "none");
  std::vector<TimedCharge> charges;
  for (const Deck& deck : table.decks()) {
    const double named = deck.explosive ? density_of(*deck.explosive, explosives) : usual;
    charges.push_back(
        {deck.firing_time, charge_mass(deck, deck.explosive_density.value_or(named))});
  }
  return charges;
}

}  // namespace muckpile
