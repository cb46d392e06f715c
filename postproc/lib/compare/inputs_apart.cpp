// SPDX-License-Identifier: GPL-2.0-or-later
// In what the inputs of two runs differ.
// Scope: see the header.
#include "compare/inputs_apart.h"

#include <algorithm>
#include <optional>
#include <set>

#include "figures/figures.h"
#include "provenance/knobs.h"

namespace muckpile {
namespace {

std::string text_of(const check::Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number() ? check::text_of(value.get<double>()) : value.dump();
}

/// Nothing where the folder has no scene.
std::optional<Knobs> knobs_of(const std::filesystem::path& folder) {
  const std::filesystem::path scene = folder / "dump" / "scene.json";
  if (!std::filesystem::exists(scene)) return {};
  const check::Json all = check::read_json_object(scene);
  const auto found = all.find("knobs");
  if (found == all.end() || !found->is_object()) return {};
  Knobs knobs;
  for (const auto& [name, value] : found->items()) knobs.push_back({name, text_of(value)});
  return knobs;
}

std::string value_in(const Knobs& knobs, const std::string& name) {
  const auto knob = std::ranges::find(knobs, name, &Knob::name);
  return knob == knobs.end() ? "none" : knob->value.value_or("none");
}

}  // namespace

std::vector<std::string> inputs_apart(const std::filesystem::path& a,
                                      const std::filesystem::path& b,
                                      const std::vector<std::string>& free) {
  const std::optional<Knobs> of_a = knobs_of(a), of_b = knobs_of(b);
  if (!of_a || !of_b) return {};
  std::vector<std::string> all_free{"out", "go_on", "from", "pour_from", "restart_every"};
  all_free.insert(all_free.end(), free.begin(), free.end());
  const KnobChanges changes = knob_changes(*of_a, *of_b, all_free);
  std::set<std::string> names(changes.missing.begin(), changes.missing.end());
  names.insert(changes.added.begin(), changes.added.end());
  for (const KnobChange& change : changes.other) names.insert(change.name);
  std::vector<std::string> apart;
  for (const std::string& name : names)
    apart.push_back(name + " " + value_in(*of_a, name) + ", " + value_in(*of_b, name));
  return apart;
}

}  // namespace muckpile
