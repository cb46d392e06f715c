// SPDX-License-Identifier: GPL-2.0-or-later
// Rules of practice for vibration and fly rock.
// Scope: formulas beside a simulation, never part of it; constants as their sources have them
// (docs/sources.md). SI units inside.
#pragma once

namespace muckpile {

// Peak particle velocity [m/s] at a scaled distance R/sqrt(W) [m/kg^0.5]: 234 (D/sqrt(w))^-1.62
// [in/s], D in ft, w in lb: the conservative estimate of the U.S. Bureau of Mines for many blasts.
double bureau_of_mines_ppv(double scaled_distance);

// Horizontal range of fly rock [m] after Richards & Moore, without a factor of safety:
// k^2/g (sqrt(m)/B)^2.6. `confinement`: the burden for a face burst, the stemming length for
// cratering [m]; `mass_per_metre` of charge [kg/m].
double richards_moore_range(double constant, double mass_per_metre, double confinement);
// The constant's usual range.
inline constexpr double kRichardsMooreLow = 14.0, kRichardsMooreHigh = 30.0;

// The same by gun-barrelling: stemming is blown out of a hole at this angle to the horizontal
// [rad].
double gun_barrelling_range(double constant, double mass_per_metre, double stemming, double angle);

// McKenzie's scaled depth of burial [m/kg^(1/3)]: depth of the middle of the charge that counts
// over the cube root of its mass. That is the upper ten diameters of it, of holes below 100 mm
// eight.
double scaled_depth_of_burial(double stemming, double charge_length, double diameter,
                              double mass_per_metre);

// Largest range [m] of fly rock of any size after McKenzie, with air: 9.74 SDoB^-2.167 d^(2/3), and
// the size of the fragment that flies so far [m]: 3 SDoB^-2.167 (2600/density) d^(2/3) [mm]; the
// diameter d of the hole in mm in both.
double mckenzie_range(double depth_of_burial, double diameter);
double mckenzie_fragment(double depth_of_burial, double diameter, double rock_density);

}  // namespace muckpile
