// SPDX-License-Identifier: GPL-2.0-or-later
// Where the charges of a run were.
// Scope: see the header.
#include "io/charges.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "args/input_error.h"

namespace muckpile {
namespace {

Vec3 point_of(const nlohmann::ordered_json& hole, const char* key) {
  const auto numbers = hole.at(key).get<std::vector<double>>();
  return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

std::vector<Charge> charges_of_table(const std::filesystem::path& path) {
  std::vector<Charge> charges;
  const HoleTable table = HoleTable::read(path.string());
  for (const Deck& deck : table.decks())
    charges.push_back({deck.toe, deck.collar, deck.crushed_radius.value_or(0.5 * deck.diameter),
                       0.5 * deck.diameter});
  if (charges.empty()) throw InputError(path.string() + ": holds no rows");
  return charges;
}

// One row at x = -burden, about y = 0.
std::vector<Charge> charges_of_scene(const ResultFolder& folder) {
  const long holes = folder.scene_has("holes") ? std::lround(folder.scene_number("holes")) : 1;
  const double spacing = holes > 1 ? folder.scene_number("spacing_m") : 0.0;
  const double top = folder.scene_number("bench_height_m") - folder.scene_number("stemming_m");
  const double bottom = top - folder.scene_number("charge_length_m");
  const double radius = folder.scene_has("crushed_radius_m")
                            ? folder.scene_number("crushed_radius_m")
                            : 0.5 * folder.scene_number("hole_diameter_m");
  if (holes < 1)
    throw InputError(folder.dump("scene.json").string() + ": holes must be >= 1, got '" +
                     std::to_string(holes) + "'");
  std::vector<Charge> charges;
  for (long k = 0; k < holes; ++k) {
    const double x = -folder.scene_number("burden_m");
    const double y = (static_cast<double>(k) - 0.5 * static_cast<double>(holes - 1)) * spacing;
    charges.push_back({{x, y, bottom}, {x, y, top}, radius});
  }
  return charges;
}

// Of the drilled one that begins at the same place.
void add_hole_radii(std::vector<Charge>& charges, const std::vector<Charge>& drilled) {
  for (Charge& charge : charges) {
    const double near = 0.01 * (charge.collar - charge.toe).norm();
    const auto own = std::ranges::find_if(
        drilled, [&](const Charge& other) { return (other.toe - charge.toe).norm() <= near; });
    if (own != drilled.end()) charge.hole_radius = own->hole_radius;
  }
}

void require_same_charges(const ResultFolder& folder, const HoleTable& table) {
  const std::vector<Charge> charges = charges_of_run(folder);
  if (charges.empty()) return;
  for (const Deck& deck : table.decks()) {
    const double near = 0.01 * (deck.collar - deck.toe).norm();
    const bool found = std::ranges::any_of(charges, [&](const Charge& charge) {
      return (charge.toe - deck.toe).norm() <= near && (charge.collar - deck.collar).norm() <= near;
    });
    if (found) continue;
    throw InputError(folder.dump("holes.csv").string() + ": hole '" + deck.hole +
                     "' is not where " + folder.dump("run.json").string() +
                     " has a charge; give the folder the table that the run has read");
  }
  if (charges.size() > table.decks().size())
    throw InputError(folder.dump("holes.csv").string() + ": has " +
                     std::to_string(table.decks().size()) + " charges, " +
                     folder.dump("run.json").string() + " " + std::to_string(charges.size()) +
                     "; give the folder the table that the run has read");
}

}  // namespace

HoleTable hole_table_of(const ResultFolder& folder) {
  HoleTable table = HoleTable::read(folder.dump("holes.csv").string());
  require_same_charges(folder, table);
  return table;
}

std::vector<Charge> charges_of_run(const ResultFolder& folder) {
  const std::filesystem::path path = folder.dump("run.json");
  if (!std::filesystem::exists(path)) return {};
  const nlohmann::ordered_json run = read_json_object(path);
  std::vector<Charge> charges;
  if (!run.contains("holes")) return charges;
  try {
    for (const auto& hole : run["holes"]) {
      charges.push_back(
          {point_of(hole, "toe_m"), point_of(hole, "collar_m"), hole.at("radius_m").get<double>()});
    }
  } catch (const std::exception& error) {  // of the JSON library, or too few numbers of a point
    throw InputError(
        path.string() +
        ": holes must be a list of toe_m [x, y, z], collar_m [x, y, z], radius_m: " + error.what());
  }
  return charges;
}

std::vector<Charge> charges_of(const ResultFolder& folder) {
  std::vector<Charge> charges = charges_of_run(folder);
  const std::filesystem::path table = folder.dump("holes.csv");
  if (!charges.empty()) {
    if (std::filesystem::exists(table)) add_hole_radii(charges, charges_of_table(table));
    return charges;
  }
  return std::filesystem::exists(table) ? charges_of_table(table) : charges_of_scene(folder);
}

}  // namespace muckpile
