// SPDX-License-Identifier: GPL-2.0-or-later
// Downward slopes of a surface: least-squares lines through stretches of its samples.
// Scope: evenly spaced samples [begin, end) of height z [m] over x [m]; positive where z falls
// along +x.
#pragma once

#include <cstddef>
#include <vector>

namespace muckpile {

// The line through the samples whose height is from `low` to `high` [m]; NaN for fewer than three.
double slope_between_heights(const std::vector<double>& x, const std::vector<double>& z,
                             size_t begin, size_t end, double low, double high);

// The steepest line through any stretch of the length `stretch` [m], or through all samples where
// they are shorter; NaN for fewer than three.
double steepest_slope(const std::vector<double>& x, const std::vector<double>& z, size_t begin,
                      size_t end, double stretch);

}  // namespace muckpile
