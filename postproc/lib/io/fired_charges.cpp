// SPDX-License-Identifier: GPL-2.0-or-later
// The charges of a run with their masses and when they fire.
// Scope: see the header.
#include "io/fired_charges.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "io/charges.h"
#include "io/pattern_charges.h"

namespace muckpile {
namespace {

std::vector<FiredCharge> charges_of_table(const ResultFolder& folder) {
  std::vector<FiredCharge> charges;
  const HoleTable table = hole_table_of(folder);
  const std::vector<TimedCharge> timed = charges_of_decks(folder, table);
  for (size_t k = 0; k < timed.size(); ++k) {
    const Deck& deck = table.decks()[k];
    charges.push_back({deck.toe, deck.collar, timed[k].mass, timed[k].time});
  }
  return charges;
}

double mass_by_scene(const ResultFolder& folder) {
  if (folder.scene_has("charge_mass_kg")) return folder.scene_number("charge_mass_kg");
  const double diameter = folder.scene_number("hole_diameter_m");
  return 0.25 * std::numbers::pi * diameter * diameter * folder.scene_number("charge_length_m") *
         folder.scene_number("explosive_density_kg_m3");
}

}  // namespace

std::vector<FiredCharge> fired_charges(const ResultFolder& folder) {
  if (std::filesystem::exists(folder.dump("holes.csv"))) return charges_of_table(folder);
  const double mass = mass_by_scene(folder);
  std::vector<FiredCharge> charges;
  for (const Charge& charge : charges_of(folder))
    charges.push_back({charge.toe, charge.collar, mass, 0.0});
  return charges;
}

double largest_mass_within(const std::vector<FiredCharge>& charges, double window) {
  std::vector<TimedCharge> timed;
  for (const FiredCharge& charge : charges) timed.push_back({charge.firing_time, charge.mass});
  return largest_within(timed, window);
}

double distance_to_charges(const Vec3& point, const std::vector<FiredCharge>& charges) {
  double nearest = std::numeric_limits<double>::max();
  for (const FiredCharge& charge : charges) {
    const Vec3 axis = charge.collar - charge.toe;
    const double length_squared = axis.squaredNorm();
    const double along = length_squared > 0.0
                             ? std::clamp((point - charge.toe).dot(axis) / length_squared, 0.0, 1.0)
                             : 0.0;
    nearest = std::min(nearest, (point - charge.toe - along * axis).norm());
  }
  return nearest;
}

}  // namespace muckpile
