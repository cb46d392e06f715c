// SPDX-License-Identifier: GPL-2.0-or-later
// Which figures of a sweep are drawn and fitted, and the power laws of them.
// Scope: each swept variable with three positive numbers or more; the influence of the others is
// that of a factor.
#pragma once

#include <string>
#include <vector>

#include "sweep/power_law.h"
#include "sweep/sweep_runs.h"

namespace muckpile {

// Those asked for, or, where none are, those that suit the kind of scene and that the runs have.
// Throws InputError, naming the nearest, for one that no run has.
[[nodiscard]] std::vector<std::string> shown_figures(const Sweep& sweep,
                                                     const std::vector<std::string>& asked);

struct SweepFit {
  std::string figure;
  size_t variable;        // its number in the sweep
  PowerLaw law;           // of the figure over the variable
  size_t runs, left_out;  // left out: done, but not positive in both
  double from, to;        // values of the variable in it
};

[[nodiscard]] std::vector<SweepFit> fit_sweep(const Sweep& sweep,
                                              const std::vector<std::string>& figures);

}  // namespace muckpile
