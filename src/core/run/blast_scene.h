// SPDX-License-Identifier: GPL-2.0-or-later
// What the plan of a blast takes from the scene: its charges, rock and contacts.
// Scope: plain numbers, SI.
#pragma once

#include <optional>
#include <vector>

namespace muckpile {

/// From a charge's firing until its pulse has gone.
struct PulseSpan {
  double begin = 0.0, end = 0.0;  ///< [s]
};

/// What the charges say of the time that they need; their clock starts with the first run that has
/// them.
struct BlastTiming {
  double start = 0.0;        ///< of that clock, on the engine's [s]
  double rise_time = 0.0;    ///< of the pulse, and of the gas behind it; 0: a jump [s]
  double pulse_end = 0.0;    ///< of all holes: joints may be softened from then on [s]
  double last_firing = 0.0;  ///< [s]
  double wall_load = 0.0;    ///< greatest pressure on a wall over its radius, of all holes [Pa/m]
  std::vector<PulseSpan> pulses{};  ///< of all charges
  /// From firing until the gas vents, and its decay then [s]; 0 without gas, nothing where the gas
  /// leaves by flow and no such times are given.
  std::optional<double> vent_time = 0.0, vent_decay = 0.0;
};

/// The rock as it is before anything is softened.
struct RockConstants {
  double density = 0.0;         ///< [kg/m3]
  double youngs_modulus = 0.0;  ///< [Pa]
  double poisson_ratio = 0.0;   ///< [-]
  double fastest_wave = 0.0;    ///< c_P, of the fastest rock [m/s]
  double impedance = 0.0;       ///< rho c_P, of the rock with the least [kg/(m2 s)]
};

/// Contacts of blocks: of their spheres, by Hertz, or of the polyhedra.
struct BlockContacts {
  double youngs_modulus = 0.0;  ///< [Pa]
  double poisson_ratio = 0.0;   ///< [-]
  double restitution = 1.0;     ///< [-]
  bool polyhedra = false;
};

/// Where gas is that the rock must be stiff for.
enum class Gas {
  vents_by_time,  ///< nowhere: it has vented at the end of the wave
  in_holes,       ///< in the holes, until it has flowed out of them
  in_joints,      ///< in joints as well
};

struct BlastScene {
  BlastTiming timing{};
  RockConstants rock{};
  BlockContacts contacts{};
  Gas gas = Gas::vents_by_time;
  double gas_step = 1e30;  ///< longest that the flow in joints bears [s]
};

}  // namespace muckpile
