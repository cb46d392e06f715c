// SPDX-License-Identifier: GPL-2.0-or-later
// What a look at a run found, and how the console, history.csv and run.json tell it.
// Scope: numbers and texts; fix muckpile/progress looks, and writes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "explosive/energy_audit.h"
#include "fixes/interfaces/blast_energies.h"
#include "fixes/interfaces/energy_account.h"

namespace muckpile {

class KnownBlocks;

/// The same on all ranks.
struct RunLook {
  std::int64_t step = 0;
  double time = 0.0;          ///< [s]
  double timestep = 0.0;      ///< [s]
  double fastest = 0.0;       ///< [m/s]
  double moving_share = 0.0;  ///< mass share of blocks in the scene faster than still_speed [-]
  double gone = 0.0;          ///< blocks outside of the scene
  double gone_mass = 0.0;     ///< [kg]
  double in_solid = 0.0;      ///< blocks that came to where no rock can be
  double joints = 0.0, broken = 0.0;
  int bodies = 0;
  double balance = 0.0;  ///< energy balance error [-]

  [[nodiscard]] double broken_share() const { return joints > 0.0 ? broken / joints : 0.0; }
};

/// A line for the console, with its end; seconds_left < 0: not known.
[[nodiscard]] std::string progress_line(const RunLook& look, std::string_view phase,
                                        double seconds_left);

/// A line of history.csv, with its end, in the columns of RunFiles::kHeader.
[[nodiscard]] std::string history_row(const RunLook& look, std::string_view phase,
                                      const EnergyLedger& energies, std::string_view run_id);

/// What run.json says beside the look.
struct RunFacts {
  std::int64_t spheres = 0;
  double wall_time = 0.0;  ///< [s]
  int ranks = 1;
  bool still = false;
  BlastEnergies::Energies energies;
  EnergyAudit audit;
  double crushing = 0.0;           ///< taken by walls of joints that crush [J]
  std::vector<HoleAudit> holes{};  ///< none without charges
};
[[nodiscard]] std::string run_json(const RunLook& look, const RunFacts& facts,
                                   const KnownBlocks& blocks);

}  // namespace muckpile
