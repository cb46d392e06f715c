// SPDX-License-Identifier: GPL-2.0-or-later
// What the sections of profile, crater and heap share: the rock as it lies in a run's last
// snapshot. Scope: title, axes and what is drawn over the rock are each report's own.
#pragma once

#include <string>
#include <vector>

#include "io/charges.h"
#include "measure/plan_line.h"
#include "report/run_data.h"
#include "report/section_plot.h"

namespace muckpile {

// Rock in the plane y [m], its colours, where and when it is, and whether it still moves.
SectionPlot section_of_run(const RunData& run, double y, const std::string& colour_by);

// By a field at the end of the run.
BlockColours colours_of_run(const RunData& run, const std::string& field);

// Points (x, z) of two columns of equal length.
std::vector<Vec2> line_over(const std::vector<double>& x, const std::vector<double>& z);

// Along a line in plan: the charges whose axes come within the radius of their crushed zone, or
// half the width, of it, as wide as their holes; where the table does not tell, as `hole_radius`
// [m], and where that is NaN, as their crushed zones.
std::vector<SectionBar> charge_bars(const PlanLine& line, const std::vector<Charge>& charges,
                                    double half_width, double hole_radius);

}  // namespace muckpile
