// SPDX-License-Identifier: GPL-2.0-or-later
// How far apart smooth walls are that let as much through as rough ones (Barton, Bandis & Bakhtar
// 1985, Int. J. Rock Mech. Min. Sci. 22:121-140): e = E^2 / JRC^2.5 in um, at most E.
// Scope: pure functions, for joint laws and for the gas in cracks.
#pragma once

#include <algorithm>
#include <cmath>

namespace muckpile {

/// Mechanical aperture from which on walls of that JRC are as smooth ones: JRC^2.5 um [m].
[[nodiscard]] inline double smooth_from_aperture(double roughness) {
  return 1e-6 * std::pow(roughness, 2.5);
}
/// [m]
[[nodiscard]] inline double hydraulic_aperture(double mechanical, double smooth_from) {
  return std::min(mechanical, mechanical * mechanical / smooth_from);
}

}  // namespace muckpile
