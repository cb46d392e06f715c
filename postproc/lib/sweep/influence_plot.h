// SPDX-License-Identifier: GPL-2.0-or-later
// sweep.png of a sweep over sampled ranges: each figure over the variable that it follows most.
// Scope: one frame for each figure, one point for each run, lines at P10, P50 and P90.
#pragma once

#include <vector>

#include "draw/panels.h"
#include "sweep/influence.h"
#include "sweep/sweep_runs.h"

namespace muckpile {

// `influences` holds one at least.
[[nodiscard]] Panels plot_of_samples(const Sweep& sweep,
                                     const std::vector<FigureInfluences>& influences);

}  // namespace muckpile
