// SPDX-License-Identifier: GPL-2.0-or-later
// The rock of a section, from the last snapshot of a run.
// Scope: see the header.
#include "report/run_section.h"

#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "draw/axes.h"
#include "measure/section.h"
#include "measure/start_extent.h"
#include "report/notes.h"

namespace muckpile {
namespace {

void require_rock_at(double y, const RunData& run) {
  constexpr double kRounding = 1e-6;  // [m], of rock that ends in a plane of the section
  const Extent before = extent_at_start(run.blocks), after = extent_of(run.blocks, run.last.states);
  const double low = std::min(before.low.y(), after.low.y()),
               high = std::max(before.high.y(), after.high.y());
  if (y >= low - kRounding && y <= high + kRounding) return;
  throw InputError("--y must be where rock lies, from " + spelled(low) + " to " + spelled(high) +
                   " m, got '" + spelled(y) + "'");
}

}  // namespace

SectionPlot section_of_run(const RunData& run, double y, const std::string& colour_by) {
  SectionPlot plot{};
  const std::vector<StartBlock>& all = run.folder.blocks();
  require_rock_at(y, run);
  plot.polygons = section_at(y, all, run.with_muck().states);
  plot.moved = run.moved;
  plot.moved.resize(all.size(), 1);
  plot.colours = colours_of_run(run, colour_by);
  plot.note = section_note(y, run.last.time);
  if (!run.muck.empty()) plot.note += "; muck that lay in front is grey-green";
  plot.warning = motion_warning(run.still);
  return plot;
}

BlockColours colours_of_run(const RunData& run, const std::string& field) {
  return block_colours(BlockFields(run.folder, run.folder.blocks()).of(field, run.with_muck()));
}

std::vector<Vec2> line_over(const std::vector<double>& x, const std::vector<double>& z) {
  std::vector<Vec2> points;
  for (size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], z[i]);
  return points;
}

namespace {

// Its own hole's, else that of all, else of its crushed zone.
double half_of(const Charge& charge, double hole_radius) {
  if (!std::isnan(charge.hole_radius)) return charge.hole_radius;
  return std::isnan(hole_radius) ? charge.radius : hole_radius;
}

}  // namespace

std::vector<SectionBar> charge_bars(const PlanLine& line, const std::vector<Charge>& charges,
                                    double half_width, double hole_radius) {
  std::vector<SectionBar> bars;
  for (const Charge& charge : charges) {
    const Vec2 low = line.along_and_left(charge.toe.head<2>());
    const Vec2 high = line.along_and_left(charge.collar.head<2>());
    const bool across = low.y() * high.y() < 0.0;
    const double off = across ? 0.0 : std::min(std::abs(low.y()), std::abs(high.y()));
    if (off > std::max(charge.radius, half_width)) continue;
    if (std::max(low.x(), high.x()) < 0.0 || std::min(low.x(), high.x()) > line.length()) continue;
    bars.push_back({{low.x(), charge.toe.z()},
                    {high.x(), charge.collar.z()},
                    half_of(charge, hole_radius),
                    kSignal,
                    bars.empty() ? "charge before" : ""});
  }
  return bars;
}

}  // namespace muckpile
