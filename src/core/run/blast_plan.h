// SPDX-License-Identifier: GPL-2.0-or-later
// How a blast goes through its phases: the words of run_blast, and what they mean for a scene.
// Scope: no engine; a fault in the words, or between them and the scene, throws InputError.
#pragma once

#include <string>
#include <vector>

#include "args/parse_args.h"
#include "run/blast_scene.h"
#include "run/run_words.h"

namespace muckpile {

[[nodiscard]] ArgTable run_blast_table();

/// Times on the clock of the run, whose first charge fires at 0.
struct BlastPlan {
  std::string throw_name = "throw";  ///< of the last phase
  double last_firing = 0.0;          ///< [s]
  double wave_end = 0.0;             ///< wave and gas push, at the earliest [s]
  double time_end = 0.0;             ///< of all [s]
  bool ends_with_wave = false;       ///< at wave_end, on joints as stiff as they are then
  double still_share = 0.0;          ///< of the mass, that may still move at rest [-]
  double pulse_step = 0.0;           ///< longest step while a pulse acts [s]
  double between_step = 1e30;        ///< longest step between pulses and after them [s]
  std::vector<PulseSpan> pulses{};   ///< when that step holds: in their order, apart
  double wave_share = 1.0;           ///< step over the longest stable one, in the wave [-]
  double stable_share = 1.0;         ///< the same in the throw [-]

  double push_softening = 1.0;  ///< stiffness in the gas push over that before; 1: the same [-]
  double push_elastic = 0.0;    ///< elastic over kinetic energy, below which waves have gone [-]
  double push_from = 1.0;       ///< of the time from the last firing to wave_end: not before [-]
  double shear_modulus = 0.0;   ///< of the rock before it is softened [Pa]

  Gas gas = Gas::vents_by_time;
  double hole_rest = 0.0;     ///< pressure on a wall whose gas is released [Pa]
  double gas_rest = 0.0;      ///< of the blast's work, added in a twentieth of wave_end [-]
  double gas_patience = 1.0;  ///< times wave_end: then what is left is released [-]

  double softening = 1.0;       ///< stiffness in the throw over that at the start [-]
  double closed_damping = 0.0;  ///< of closed joints then [-]
  CollisionStep collision{};
  long contact_every = 1;  ///< most steps from one act of the contacts to the next
  bool sleep = true;       ///< blocks at rest are left alone in the throw
};

/// `where` starts every message. InputError where the plan does not fit the scene.
[[nodiscard]] BlastPlan blast_plan(const ArgValues& words, const BlastScene& scene,
                                   const std::string& where);

/// Dashpots with which a closed joint rebounds as a sphere contact of this restitution does: as a
/// share of the rock's impedance [-].
[[nodiscard]] double closed_damping(double restitution);

}  // namespace muckpile
