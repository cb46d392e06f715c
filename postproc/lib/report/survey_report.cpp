// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command survey: the surface of a run at its end against a surveyed one.
// Scope: runs at rest; the user says how the survey lies in the run's coordinates.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "args/input_error.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "measure/height_map.h"
#include "measure/start_extent.h"
#include "measure/surface_comparison.h"
#include "measure/survey_heights.h"
#include "report/bench_scene.h"
#include "report/not_measurable.h"
#include "report/notes.h"
#include "report/reports.h"
#include "report/run_data.h"
#include "report/survey_plot.h"

namespace muckpile {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kAxisNames[] = {"x", "y", "z"};

// Columns over the run's rock, and over its floor as far along the throw as the survey goes, but
// half as far again as the rock at most: beyond it other things lie in a pit.
ColumnGrid grid_of(const RunData& run, const Extent& survey, const std::string& scene) {
  constexpr double kFarther = 1.5, kFloorCells = 2.0;
  ColumnGrid grid = plan_grid(run.blocks, run.last, run.lies, run.cell);
  if (scene != "bench" && scene != "heap") return grid;
  const double rock = grid.x0 + grid.nx * grid.dx;
  const double end =
      std::max(rock + kFloorCells * grid.dx, std::min(survey.high.x(), kFarther * rock));
  grid.nx = static_cast<int>(std::lround((end - grid.x0) / grid.dx));
  return grid;
}

// What the run has at its end over the grid.
struct RunSurface {
  std::vector<double> heights;  // [m], NaN where there is neither rock nor a floor
  std::vector<char> rock;       // above the floor
  std::vector<char> pile;       // whose top was broken out
};

// Behind the face of a bench its neighbour goes on where the model ends: no floor there.
bool beside_the_model(double x, double y, const Extent& start) {
  return x < 0.0 && (x < start.low.x() || y < start.low.y() || y > start.high.y());
}

// Where there is no rock, there is the floor, or the free surface at z = 0, but for a scene of
// one's own. Rock lies above a floor; a crater reaches below its surface.
RunSurface surface_of(const RunData& run, const ColumnGrid& grid, const std::string& scene) {
  const Columns columns = columns_through(grid, run.blocks, run.last.states, run.lies);
  const Extent start = extent_at_start(run.blocks);
  const bool on_floor = scene == "bench" || scene == "heap";
  const auto without_rock = [&](size_t k) {
    const auto columns_x = static_cast<size_t>(grid.nx);
    const double x = grid.x(static_cast<int>(k % columns_x));
    const double y = grid.y(static_cast<int>(k / columns_x));
    const bool unknown = scene == "other" || (scene == "bench" && beside_the_model(x, y, start));
    return unknown ? kNaN : run.floor.at(x, y);
  };
  const std::vector<double> floor = run.floor.under(grid);
  RunSurface surface;
  for (size_t k = 0; k < grid.cells(); ++k) {
    const bool known = columns.top_block[k] >= 0;
    double height = known ? columns.top[k] : without_rock(k);
    if (on_floor) height = std::max(height, floor[k]);
    const bool rock = known && !(on_floor && height <= floor[k]);
    surface.heights.push_back(height);
    surface.rock.push_back(rock ? 1 : 0);
    surface.pile.push_back(rock && run.moved[static_cast<size_t>(columns.top_block[k])] != 0 ? 1
                                                                                             : 0);
  }
  return surface;
}

std::string range_text(const Extent& e) {
  std::string text;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    text += std::string(axis == 0 ? "" : ", ") + kAxisNames[axis] + " " + spelled(e.low[axis], 7) +
            " to " + spelled(e.high[axis], 7);
  return text + " m";
}

// Whole metres; a start for whoever has no better.
std::string shift_text(const Vec3& shift) {
  std::ostringstream text;
  text << "--shift";
  for (const double each : shift) text << ' ' << std::lround(each);
  return text.str();
}

// The middle of the one onto that of the other, the lowest onto the lowest.
Vec3 shift_between(const Extent& survey, const Extent& run, const SurveyPose& pose) {
  const auto base = [](const Extent& e) {
    Vec3 place = 0.5 * (e.low + e.high);
    place.z() = e.low.z();
    return place;
  };
  const Vec3 in_file = Eigen::AngleAxisd(-pose.turn, Vec3::UnitZ()) * base(survey) - pose.shift;
  return pose.shift_to(in_file, base(run));
}

constexpr double kFarthest = 500.0;  // [m]; no bench or heap is as high

// `margin` [m] in height, as a survey may stand over the run's rock all over.
void require_overlap(const std::string& file, const SurveyedSurface& surface, const Extent& run,
                     const SurveyPose& pose, double margin) {
  // Of a whole pit a part may lie at the run's height; else numbers for no data do not count.
  const bool meets = has_height_between(surface, run.low.z() - margin, run.high.z() + margin);
  const Extent survey = extent_of_most(surface, kFarthest);
  const Extent reached = meets ? extent_of(surface) : survey;
  const Vec3 room(0.0, 0.0, margin);
  const bool apart = ((reached.low - room).array() > run.high.array()).any() ||
                     ((reached.high + room).array() < run.low.array()).any();
  if (!apart) return;
  refuse(file,
         "does not overlap the run: after --unit, --shift and --turn it spans " +
             range_text(survey) + ", the run " + range_text(run) +
             "; bring it into the run's coordinates (of a bench: toe of the face at x = 0, z = 0, "
             "throw along +x), for a start by " +
             shift_text(shift_between(survey, run, pose)));
}

// Grids often hold a number such as -9999 where nothing was surveyed.
void require_heights(const std::string& file, const SurfacePair& pair) {
  for (size_t k = 0; k < pair.grid.cells(); ++k) {
    if (pair.compared[k] == 0 || std::abs(pair.survey[k] - pair.run[k]) <= kFarthest) continue;
    const auto columns_x = static_cast<size_t>(pair.grid.nx);
    refuse(file, "has the height " + spelled(pair.survey[k], 6) +
                     " m at x = " + spelled(pair.grid.x(static_cast<int>(k % columns_x))) +
                     ", y = " + spelled(pair.grid.y(static_cast<int>(k / columns_x))) +
                     " m, where the run's is " + spelled(pair.run[k]) +
                     " m; leave out points that stand for no data");
  }
}

struct Comparison {
  SurfacePair pair;
  double pile_share = 0.0;  // of the pile's plan that has a surveyed height
};

Comparison compared(const RunData& run, const RunSurface& surface, const ColumnGrid& grid,
                    std::vector<double> heights) {
  Comparison c{{grid, surface.heights, std::move(heights), {}}, 0.0};
  double pile = 0.0, known_pile = 0.0;
  const double least = 0.5 * run.block_size;  // a surveyed floor is never quite level
  const std::vector<double> floor = run.floor.under(grid);
  for (size_t k = 0; k < grid.cells(); ++k) {
    const double survey = c.pair.survey[k];
    const bool known = !std::isnan(survey) && !std::isnan(surface.heights[k]);
    const bool any = known && (surface.rock[k] != 0 || std::abs(survey - floor[k]) > least);
    c.pair.compared.push_back(any ? 1 : 0);
    pile += surface.pile[k];
    if (known) known_pile += surface.pile[k];
  }
  c.pile_share = pile > 0.0 ? known_pile / pile : kNaN;
  return c;
}

// How the mean profiles are measured: of a bench and a heap only.
struct ProfileFrame {
  bool any = false;
  BenchPlanes planes;
  double depth = 0.0;  // highest rock is looked for from there on, behind the toe [m]
};

ProfileFrame profile_frame(const ResultFolder& folder, const RunData& run) {
  const std::string scene = folder.scene_word("case");
  if (scene == "heap") return {true, bounded_by_rock({}, run.blocks), 0.0};
  if (scene != "bench" || !run.floor.level()) return {};
  try {
    const BenchScene bench = bench_scene(folder, run.blocks);
    if (bench.planes.frames != nullptr) return {};
    // The wall behind the last row is never quite sharp in a survey.
    return {true, bounded_by_rock(bench.planes, run.blocks), bench.depth - run.block_size};
  } catch (const NotMeasurable&) {
    return {};
  }
}

struct Shapes {
  ProfilePair profiles;
  PileShape run = PileShape::none(), survey = PileShape::none();
};

Shapes shapes_of(const SurfacePair& pair, const ProfileFrame& frame, double block_size) {
  Shapes shapes;
  if (!frame.any) return shapes;
  shapes.profiles = profiles_of(pair, frame.planes);
  const ProfilePair& p = shapes.profiles;
  shapes.run = shape_of_profile(p.x, p.run, p.dx, frame.depth, block_size);
  shapes.survey = shape_of_profile(p.x, p.survey, p.dx, frame.depth, block_size);
  return shapes;
}

void write_table(const SurfacePair& pair, const ResultFolder& folder) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("survey.csv"),
                with_mine_columns("x_m,y_m,run_m,survey_m,difference_m", frame));
  for (int j = 0; j < pair.grid.ny; ++j) {
    for (int i = 0; i < pair.grid.nx; ++i) {
      const size_t k = pair.grid.at(i, j);
      if (pair.compared[k] == 0) continue;
      csv.row_at({pair.grid.x(i), pair.grid.y(j), pair.run[k], pair.survey[k],
                  pair.run[k] - pair.survey[k]},
                 mine_place(frame, pair.grid.x(i), pair.grid.y(j)));
    }
  }
}

