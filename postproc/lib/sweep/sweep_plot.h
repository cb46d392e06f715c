// SPDX-License-Identifier: GPL-2.0-or-later
// sweep.png: figures of a sweep over its first variable.
// Scope: one frame for each figure, one curve for each combination of the other variables.
#pragma once

#include <string>
#include <vector>

#include "draw/panels.h"
#include "sweep/sweep_fits.h"
#include "sweep/sweep_runs.h"

namespace muckpile {

// Points are means over the seeds, bars reach from the least to the largest. A first variable that
// has a value that is no number stands on an axis of words. `figures` holds one at least.
[[nodiscard]] Panels plot_of_sweep(const Sweep& sweep, const std::vector<std::string>& figures,
                                   const std::vector<SweepFit>& fits);

// Of a key, as pictures name it: "Throw of the mass centre [m]".
[[nodiscard]] std::string name_of_figure(const std::string& figure);

}  // namespace muckpile
