// SPDX-License-Identifier: GPL-2.0-or-later
// Peak particle velocity beside an endless charge against the law of Holmberg and Persson.
// Scope: gauges of a slice 1 m thick, whose charge is that of a metre of the hole.
#pragma once

#include <filesystem>
#include <vector>

#include "figures/figures.h"

namespace muckpile::check {

/// Holmberg & Persson 1979 (hard bedrock, K = 0.7 m/s, alpha = 0.7, beta = 1.5): the peaks v of
/// the parts of a charge of q [kg/m] add up to v = 0.7 (q/r [atan((H - z)/r) + atan(z/r)])^0.7
/// [m/s] at the distance r [m], and 0.7 (pi q/r)^0.7 where the charge has no end.
[[nodiscard]] double holmberg_persson(double charge_per_metre, double distance);

/// Of the gauges between `near` and `far` [m] in FOLDER/ppv.csv of muckpile-post waves, for each
/// folder, NAME being its last part:
///   NAME_over_law: mean of the peaks over the law's, of the logarithms;
///   NAME_over_law_least, NAME_over_law_most: of single gauges;
///   NAME_distance_exponent: n of v = c r^n by least squares of the logarithms.
/// InputError where a file, column or gauge is missing, a number is not > 0, or two folders have
/// one name.
[[nodiscard]] Json near_field(const std::vector<std::filesystem::path>& folders, double near,
                              double far);

}  // namespace muckpile::check
