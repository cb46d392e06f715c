// SPDX-License-Identifier: GPL-2.0-or-later
// The tables of a sweep: sweep.csv, sweep_mean.csv and sweep_fit.csv in its folder.
// Scope: six significant digits; an empty field is a measure without a value.
#pragma once

#include <vector>

#include "sweep/sweep_fits.h"
#include "sweep/sweep_runs.h"

namespace muckpile {

// A row for each run: the swept values, the seed, the state, all figures. Throws InputError, as do
// those below, if the file cannot be written.
void write_runs_table(const Sweep& sweep);

// A row for each combination of values and each figure that has one there: its spread over the
// seeds. Runs with samples of ranges are one combination.
void write_spread_table(const Sweep& sweep);

// A row for each fit.
void write_fit_table(const Sweep& sweep, const std::vector<SweepFit>& fits);

// Runs that are done, by their places among the values, in the order of the sweep.
[[nodiscard]] std::vector<std::vector<const SweepRun*>> combinations_of(const Sweep& sweep);

}  // namespace muckpile
