// SPDX-License-Identifier: GPL-2.0-or-later
// The explosive in the decks of a run's hole table.
// Scope: densities of the hole table, of scene.json and of explosives.csv beside it, else of the
// shipped explosives.
#pragma once

#include <string>
#include <vector>

#include "explosive/charge_window.h"
#include "explosive/explosive_table.h"
#include "io/result_folder.h"

namespace muckpile {

// [kg/m3]; NaN where the table has no such explosive.
double density_of(const std::string& explosive, const ExplosiveTable& table);

// Of each deck, in the table's order: when it fires and how much it holds. NaN [kg] where the deck
// names an explosive that no table has, or scene.json has no density.
std::vector<TimedCharge> charges_of_decks(const ResultFolder& folder, const HoleTable& table);

}  // namespace muckpile
