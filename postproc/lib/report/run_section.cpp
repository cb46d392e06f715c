// SPDX-License-Identifier: GPL-2.0-or-later
// The rock of a section, from the last snapshot of a run.
// Scope: see the header.
#include "report/run_section.h"

#include "report/notes.h"

namespace muckpile {

SectionPlot section_of_run(const RunData& run, double y, ColourBy colour_by) {
  SectionPlot plot{};
  const std::vector<StartBlock> all = run.with_muck();
  Snapshot last = run.last;
  last.states.insert(last.states.end(), run.muck_states.begin(), run.muck_states.end());
  plot.polygons = section_at(y, all, last.states);
  plot.moved = run.moved;
  plot.moved.resize(all.size(), 1);
  plot.colours = block_colours(colour_by, all, last);
  plot.note = section_note(y, run.last.time);
  if (!run.muck.empty()) plot.note += "; muck that lay in front is grey-green";
  plot.warning = motion_warning(run.still);
  return plot;
}

std::vector<Vec2> line_over(const std::vector<double>& x, const std::vector<double>& z) {
  std::vector<Vec2> points;
  for (size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], z[i]);
  return points;
}

}  // namespace muckpile