nlohmann::ordered_json keys_of(const SurveyOptions& options, const SurfaceDifference& d,
                               const SurfaceDistance& distance, const Shapes& shapes,
                               double pile_share) {
  nlohmann::ordered_json keys;
  keys["survey_file"] = std::filesystem::path(options.surface).filename().string();
  for (size_t axis = 0; axis < 3; ++axis)
    keys[std::string("survey_shift_") + kAxisNames[axis] + "_m"] = options.shift.at(axis);
  keys["survey_turn_deg"] = options.turn_deg;
  keys["survey_compared_area_m2"] = d.area;
  keys["survey_compared_pile_fraction"] = pile_share;
  keys["survey_run_above_m3"] = d.above;
  keys["survey_run_below_m3"] = d.below;
  keys["survey_volume_difference_m3"] = d.above - d.below;
  keys["survey_mean_difference_m"] = d.mean;
  keys["survey_rms_difference_m"] = d.rms;
  keys["survey_p90_difference_m"] = d.p90;
  keys["survey_mean_distance_m"] = distance.mean;
  keys["survey_rms_distance_m"] = distance.rms;
  keys["survey_p90_distance_m"] = distance.p90;
  keys["survey_height_m"] = shapes.survey.height;
  keys["survey_run_height_m"] = shapes.run.height;
  keys["survey_toe_m"] = shapes.survey.toe;
  keys["survey_run_toe_m"] = shapes.run.toe;
  return keys;
}

