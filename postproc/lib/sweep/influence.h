// SPDX-License-Identifier: GPL-2.0-or-later
// What a sweep over sampled ranges tells: which variable a figure follows most, and how.
// Scope: runs that are done and have the figure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweep/sweep_runs.h"

namespace muckpile {

struct Influence {
  size_t variable;                        // its number in the sweep
  std::optional<double> correlation;      // of the ranks, -1 to 1
  std::optional<double> exponent, error;  // of y = c x1^n1 x2^n2 ...; positive values only
};

struct FigureInfluences {
  std::string figure;
  size_t runs;                      // that have the figure
  std::vector<Influence> of;        // the variable that matters most first
  std::optional<double> explained;  // share of the variance of ln y, 0 to 1, by the power law
};

// Of variables with numbers; a seed is none.
[[nodiscard]] std::vector<FigureInfluences> influences_of(const Sweep& sweep,
                                                          const std::vector<std::string>& figures);

// sweep_influence.csv in the sweep's folder. Throws InputError if it cannot be written.
void write_influence_table(const Sweep& sweep, const std::vector<FigureInfluences>& influences);

}  // namespace muckpile
