// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command heap: section, surface and angle of repose of a heap of loose blocks.
// Scope: flank towards +x, from the symmetry plane x = 0; floor z = 0.
#include <cmath>

#include "args/input_error.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "measure/pile.h"
#include "report/degrees.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "report/run_section.h"

namespace muckpile {
namespace {

void write_surface(const PileProfile& p, const std::filesystem::path& path) {
  CsvWriter csv(path, "x_m,rock_before_m,surface_mean_m,surface_max_m,rock_length_m");
  for (size_t i = 0; i < p.x.size(); ++i)
    csv.row({p.x[i], p.before[i], p.mean[i], p.highest[i], p.pile_length[i]});
}

nlohmann::ordered_json heap_keys(const PileShape& shape, double cell) {
  nlohmann::ordered_json keys;
  keys["repose_angle_deg"] = degrees(shape.rest_angle);
  keys["front_slope_deg"] = degrees(shape.front_angle);
  keys["pile_height_m"] = shape.height;
  keys["pile_toe_m"] = shape.toe;
  keys["swell_factor"] = shape.swell;
  keys["profile_cell_m"] = cell;
  return keys;
}

SectionPlot section_of(const RunData& run, const PileProfile& p, const PileShape& shape,
                       const SectionOptions& options) {
  const double y = options.y.value_or(0.0);
  const std::string figures = "rest angle " + spelled(degrees(shape.rest_angle)) + "° · height " +
                              spelled(shape.height) + " m · toe " + spelled(shape.toe) +
                              " m · swell " + spelled(shape.swell);
  SectionPlot plot = section_of_run(run, y, options.colour_by);
  plot.title = "Heap";
  plot.subtitle = run.still ? figures : "";
  plot.x_label = "distance from the symmetry plane [m]";
  plot.x = {-0.5, 1.3 * shape.toe};
  plot.z = {-0.5, 1.15 * shape.height};
  plot.moved.assign(run.blocks.size(), 1);
  plot.lines = {
      {line_over(p.x, p.before), kBench, 2.5, true, "rock before"},
      {line_over(p.x, p.mean), kSignal, 3.0, false, "surface after, mean over the width"}};
  plot.note = "section at y = " + spelled(y) + " m, t = " + spelled(run.last.time) + " s";
  return plot;
}

}  // namespace

void report_heap(const ResultFolder& folder, const MeasureOptions& measure,
                 const SectionOptions& section) {
  if (const std::string scene = folder.scene_word("case"); scene != "heap")
    refuse_to_measure(folder, "heap", "the run must be a heap, got '" + scene + "'");
  const RunData run(folder, measure);
  const std::vector<char> all(run.blocks.size(), 1);  // a heap is loose rock throughout
  const PileProfile profile = pile_profile(run.blocks, run.last, all, run.cell, run.lies);
  const PileShape shape = pile_shape(profile, 0.0, run.block_size);
  if (std::isnan(shape.rest_angle)) throw InputError("heap: no heap at x > 0 in the last snapshot");
  SectionPlot plot = section_of(run, profile, shape, section);
  write_surface(profile, folder.file("heap.csv"));
  write_png(draw_section(std::move(plot)), folder.file("heap.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(heap_keys(run.still ? shape : PileShape::none(), run.cell));
  keys["blocks_in_blocks"] = run.blocks_in_blocks();
  folder.merge_into_summary(keys);
}

}  // namespace muckpile
