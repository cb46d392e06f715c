// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command profile: section, profile and measures of the muck pile of a bench.
// Scope: bench coordinates, toe of the free face at x = 0, z = 0.
#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "measure/collapse.h"
#include "measure/face_velocity.h"
#include "measure/pile.h"
#include "measure/start_extent.h"
#include "report/bench_scene.h"
#include "report/degrees.h"
#include "report/face_bands.h"
#include "report/not_measurable.h"
#include "report/notes.h"
#include "report/reports.h"
#include "report/rows_of_run.h"
#include "report/run_section.h"

namespace muckpile {
namespace {

struct FaceSpeed {
  double peak = std::nan("");    // of the fastest band of height [m/s]
  double mean = std::nan("");    // of the middle half of the charge's height [m/s]
  double burden = std::nan("");  // of all rock between face and holes, above the floor [m/s]
  std::vector<FaceBand> bands{};
};

std::vector<size_t> burden_prism(const std::vector<StartBlock>& blocks, const BenchScene& bench) {
  std::vector<size_t> prism;
  for (size_t b = 0; b < blocks.size(); ++b)
    if (bench.planes.in_front_of(bench.burden, blocks[b].centroid)) prism.push_back(b);
  return prism;
}

std::vector<FaceBand> bands_of(const std::vector<StartBlock>& blocks, const BenchScene& bench) {
  std::vector<FaceBand> bands;
  const double step = bench.height / kFaceBands;
  for (auto& layer : face_bands(blocks, bench.burden, bench.height, kFaceBands, bench.planes)) {
    const auto k = static_cast<double>(bands.size());
    bands.push_back({"all", k * step, (k + 1) * step, std::move(layer)});
  }
  return bands;
}

// Peaks over the snapshots. Only the charge above the pit floor drives the face.
FaceSpeed face_speed_of(const ResultFolder& folder, const RunData& run, const BenchScene& bench) {
  const std::vector<StartBlock>& blocks = run.blocks;
  const double low = std::max(bench.charge_bottom, 0.0), quarter = 0.25 * (bench.charge_top - low);
  const std::vector<size_t> middle =
      face_layer(blocks, bench.burden, low + quarter, bench.charge_top - quarter, bench.planes);
  FaceSpeed speed;
  speed.bands = bands_of(blocks, bench);
  const std::vector<size_t> prism = burden_prism(blocks, bench);
  std::vector<char> wanted(blocks.size(), 0);
  for (const auto& chosen : {middle, prism})
    for (const size_t b : chosen) wanted[b] = 1;
  for (const FaceBand& band : speed.bands)
    for (const size_t b : band.layer) wanted[b] = 1;
  RowsOfRun rows(run, wanted);
  for (const auto& path : folder.snapshots()) {
    const Snapshot& now = rows.read(path);
    if (!middle.empty())
      speed.mean = std::fmax(speed.mean, mean_outward_velocity(blocks, now, middle, bench.planes));
    if (!prism.empty())
      speed.burden =
          std::fmax(speed.burden, mean_outward_velocity(blocks, now, prism, bench.planes));
    for (FaceBand& band : speed.bands) add_velocity(band, blocks, now, bench.planes);
  }
  for (const FaceBand& band : speed.bands) speed.peak = std::fmax(speed.peak, band.peak);
  return speed;
}

// A level floor is at 0 and has no column.
void write_profile(const PileProfile& p, bool level, const std::filesystem::path& path) {
  CsvWriter csv(path, std::string("x_m,bench_before_m,pile_mean_m,pile_centre_m,pile_max_m,"
                                  "rock_in_place_m,broken_rock_m,broken_rock_length_m") +
                          (level ? "" : ",floor_m"));
  for (size_t i = 0; i < p.x.size(); ++i) {
    std::vector<double> row{p.x[i],       p.before[i],        p.mean[i], p.centre[i],
                            p.highest[i], p.rock_in_place[i], p.pile[i], p.pile_length[i]};
    if (!level) row.push_back(p.floor[i]);
    csv.row(row);
  }
}

// What the run has measured, the pile's shape only if it lies still.
struct BenchFigures {
  FaceSpeed face;
  Throw thrown;
  PileShape pile;
  double collapse;  // beyond the old toe without any throw, share of the burden prism
};

// Of one row behind an upright face: rock of further rows would slump over the first one's, and the
// formula is for a wall.
double collapse_of(const BenchScene& bench, const Throw& thrown, const PileShape& pile,
                   double width) {
  const bool upright = bench.planes.face == nullptr && bench.planes.frames == nullptr &&
                       bench.planes.face_back == 0.0;
  if (!bench.one_row || !upright) return std::nan("");
  return collapsed_beyond_toe(
      {bench.height, bench.burden, thrown.prism_volume / width, pile.swell, pile.rest_angle});
}

BenchFigures figures_of(const ResultFolder& folder, const RunData& run, const BenchScene& bench,
                        const PileProfile& profile) {
  BenchFigures figures{face_speed_of(folder, run, bench),
                       throw_of(run.blocks, run.last, bench.burden, bench.planes),
                       PileShape::none(), 0.0};
  if (run.still && !bench.several_sides)
    figures.pile = pile_shape(profile, bench.depth, mean_block_size(run.blocks, run.moved));
  if (!run.muck.empty())  // there is muck below its surface, too
    figures.pile.swell = figures.pile.bulk_volume = figures.pile.solid_volume = std::nan("");
  figures.collapse = collapse_of(bench, figures.thrown, figures.pile, profile.width);
  return figures;
}

// Where muck that lay in front went; nothing without any.
nlohmann::ordered_json muck_keys(const RunData& run) {
  nlohmann::ordered_json keys;
  double mass = 0.0, moved = 0.0;
  for (size_t b = 0; b < run.muck.size(); ++b) {
    mass += run.muck[b].mass;
    moved += run.muck[b].mass * (run.muck_states[b].centre.x() - run.muck[b].centroid.x());
  }
  if (run.muck.empty()) return nlohmann::ordered_json::object();
  keys["muck_mass_kg"] = mass;
  keys["muck_moved_m"] = moved / mass;
  return keys;
}

nlohmann::ordered_json keys_of(const BenchFigures& figures, const RunData& run) {
  const auto& [face, thrown, pile, collapse] = figures;
  nlohmann::ordered_json keys;
  keys["face_velocity_m_s"] = face.peak;
  keys["face_velocity_mean_m_s"] = face.mean;
  keys["burden_velocity_m_s"] = face.burden;
  keys["throw_cg_m"] = thrown.centre_of_mass;
  keys["throw_max_m"] = thrown.largest;
  keys["throw_max_note"] = kLargestThrowNote;
  keys["beyond_toe_fraction"] = thrown.beyond_toe;
  keys["beyond_toe_fraction_collapse"] = collapse;
  keys["pile_height_m"] = pile.height;
  keys["pile_height_x_m"] = pile.height_x;
  keys["pile_toe_m"] = pile.toe;
  keys["pile_toe_98_m"] = pile.toe_98;
  keys["swell_factor"] = pile.swell;
  keys["pile_bulk_volume_m3"] = pile.bulk_volume;
  keys["pile_solid_volume_m3"] = pile.solid_volume;
  keys["repose_angle_deg"] = degrees(pile.rest_angle);
  keys["front_slope_deg"] = degrees(pile.front_angle);
  keys["profile_cell_m"] = run.cell;
  keys["blocks_on_the_move"] = std::ranges::count(run.lies, 0);
  keys["blocks_in_blocks"] = nullptr;  // looked for once, in report_profile()
  keys.update(muck_keys(run));
  return keys;
}

nlohmann::ordered_json own_keys(const RunData& run) {
  nlohmann::ordered_json keys = keys_of({}, run);
  keys["face_note"] = nullptr;
  return keys;
}

std::string title_of(const ResultFolder& folder) {
  std::string title = "Muck pile: bench " + spelled(folder.scene_number("bench_height_m")) +
                      " m, burden " + spelled(folder.scene_number("burden_m")) + " m";
  if (folder.scene_has("spacing_m"))
    title += ", spacing " + spelled(folder.scene_number("spacing_m")) + " m";
  return title;
}

std::string subtitle_of(const BenchScene& bench, const BenchFigures& figures) {
  const PileShape& pile = figures.pile;
  const struct {
    const char *name, *unit;
    double value;
  } facts[] = {{bench.one_row ? "throw of the mass centre " : "throw of the front row ", " m",
                figures.thrown.centre_of_mass},
               {"height ", " m", pile.height},
               {"toe ", " m", pile.toe},
               {"swell ", "", pile.swell},
               {"rest angle ", "°", degrees(pile.rest_angle)},
               {"face ", " m/s", figures.face.peak}};
  std::string text;
  for (const auto& [name, unit, value] : facts) {
    if (std::isnan(value)) continue;
    text += (text.empty() ? "" : " · ") + (name + spelled(value)) + unit;
  }
  return text;
}

// A fifth beyond the toe, which in a run that is not still is that of the rock in flight; a few
// blocks that flew farther would shrink all the rest.
double reach_of(const PileProfile& profile, const BenchScene& bench, const RunData& run) {
  const PileShape all = pile_shape(profile, bench.depth, mean_block_size(run.blocks, run.moved));
  if (std::isnan(all.toe)) return bench.burden;
  return std::max(1.2 * std::max(all.toe, all.toe_98), bench.burden);
}

SectionPlot section_of(const ResultFolder& folder, const RunData& run, const PileProfile& p,
                       const BenchScene& bench, const SectionOptions& options) {
  const double y = options.y.value_or(y_of_middle_hole(bench, run.blocks));
  const Extent before = extent_at_start(run.blocks);
  const double top = std::max(bench.height, *std::ranges::max_element(p.mean));
  const double reach = reach_of(p, bench, run);
  double bottom = before.low.z();
  for (size_t i = 0; i < p.x.size() && p.x[i] <= reach; ++i) bottom = std::min(bottom, p.floor[i]);
  SectionPlot plot = section_of_run(run, y, options.colour_by);
  plot.title = title_of(folder);
  plot.x_label = "distance from the toe of the free face, along the throw [m]";
  plot.x = {before.low.x() - 1.0, reach + 1.0};
  plot.z = {bottom - 0.5, top + 0.12 * bench.height};
  plot.bars = hole_bars(bench, y);
  plot.lines = {
      {line_over(p.x, p.before), kBench, 2.5, true, "bench before"},
      {line_over(p.x, p.mean), kSignal, 3.0, false, "surface after, mean over the width"}};
  if (!run.floor.level())
    plot.lines.push_back({line_over(p.x, p.floor), kInk, 2.0, false, "pit floor, likewise"});
  const auto beyond = std::ranges::count_if(
      run.last.states, [&](const BlockState& s) { return s.centre.x() > plot.x.high; });
  if (beyond > 0) {
    plot.note += "; " + std::to_string(beyond) + (beyond == 1 ? " block lies" : " blocks lie") +
                 " beyond the picture";
  }
  return plot;
}

// `rows` draws the face in front of each hole where there is a table of them.
bool rows_draw_the_face(const ResultFolder& folder) {
  return std::filesystem::exists(folder.dump("holes.csv"));
}

BenchScene bench_or_nothing(const ResultFolder& folder, const RunData& run) {
  try {
    return bench_or_take_back(folder, run.blocks, "profile", own_keys(run));
  } catch (const NotMeasurable&) {
    if (!rows_draw_the_face(folder)) remove_face_bands(folder);
    throw;
  }
}

}  // namespace

void report_profile(const ResultFolder& folder, const MeasureOptions& measure,
                    const SectionOptions& section) {
  if (folder.scene_word("case") == "crater") {
    throw InputError("profile: the run must be a bench, got 'crater'; use the sub-command crater");
  }
  const RunData run(folder, measure);
  const BenchScene bench = bench_or_nothing(folder, run);
  const PileProfile profile =
      pile_profile(run.blocks, run.last, run.moved, run.cell, run.lies, bench.planes, run.floor);
  const BenchFigures figures = figures_of(folder, run, bench, profile);
  SectionPlot plot = section_of(folder, run, profile, bench, section);
  write_profile(profile, run.floor.level(), folder.file("profile.csv"));
  if (!rows_draw_the_face(folder)) write_face_bands(folder, figures.face.bands, run.still);
  plot.subtitle = subtitle_of(bench, figures);
  write_png(draw_section(std::move(plot)), folder.file("profile.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(keys_of(figures, run));
  keys["blocks_in_blocks"] = run.blocks_in_blocks();
  keys["face_note"] = nullptr;
  if (!bench.face_note.empty()) keys["face_note"] = bench.face_note;
  folder.merge_into_summary(keys, {refusal_key("profile")});
}

}  // namespace muckpile
