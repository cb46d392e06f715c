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

}  // namespace muckpile
