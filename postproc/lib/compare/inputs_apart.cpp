// SPDX-License-Identifier: GPL-2.0-or-later
// In what the inputs of two runs differ.
// Scope: see the header.
#include "compare/inputs_apart.h"

#include <array>
#include <set>

#include "figures/figures.h"

namespace muckpile {
namespace {

constexpr std::array kNoInputs{"out", "go_on", "from", "pour_from", "restart_every"};

check::Json knobs_of(const std::filesystem::path& folder) {
  const std::filesystem::path scene = folder / "dump" / "scene.json";
  if (!std::filesystem::exists(scene)) return {};
  const check::Json all = check::read_json_object(scene);
  const auto knobs = all.find("knobs");
  return knobs != all.end() && knobs->is_object() ? *knobs : check::Json();
}

std::string text_of(const check::Json& knobs, const std::string& name) {
  const auto knob = knobs.find(name);
  if (knob == knobs.end()) return "none";
  if (knob->is_string()) return knob->get<std::string>();
  return knob->is_number() ? check::text_of(knob->get<double>()) : knob->dump();
}

}  // namespace

std::vector<std::string> inputs_apart(const std::filesystem::path& a,
                                      const std::filesystem::path& b) {
  const check::Json of_a = knobs_of(a), of_b = knobs_of(b);
  if (of_a.is_null() || of_b.is_null()) return {};
  std::set<std::string> names;
  for (const check::Json* knobs : {&of_a, &of_b})
    for (const auto& [name, value] : knobs->items()) names.insert(name);
  for (const char* name : kNoInputs) names.erase(name);
  std::vector<std::string> apart;
  for (const std::string& name : names) {
    const std::string one = text_of(of_a, name), other = text_of(of_b, name);
    if (one != other) apart.push_back(name + " " + one + ", " + other);
  }
  return apart;
}

}  // namespace muckpile
