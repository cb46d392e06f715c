// SPDX-License-Identifier: GPL-2.0-or-later
// Where to cut one axis so that every part holds the same weight.
// Scope: fractions of the axis, 0 to 1; pure functions.
#pragma once

#include <span>
#include <vector>

namespace muckpile {

/// parts + 1 rising fractions from 0 to 1. `weights`: one per bin, bins of equal width over [0, 1];
/// within a bin the weight is taken as even. No weight at all: even widths.
[[nodiscard]] std::vector<double> even_cuts(std::span<const double> weights, int parts);

/// Keeps parts at least `narrowest` wide (or 1 / parts, if there is no room for that).
[[nodiscard]] std::vector<double> widened_cuts(std::vector<double> cuts, double narrowest);

/// Moves the cuts towards `wanted`, but stays `margin` away from their neighbours in `now`: what
/// has left its part by less than that, and what a part gives away, goes to the next part only. A
/// cut whose two parts together are thinner than twice the margin stays where it is.
[[nodiscard]] std::vector<double> neighbourly_cuts(std::span<const double> now,
                                                   std::span<const double> wanted, double margin);

}  // namespace muckpile
