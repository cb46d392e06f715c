// SPDX-License-Identifier: GPL-2.0-or-later
// The texts of a look at a run; see the header.
#include "fixes/run/run_look.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fixes/engine/json_text.h"
#include "fixes/interfaces/known_blocks.h"

namespace muckpile {
namespace {

/// Terms of an audit by name [J].
nlohmann::ordered_json terms_of(const EnergyAudit& audit) {
  nlohmann::ordered_json terms;
  for (const EnergyAudit::Term& term : EnergyAudit::kTerms)
    terms[std::string(term.name)] = audit.*term.value;
  return terms;
}

double share(double error, double explosive) { return explosive > 0.0 ? error / explosive : 0.0; }

/// What one hole's charge has done; its gas in joints is that of all holes.
void add_audit(nlohmann::ordered_json& zone, const HoleAudit& hole) {
  zone["energy_audit_J"] = terms_of(hole.energy);
  for (const char* of_all : {"joint_work", "rock_heat", "in_joints"})
    zone["energy_audit_J"].erase(of_all);
  zone["energy_audit_J"]["into_joints"] = hole.into_joints;
  zone["energy_audit_error"] = share(hole.error(), hole.energy.explosive);
  if (hole.stemming_out >= 0.0) zone["stemming_out_s"] = hole.stemming_out;
  zone["stemming_speed_m_s"] = hole.stemming_speed;
}

/// The cylinders of rock that the charges crush, one per hole, and where their energy is.
nlohmann::ordered_json crushed_zones(const KnownBlocks& blocks,
                                     const std::vector<HoleAudit>& audits) {
  const auto three = [](const Vec3& p) {
    return nlohmann::ordered_json::array({p.x(), p.y(), p.z()});
  };
  auto zones = nlohmann::ordered_json::array();
  for (const Hole& hole : blocks.holes()) {
    zones.push_back(
        {{"toe_m", three(hole.toe)}, {"collar_m", three(hole.collar)}, {"radius_m", hole.radius}});
    if (zones.size() <= audits.size()) add_audit(zones.back(), audits[zones.size() - 1]);
  }
  return zones;
}

/// " | " and a number in a text, where there is something to tell.
std::string remark(bool told, const char* format, double number) {
  if (!told) return {};
  char text[64];
  std::snprintf(text, sizeof text, format, number);
  return std::string(" | ") + text;
}

}  // namespace

std::string progress_line(const RunLook& look, std::string_view phase, double seconds_left) {
  char text[256];
  std::snprintf(text, sizeof text,
                "] t = %.4g s | step %lld of %.2g s | joints broken %.1f %% | fastest %.3g m/s "
                "| moving %.1f %%",
                look.time, static_cast<long long>(look.step), look.timestep,
                100.0 * look.broken_share(), look.fastest, 100.0 * look.moving_share);
  std::string line = "[";
  return line.append(phase).append(text) +
         remark(look.gone > 0.0, "%.0f blocks left the scene", look.gone) +
         remark(look.in_solid > 0.0, "%.0f blocks in the solid", look.in_solid) +
         remark(seconds_left >= 0.0, "at most %.0f s left", seconds_left) + "\n";
}

std::string history_row(const RunLook& look, std::string_view phase, const EnergyLedger& e,
                        std::string_view run_id) {
  std::ostringstream out;
  out.precision(10);
  out << look.step << ',' << look.time << ',' << look.timestep << ',' << phase << ',' << look.joints
      << ',' << look.broken << ',' << look.fastest;
  for (double energy : {e.kinetic, e.joint_elastic, e.contact_elastic, e.gravity, e.blast_work,
                        e.fracture, e.joint_friction, e.joint_damping, e.contact_friction,
                        e.contact_damping, e.walls, e.quiet, e.sleep, e.given, look.balance}) {
    out << ',' << energy;
  }
  out << ',' << run_id << '\n';
  return out.str();
}

std::string run_json(const RunLook& look, const RunFacts& facts, const KnownBlocks& blocks) {
  nlohmann::ordered_json run;
  run["blocks"] = blocks.blocks_created();
  run["spheres"] = facts.spheres;
  run["joints"] = blocks.facets_created();
  run["joints_broken_fraction"] = look.broken_share();
  run["steps"] = look.step;
  run["physical_time_s"] = look.time;
  run["wall_time_s"] = facts.wall_time;
  run["ranks"] = facts.ranks;
  run["energy_balance_error"] = look.balance;
  run["explosive_energy_J"] = facts.energies.explosive;
  run["wave_work_J"] = facts.energies.wave;
  run["gas_work_J"] = facts.energies.gas;
  run["joint_crushing_J"] = facts.crushing;
  run["energy_audit_J"] = terms_of(facts.audit);
  run["energy_audit_error"] = share(facts.audit.error(), facts.audit.explosive);
  run["blocks_left_scene"] = std::lround(look.gone);
  run["mass_left_scene_kg"] = look.gone_mass;
  run["blocks_in_solid"] = std::lround(look.in_solid);
  run["version"] = MUCKPILE_VERSION;
  run["still"] = facts.still;
  run["run_id"] = blocks.run_id();
  run["holes"] = crushed_zones(blocks, facts.holes);
  return engine::json_text(run);
}

}  // namespace muckpile
