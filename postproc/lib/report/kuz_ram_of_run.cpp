// SPDX-License-Identifier: GPL-2.0-or-later
// Kuz-Ram for the blast of a run.
// Scope: see the header.
#include "report/kuz_ram_of_run.h"

#include <numbers>

#include "args/input_error.h"
#include "draw/axes.h"
#include "explosive/explosive_table.h"

namespace muckpile {
namespace {

// A number of the scene, or of its knobs. Nothing where it is not there.
std::optional<double> find_number(const nlohmann::ordered_json& scene, const std::string& key,
                                  const std::string& knob) {
  const auto found = scene.find(key);
  if (found != scene.end() && found->is_number()) return found->get<double>();
  const auto knobs = scene.find("knobs");
  if (knobs == scene.end() || !knobs->is_object()) return std::nullopt;
  const auto value = knobs->find(knob);
  if (value == knobs->end() || !value->is_number()) return std::nullopt;
  return value->get<double>();
}

// The numbers of a scene; those that it does not have are remembered.
class SceneNumbers {
 public:
  explicit SceneNumbers(const ResultFolder& folder)
      : scene_(read_json_object(folder.dump("scene.json"))) {}
  double get(const std::string& key, const std::string& knob = "") {
    const auto number = find_number(scene_, key, knob);
    if (!number) missing_ += (missing_.empty() ? "" : ", ") + key;
    return number.value_or(0.0);
  }
  [[nodiscard]] bool has(const std::string& key) const {
    return find_number(scene_, key, "").has_value();
  }
  [[nodiscard]] const std::string& missing() const { return missing_; }

 private:
  nlohmann::ordered_json scene_;
  std::string missing_;
};

double charge_mass(SceneNumbers& scene) {
  if (scene.has("charge_mass_kg")) return scene.get("charge_mass_kg");
  const double diameter = scene.get("hole_diameter_m");
  return 0.25 * std::numbers::pi * diameter * diameter * scene.get("charge_length_m") *
         scene.get("explosive_density_kg_m3");
}

double weight_strength(SceneNumbers& scene, const ResultFolder& folder,
                       const FragmentOptions& options) {
  if (options.weight_strength) return *options.weight_strength;
  const ExplosiveTable& table = ExplosiveTable::shipped();
  const double anfo = table.find("anfo", "Kuz-Ram").energy;
  if (scene.has("explosive_energy_J_kg")) return 100.0 * scene.get("explosive_energy_J_kg") / anfo;
  const std::string name = folder.scene_word("explosive");
  for (const NamedExplosive& explosive : table.entries()) {
    if (explosive.name == name) return 100.0 * explosive.energy / anfo;
  }
  return 100.0 * scene.get("explosive_energy_J_kg") / anfo;
}

double rock_factor(SceneNumbers& scene, const FragmentOptions& options) {
  if (options.rock_factor) return *options.rock_factor;
  return lilly_rock_factor(options.mass_rating, scene.get("rock_density_kg_m3", "rock_density"),
                           scene.get("youngs_modulus_Pa", "youngs_modulus"),
                           scene.get("ucs_Pa", "ucs"));
}

KuzRamBlast blast_of(SceneNumbers& scene, const ResultFolder& folder,
                     const FragmentOptions& options) {
  KuzRamBlast blast{};
  blast.burden = scene.get("burden_m");
  blast.spacing = scene.get("spacing_m");
  blast.bench_height = scene.get("bench_height_m");
  blast.hole_diameter = scene.get("hole_diameter_m");
  blast.charge_above_floor = scene.get("charge_length_m") - scene.get("subdrill_m");
  blast.charge_mass = charge_mass(scene);
  blast.weight_strength = weight_strength(scene, folder, options);
  blast.rock_factor = rock_factor(scene, options);
  blast.drilling_deviation = options.drilling_deviation;
  return blast;
}

std::string source_of_rock_factor(const FragmentOptions& options) {
  return options.rock_factor
             ? "as given"
             : "Lilly's index with a mass rating of " + spelled(options.mass_rating);
}

}  // namespace

KuzRamOfRun kuz_ram_of(const ResultFolder& folder, const FragmentOptions& options) {
  if (folder.scene_word("case") != "bench") return {{}, "Kuz-Ram is a formula for benches"};
  SceneNumbers scene(folder);
  const KuzRamBlast blast = blast_of(scene, folder, options);
  if (!scene.missing().empty())
    return {{},
            "no Kuz-Ram: " + folder.dump("scene.json").filename().string() + " has no " +
                scene.missing()};
  try {
    return {kuz_ram(blast),
            "formula, no result of the simulation: Kuznetsov and Cunningham 1987, "
            "rock factor " +
                spelled(blast.rock_factor) + " (" + source_of_rock_factor(options) +
                "), weight strength " + spelled(blast.weight_strength) + " (ANFO 100)"};
  } catch (const InputError& error) {
    return {{}, error.what()};
  }
}

}  // namespace muckpile
