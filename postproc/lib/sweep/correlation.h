// SPDX-License-Identifier: GPL-2.0-or-later
// How closely two quantities go together, and how one follows from several.
// Scope: small tables of runs; all lists of a call have the same length.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace muckpile {

// Pearson's, -1 to 1; nothing where one of them does not vary.
[[nodiscard]] std::optional<double> correlation(const std::vector<double>& a,
                                                const std::vector<double>& b);

// Places in rising order from 1 on; equal values share the mean of their places.
[[nodiscard]] std::vector<double> ranks_of(const std::vector<double>& values);

// Spearman's: that of the ranks. 1 where one rises whenever the other does, however curved.
[[nodiscard]] std::optional<double> rank_correlation(const std::vector<double>& a,
                                                     const std::vector<double>& b);

struct LinearLaw {
  std::vector<double> slopes;  // of each quantity
  std::vector<double> errors;  // standard errors of the slopes
  double explained;            // share of the variance of y, 0 to 1
};

// y = a + sum of slopes x, by least squares; x[k] holds quantity k of all runs. Nothing where there
// is no run more than unknowns, or the quantities do not tell the slopes apart.
[[nodiscard]] std::optional<LinearLaw> fit_linear(const std::vector<std::vector<double>>& x,
                                                  const std::vector<double>& y);

}  // namespace muckpile
