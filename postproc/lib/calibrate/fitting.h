// SPDX-License-Identifier: GPL-2.0-or-later
// A calibration with all that it is made of: the sweep, the measures, the surfaces and the
// estimate. Scope: what the tables, the picture and the site file of calibrate_report.cpp tell.
#pragma once

#include <vector>

#include "calibrate/calibrate_plot.h"
#include "calibrate/calibrate_report.h"
#include "calibrate/measured.h"
#include "sweep/sweep_runs.h"

namespace muckpile {

struct Fitting {
  Sweep sweep;
  std::vector<MeasuredFigure> measured;
  std::vector<PlottedConstant> constants;  // one per variable of the sweep
  std::vector<PlottedFigure> figures;      // one per measured figure
  std::vector<Target> targets;             // the same
  SurfaceOrder order;
  Calibration result;
};

// Throws InputError as report_calibration tells.
[[nodiscard]] Fitting fitted(const FitOptions& options);

[[nodiscard]] double estimate(const Fitting& f, size_t i);  // of constant i

// Standard deviation of the constant's logarithm.
[[nodiscard]] double error_ln(const Fitting& f, size_t i);

// Share of the constant that the measures tell: 1 if all combinations that hold it are resolved.
[[nodiscard]] double told(const Fitting& f, size_t i);

}  // namespace muckpile
