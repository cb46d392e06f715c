// SPDX-License-Identifier: GPL-2.0-or-later
// Loss of peak wave pressure between the borehole wall and the outer radius of the crushed zone.
// Scope: a power law of distance; beyond the crushed zone the block model carries the wave itself.
#pragma once

namespace muckpile {

/// Exponent 2 + nu/(1 - nu) for a shock in crushed rock (textbook value, used by the group whose
/// work we follow; that it is what their paper used is our inference). InputError unless 0 <= nu <
/// 0.5.
[[nodiscard]] double crushed_zone_exponent(double poisson_ratio);

/// Exponent 1.54 (c_p/D)^-0.33 of the Liu and Katsabanis type (docs/sources.md): about 1.5, so its
/// P1 on three hole radii is 2.4 times that of the shock exponent. InputError unless both speeds
/// [m/s] are positive.
[[nodiscard]] double liu_katsabanis_exponent(double p_wave_speed, double detonation_velocity);

/// Hino (1956): exponents 1.2 to 1.5, worked with 1.4 here; shown beside the others only.
inline constexpr double kHinoExponent = 1.4;

/// Where no other is asked for: of a stress wave, the highest that Hino has
/// (docs/theory/charge.md).
inline constexpr double kStressWaveExponent = 1.5;

/// pressure (borehole_radius / radius)^exponent [Pa]. InputError if a radius is not positive, if
/// radius < borehole_radius, or if the pressure or exponent is negative.
[[nodiscard]] double attenuated_pressure(double pressure, double borehole_radius, double radius,
                                         double exponent);

}  // namespace muckpile
