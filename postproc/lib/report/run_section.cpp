// SPDX-License-Identifier: GPL-2.0-or-later
// The rock of a section, from the last snapshot of a run.
// Scope: see the header.
#include "report/run_section.h"

#include "report/notes.h"

namespace muckpile {

SectionPlot section_of_run(const RunData& run, double y, const std::string& colour_by) {
  SectionPlot plot{};
  const std::vector<StartBlock>& all = run.folder.blocks();
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

}  // namespace muckpile