void require_rest(const ResultFolder& folder, const RunData& run, const SurveyOptions& options) {
  if (run.still) return;
  const NotMeasurable why("survey: the run has not come to rest, so it has no pile to compare");
  take_back(folder, "survey", keys_of(options, {}, {}, {}, kNaN), why);
  throw why;
}

Extent extent_of_heights(const ColumnGrid& grid, const std::vector<double>& heights) {
  Extent e{{grid.x0, grid.y0, 1e300},
           {grid.x0 + grid.nx * grid.dx, grid.y0 + grid.ny * grid.dy, -1e300}};
  for (const double height : heights) {
    e.low.z() = std::fmin(e.low.z(), height);
    e.high.z() = std::fmax(e.high.z(), height);
  }
  return e;
}

}  // namespace

void report_survey(const ResultFolder& folder, const MeasureOptions& measure,
                   const SurveyOptions& options) {
  const SurveyPose pose{{options.shift[0], options.shift[1], options.shift[2]},
                        options.turn_deg * std::numbers::pi / 180.0};
  const SurveyedSurface survey = placed(read_survey(options.surface, options.unit), pose);
  const RunData run(folder, measure);
  require_rest(folder, run, options);
  const std::string scene = folder.scene_word("case");
  const ColumnGrid grid = grid_of(run, extent_of(survey), scene);
  const RunSurface surface = surface_of(run, grid, scene);
  require_overlap(options.surface, survey, extent_of_heights(grid, surface.heights), pose,
                  run.block_size);
  const Comparison c = compared(run, surface, grid, heights_over(grid, survey, options.gap));
  if (std::ranges::count(c.pair.compared, 1) == 0)
    refuse(options.surface,
           "has no height over the run's rock, though their boxes overlap; see --shift, --turn and "
           "--gap");
  require_heights(options.surface, c.pair);
  const Shapes shapes = shapes_of(c.pair, profile_frame(folder, run), run.block_size);
  const SurfaceDifference difference = difference_of(c.pair);
  write_table(c.pair, folder);
  write_png(draw_survey(c.pair, shapes.profiles, difference), folder.file("survey.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(keys_of(options, difference, distance_of(c.pair), shapes, c.pile_share));
  folder.merge_into_summary(keys, {refusal_key("survey")});
}

}  // namespace muckpile
