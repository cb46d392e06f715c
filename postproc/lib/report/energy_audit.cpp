// SPDX-License-Identifier: GPL-2.0-or-later
// Where the explosive's energy is at the end of a run.
// Scope: see the header.
#include "report/energy_audit.h"

#include <array>

namespace muckpile {

std::vector<AuditTerm> energy_audit(const ResultFolder& folder) {
  constexpr std::array<std::array<const char*, 2>, 11> kNames = {
      {{"wall_work", "work on the walls"},
       {"joint_work", "work in joints"},
       {"crushing", "crushing"},
       {"rock_heat", "heat in rock"},
       {"vented", "vented"},
       {"stemming", "stemming"},
       {"in_joints", "gas in joints"},
       {"in_holes", "gas in holes"},
       {"air_work", "atmosphere"},
       {"filling", "filling of gaps"},
       {"not_released", "not released"}}};
  const nlohmann::ordered_json run = read_json_object(folder.dump("run.json"));
  const auto audit = run.find("energy_audit_J");
  if (audit == run.end() || !audit->is_object()) return {};
  const auto energy = [&](const char* key) {
    const auto value = audit->find(key);
    return value != audit->end() && value->is_number() ? value->get<double>() : 0.0;
  };
  const double explosive = energy("explosive");
  if (!(explosive > 0.0)) return {};
  std::vector<AuditTerm> terms;
  for (const auto& [key, label] : kNames)
    terms.push_back({key, label, folder.symmetry() * energy(key), energy(key) / explosive});
  return terms;
}

AuditTerm missing_of(const std::vector<AuditTerm>& audit) {
  AuditTerm missing{"missing", "not accounted for", 0.0, 1.0};
  double whole = 0.0;  // [J]
  for (const AuditTerm& term : audit) {
    if (term.share != 0.0) whole = term.energy / term.share;
    missing.share -= term.share;
  }
  missing.energy = missing.share * whole;
  return missing;
}

}  // namespace muckpile
