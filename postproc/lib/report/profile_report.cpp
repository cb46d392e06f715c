// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command profile: section, profile and measures of the muck pile of a bench.
// Scope: bench coordinates, free face at x = 0, pit floor at z = 0.
#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "measure/face_velocity.h"
#include "measure/pile.h"
#include "report/degrees.h"
#include "report/reports.h"
#include "report/run_data.h"
#include "report/section_plot.h"

namespace muckpile {
namespace {

struct Hole {
  double x, top, bottom;             // [m]
  double charge_top, charge_bottom;  // [m]
  double radius;                     // [m]
};

Hole hole_of(const ResultFolder& folder) {
  const double height = folder.scene_number("bench_height_m");
  const double charge_top = height - folder.scene_number("stemming_m");
  const double charge_bottom = charge_top - folder.scene_number("charge_length_m");
  const double bottom =
      folder.scene_has("subdrill_m") ? -folder.scene_number("subdrill_m") : charge_bottom;
  return {-folder.scene_number("burden_m"),
          height,
          std::min(bottom, charge_bottom),
          charge_top,
          charge_bottom,
          0.5 * folder.scene_number("hole_diameter_m")};
}

struct FaceSpeed {
  double peak = std::nan("");  // of the fastest band of height [m/s]
  double mean = std::nan("");  // of the middle half of the charge's height [m/s]
};

constexpr int kFaceBands = 10;  // bands of height, as a velocity profile of a filmed face has

// Peaks over the snapshots. Only the charge above the pit floor drives the face.
FaceSpeed face_speed_of(const ResultFolder& folder, const std::vector<StartBlock>& blocks,
                        const Hole& hole) {
  const double low = std::max(hole.charge_bottom, 0.0), quarter = 0.25 * (hole.charge_top - low);
  const std::vector<size_t> middle =
      face_layer(blocks, -hole.x, low + quarter, hole.charge_top - quarter);
  std::vector<std::vector<size_t>> bands;
  for (int k = 0; k < kFaceBands; ++k) {
    const double step = hole.top / kFaceBands;
    bands.push_back(face_layer(blocks, -hole.x, k * step, (k + 1) * step));
  }
  FaceSpeed speed;
  for (const auto& path : folder.snapshots()) {
    const Snapshot now = read_snapshot(path, blocks);
    if (!middle.empty())
      speed.mean = std::fmax(speed.mean, mean_outward_velocity(blocks, now, middle));
    for (const auto& band : bands) {
      if (!band.empty())
        speed.peak = std::fmax(speed.peak, mean_outward_velocity(blocks, now, band));
    }
  }
  return speed;
}

void write_profile(const PileProfile& p, const std::filesystem::path& path) {
  CsvWriter csv(path,
                "x_m,bench_before_m,pile_mean_m,pile_centre_m,pile_max_m,rock_in_place_m,broken_"
                "rock_m,broken_rock_length_m");
  for (size_t i = 0; i < p.x.size(); ++i) {
    csv.row({p.x[i], p.before[i], p.mean[i], p.centre[i], p.highest[i], p.rock_in_place[i],
             p.pile[i], p.pile_length[i]});
  }
}

nlohmann::ordered_json pile_keys(const PileShape& shape, const Throw& thrown,
                                 const FaceSpeed& face_speed, double cell) {
  nlohmann::ordered_json keys;
  keys["face_velocity_m_s"] = face_speed.peak;
  keys["face_velocity_mean_m_s"] = face_speed.mean;
  keys["throw_cg_m"] = thrown.centre_of_mass;
  keys["throw_max_m"] = thrown.largest;
  keys["cast_fraction"] = thrown.cast_fraction;
  keys["pile_height_m"] = shape.height;
  keys["pile_height_x_m"] = shape.height_x;
  keys["pile_toe_m"] = shape.toe;
  keys["pile_toe_98_m"] = shape.toe_98;
  keys["swell_factor"] = shape.swell;
  keys["pile_bulk_volume_m3"] = shape.bulk_volume;
  keys["pile_solid_volume_m3"] = shape.solid_volume;
  keys["repose_angle_deg"] = degrees(shape.rest_angle);
  keys["front_slope_deg"] = degrees(shape.front_angle);
  keys["profile_cell_m"] = cell;
  return keys;
}

std::vector<Vec2> line_over(const std::vector<double>& x, const std::vector<double>& z) {
  std::vector<Vec2> points;
  for (size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], z[i]);
  return points;
}

// Through the middle of the row if a hole is there, else through the hole next to it.
double y_of_hole(const ResultFolder& folder) {
  const bool even = folder.scene_has("holes") && std::lround(folder.scene_number("holes")) % 2 == 0;
  return even ? 0.5 * folder.scene_number("spacing_m") : 0.0;
}

std::string title_of(const ResultFolder& folder) {
  std::string title = "Muck pile: bench " + spelled(folder.scene_number("bench_height_m")) +
                      " m, burden " + spelled(folder.scene_number("burden_m")) + " m";
  if (folder.scene_has("spacing_m"))
    title += ", spacing " + spelled(folder.scene_number("spacing_m")) + " m";
  return title;
}

std::string subtitle_of(const PileShape& s, const Throw& t, double face_speed) {
  const struct {
    const char *name, *unit;
    double value;
  } facts[] = {{"throw of the mass centre ", " m", t.centre_of_mass},
               {"height ", " m", s.height},
               {"toe ", " m", s.toe},
               {"swell ", "", s.swell},
               {"rest angle ", "°", degrees(s.rest_angle)},
               {"face ", " m/s", face_speed}};
  std::string text;
  for (const auto& [name, unit, value] : facts) {
    if (std::isnan(value)) continue;
    text += (text.empty() ? "" : " · ") + (name + spelled(value)) + unit;
  }
  return text;
}

// Shows the pile to a fifth beyond its toe; a few blocks that flew farther would shrink all the
// rest.
SectionPlot section_of(const ResultFolder& folder, const RunData& run, const PileProfile& p,
                       const PileShape& shape, const Hole& hole, const SectionOptions& options) {
  const double y = options.y.value_or(y_of_hole(folder));
  const double reach =
      std::isnan(shape.toe) ? -hole.x : std::max(1.2 * std::max(shape.toe, shape.toe_98), -hole.x);
  const Extent before = extent_of(run.blocks, start_snapshot(run.blocks).states);
  const double top = std::max(hole.top, *std::ranges::max_element(p.mean));
  SectionPlot plot{title_of(folder),
                   "",
                   "distance from the free face, along the throw [m]",
                   {before.low.x() - 1.0, reach + 1.0},
                   {before.low.z() - 0.5, top + 0.12 * hole.top},
                   section_at(y, run.blocks, run.last.states),
                   run.moved,
                   block_colours(options.colour_by, run.blocks, run.last),
                   {},
                   {},
                   ""};
  plot.lines = {
      {line_over(p.x, p.before), kBench, 2.5, true, "bench before"},
      {line_over(p.x, p.mean), kSignal, 3.0, false, "surface after, mean over the width"}};
  plot.bars = {{{hole.x - hole.radius, hole.charge_bottom},
                {hole.x + hole.radius, hole.charge_top},
                kSignal,
                "charge before"},
               {{hole.x - hole.radius, hole.charge_top},
                {hole.x + hole.radius, hole.top},
                kGrey,
                "stemming before"}};
  const auto beyond = std::ranges::count_if(
      run.last.states, [&](const BlockState& s) { return s.centre.x() > plot.x.high; });
  plot.note = section_note(y, run.last.time);
  if (beyond > 0) {
    plot.note += "; " + std::to_string(beyond) + (beyond == 1 ? " block lies" : " blocks lie") +
                 " beyond the picture";
  }
  return plot;
}

}  // namespace

void report_profile(const ResultFolder& folder, const MeasureOptions& measure,
                    const SectionOptions& section) {
  if (folder.scene_word("case") == "crater") {
    throw InputError("profile: the run must be a bench, got 'crater'; use the sub-command crater");
  }
  const RunData run(folder, measure);
  const Hole hole = hole_of(folder);
  const FaceSpeed face_speed = face_speed_of(folder, run.blocks, hole);
  const PileProfile profile = pile_profile(run.blocks, run.last, run.moved, run.cell, run.lies);
  const PileShape shape = pile_shape(profile, -hole.x, mean_block_size(run.blocks, run.moved));
  const Throw thrown = throw_of(run.blocks, run.last, -hole.x);
  write_profile(profile, folder.file("profile.csv"));
  SectionPlot plot = section_of(folder, run, profile, shape, hole, section);
  plot.subtitle = subtitle_of(shape, thrown, face_speed.peak);
  write_png(draw_section(std::move(plot)), folder.file("profile.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(pile_keys(shape, thrown, face_speed, run.cell));
  keys["blocks_on_the_move"] = std::ranges::count(run.lies, 0);
  folder.merge_into_summary(keys);
}

}  // namespace muckpile
