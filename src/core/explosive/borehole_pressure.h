// SPDX-License-Identifier: GPL-2.0-or-later
// Pressure of a fully coupled charge on the wall of its borehole, by the usual formulas.
// Scope: the starting value only; expansion is two_stage_isentrope.h, distance is attenuation.h.
#pragma once

namespace muckpile {

struct Explosive {
  double density;              ///< [kg/m3]
  double detonation_velocity;  ///< along the column [m/s]
};

// All functions: SI units, result [Pa]. InputError unless every argument is positive and finite.

/// Chapman-Jouguet pressure rho D^2 / (1 + gamma), detonation theory. gamma = 3 gives rho D^2 / 4.
[[nodiscard]] double chapman_jouguet_pressure(const Explosive& explosive, double gamma = 3.0);

/// Explosion state (constant volume), rho D^2 / 8, half of the Chapman-Jouguet pressure at gamma
/// = 3. The default of fix muckpile/blast and of most blast models; no shock reflection at the
/// wall.
[[nodiscard]] double explosion_state_pressure(const Explosive& explosive);

/// Explosion state from P_CJ (gamma / (1 + gamma))^gamma, gamma usually 2.4 to 2.8 (Bastante,
/// lecture book on blasting, University of Vigo).
[[nodiscard]] double explosion_state_pressure_by_gamma(const Explosive& explosive, double gamma);

/// Fit to that formula, 0.115 rho^0.868 D^2 [GPa; g/cm3, km/s] (Bastante, same book).
[[nodiscard]] double explosion_state_pressure_fit(const Explosive& explosive);

/// Shock at the wall when the detonation wave meets rock of impedance rho_r c_p [Pa s/m]:
/// (rho D^2 / 4) 2 / (1 + rho D / (rho_r c_p)), the acoustic approximation (docs/sources.md). An
/// upper bound: about three times the explosion state in hard rock.
[[nodiscard]] double impedance_matched_pressure(const Explosive& explosive, double rock_impedance);

}  // namespace muckpile
