// SPDX-License-Identifier: GPL-2.0-or-later
// Plane wave on the viscous boundary t_n = -rho c_P v_n, t_s = -rho c_S v_s of an elastic half
// space: what comes back (Lysmer & Kuhlemeyer 1969, who show that all is absorbed at 0 degrees).
// Scope: isotropic elastic, polarised in the plane of incidence; no resolution in space or time.
#pragma once

namespace muckpile {

enum class WaveType { p, s };

/// Share of the incident energy flux towards the boundary that the reflected P- and S-wave carry
/// away. `angle` from the normal [rad], in [0, pi/2); 0 <= poisson_ratio < 0.5.
[[nodiscard]] double viscous_boundary_reflection(WaveType incident, double angle,
                                                 double poisson_ratio);

}  // namespace muckpile
