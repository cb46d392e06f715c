// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command rows: throw, velocity and moved volume of each hole and row, velocity of the face in
// front of each hole of the first row.
// Scope: benches that profile measures, with a hole table.
#include <algorithm>
#include <cmath>

#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "io/pattern_charges.h"
#include "measure/hole_rock.h"
#include "report/bench_scene.h"
#include "report/degrees.h"
#include "report/face_bands.h"
#include "report/hole_outlines.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "report/rows_of_run.h"
#include "report/run_data.h"

namespace muckpile {
namespace {

// A hole, a row, or all: a line of rows.csv.
struct Line {
  std::string name;
  double row = std::nan("");                  // counted from 1; NaN for all
  double x = std::nan(""), y = std::nan("");  // of the hole at the floor [m]
  double fires = std::nan("");                // [s]
  double charge = 0.0;                        // [kg]
  std::vector<size_t> chosen;
  CastRock rock{};
};

struct Rows {
  std::vector<PatternHole> holes;
  std::vector<Line> lines;
  std::vector<FaceBand> bands;
};

Line line_of(const PatternHole& hole) {
  return {hole.name,
          static_cast<double>(hole.row + 1),
          hole.foot.x(),
          hole.foot.y(),
          hole.firing_time,
          hole.charge,
          {},
          {}};
}

// Several holes as one: rocks and charges together, the first firing.
Line together(const std::string& name, double row, const std::vector<Line>& holes) {
  Line all{name, row, 0.0, std::nan(""), holes.front().fires, 0.0, {}, {}};
  for (const Line& hole : holes) {
    all.x += hole.x / static_cast<double>(holes.size());
    all.fires = std::min(all.fires, hole.fires);
    all.charge += hole.charge;
    all.chosen.insert(all.chosen.end(), hole.chosen.begin(), hole.chosen.end());
  }
  return all;
}

std::vector<Line> lines_of(const std::vector<PatternHole>& holes, const std::vector<int>& owner) {
  std::vector<Line> single;
  for (const PatternHole& hole : holes) single.push_back(line_of(hole));
  for (size_t b = 0; b < owner.size(); ++b) {
    if (owner[b] >= 0) single[static_cast<size_t>(owner[b])].chosen.push_back(b);
  }
  std::vector<Line> lines = single;
  for (int row = 0; row <= holes.back().row; ++row) {
    std::vector<Line> of_row;
    std::ranges::copy_if(single, std::back_inserter(of_row),
                         [&](const Line& line) { return line.row == row + 1; });
    lines.push_back(together("row " + std::to_string(row + 1), row + 1, of_row));
  }
  lines.push_back(together("all", std::nan(""), single));
  return lines;
}

std::vector<FaceBand> bands_of(const RunData& run, const BenchScene& bench,
                               const std::vector<PatternHole>& holes,
                               const std::vector<int>& owner) {
  std::vector<FaceBand> bands;
  const double step = bench.height / kFaceBands;
  const std::vector<std::vector<size_t>> layers =
      face_bands(run.blocks, bench.burden, bench.height, kFaceBands, bench.planes);
  const auto add = [&](const std::string& name, auto&& belongs) {
    for (int k = 0; k < kFaceBands; ++k) {
      FaceBand band{name, k * step, (k + 1) * step, {}};
      for (const size_t b : layers[static_cast<size_t>(k)])
        if (belongs(owner[b])) band.layer.push_back(b);
      bands.push_back(std::move(band));
    }
  };
  add("all", [](int) { return true; });
  for (size_t h = 0; h < holes.size() && holes[h].row == 0; ++h)
    add(holes[h].name, [&](int hole) { return hole == static_cast<int>(h); });
  return bands;
}

void add_velocities(Rows& rows, const ResultFolder& folder, const RunData& run,
                    const BenchPlanes& planes) {
  std::vector<char> wanted(run.blocks.size(), 0);
  for (const Line& line : rows.lines)
    for (const size_t b : line.chosen) wanted[b] = 1;
  for (const FaceBand& band : rows.bands)
    for (const size_t b : band.layer) wanted[b] = 1;
  RowsOfRun reader(run, wanted);
  for (const auto& path : folder.snapshots()) {
    const Snapshot& now = reader.read(path);
    for (Line& line : rows.lines) add_velocity(line.rock, line.chosen, run.blocks, now, planes);
    for (FaceBand& band : rows.bands) add_velocity(band, run.blocks, now, planes);
  }
}

Rows rows_of(const ResultFolder& folder, const RunData& run, const BenchScene& bench) {
  const HoleTable table = hole_table_of(folder);
  std::vector<double> masses;
  for (const TimedCharge& charge : charges_of_decks(folder, table)) masses.push_back(charge.mass);
  Rows rows;
  rows.holes = pattern_holes(table, masses, bench.burden);
  if (bench.planes.frames != nullptr) number_rows(rows.holes, *bench.planes.frames);
  const std::vector<int> owner = hole_of_blocks(run.blocks, rows.holes, bench.planes);
  rows.lines = lines_of(rows.holes, owner);
  for (Line& line : rows.lines)
    line.rock = cast_rock(line.chosen, run.blocks, run.last, run.moved, bench.planes);
  rows.bands = bands_of(run, bench, rows.holes, owner);
  add_velocities(rows, folder, run, bench.planes);
  return rows;
}

// NaN for a hole without a block [kg/m3].
double specific_charge(const Line& line) {
  return line.rock.volume > 0.0 ? line.charge / line.rock.volume : std::nan("");
}

// Of each hole, from +x towards +y [deg]; NaN for several together.
double turn_of(const std::string& name, const HoleFrames& frames) {
  const auto own = std::ranges::find(frames.holes(), name, &HoleFrame::name);
  if (own == frames.holes().end()) return std::nan("");
  return degrees(std::atan2(own->direction.y(), own->direction.x()));
}

void write_tables(const Rows& rows, const ResultFolder& folder, const BenchPlanes& planes) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(
      folder.file("rows.csv"),
      with_mine_columns("hole,row,x_m,y_m,fires_s,charge_kg,blocks,volume_m3,mass_kg,"
                        "specific_charge_kg_m3,moved_volume_m3,throw_m,velocity_m_s,velocity_at_s" +
                            std::string(planes.frames != nullptr ? ",throw_turn_deg" : ""),
                        frame));
  for (const Line& line : rows.lines) {
    const CastRock& rock = line.rock;
    const double x = std::isnan(line.y) ? line.y : line.x;  // a row has no one place
    std::vector<double> row{line.row,          line.x,          line.y,
                            line.fires,        line.charge,     static_cast<double>(rock.blocks),
                            rock.volume,       rock.mass,       specific_charge(line),
                            rock.moved_volume, rock.throw_mean, rock.velocity,
                            rock.velocity_time};
    if (planes.frames != nullptr) row.push_back(turn_of(line.name, *planes.frames));
    csv.row_at(line.name, row, mine_place(frame, x, line.y));
  }
}

// The rock of several holes together; NaN for none.
class HoleMean {
 public:
  void add(const CastRock& rock) {
    mass_ += rock.mass;
    moment_ += rock.mass * rock.throw_mean;
    volume_ += rock.volume;
    moved_ += rock.moved_volume;
  }
  [[nodiscard]] double throw_mean() const { return moment_ / mass_; }
  [[nodiscard]] double moved() const { return moved_ / volume_; }  // share of the volume

 private:
  double mass_ = 0.0, moment_ = 0.0, volume_ = 0.0, moved_ = 0.0;
};

// The holes at the ends of rows of three or more, and those between them.
nlohmann::ordered_json keys_of_ends(const Rows& rows) {
  const auto of_row = [&](int row) {
    return std::ranges::count(rows.holes, row, &PatternHole::row);
  };
  HoleMean ends, inner;
  for (size_t h = 0; h < rows.holes.size(); ++h) {
    const int row = rows.holes[h].row;
    if (of_row(row) < 3 || rows.lines[h].rock.blocks == 0) continue;
    const bool first = h == 0 || rows.holes[h - 1].row != row;
    const bool last = h + 1 == rows.holes.size() || rows.holes[h + 1].row != row;
    (first || last ? ends : inner).add(rows.lines[h].rock);
  }
  nlohmann::ordered_json keys;
  keys["end_holes_throw_m"] = ends.throw_mean();
  keys["inner_holes_throw_m"] = inner.throw_mean();
  keys["end_to_inner_throw"] = ends.throw_mean() / inner.throw_mean();
  keys["end_holes_moved_fraction"] = ends.moved();
  keys["inner_holes_moved_fraction"] = inner.moved();
  keys["end_to_inner_moved"] = ends.moved() / inner.moved();
  return keys;
}

nlohmann::ordered_json keys_of(const Rows& rows) {
  nlohmann::ordered_json keys;
  const size_t holes = rows.holes.size();
  const auto line = [&](size_t k) { return k < rows.lines.size() ? rows.lines[k] : Line{}; };
  const Line front = line(holes), last = line(rows.lines.size() - 2),
             all = line(rows.lines.size() - 1);
  double least = std::nan(""), most = std::nan("");
  for (size_t h = 0; h < holes; ++h) {
    least = std::fmin(least, rows.lines[h].rock.throw_mean);
    most = std::fmax(most, rows.lines[h].rock.throw_mean);
  }
  keys["rows"] = holes > 0 ? rows.holes.back().row + 1 : 0;
  keys["blast_charge_kg"] = all.charge;
  keys["blast_volume_m3"] = all.rock.volume;
  keys["blast_moved_volume_m3"] = all.rock.moved_volume;
  keys["blast_specific_charge_kg_m3"] = specific_charge(all);
  keys["blast_throw_m"] = all.rock.throw_mean;
  keys["front_row_throw_m"] = front.rock.throw_mean;
  keys["last_row_throw_m"] = last.rock.throw_mean;
  keys["hole_throw_least_m"] = least;
  keys["hole_throw_most_m"] = most;
  keys["front_row_velocity_m_s"] = front.rock.velocity;
  keys["last_row_velocity_m_s"] = last.rock.velocity;
  keys.update(keys_of_ends(rows));
  return keys;
}

BenchScene bench_or_nothing(const ResultFolder& folder, const RunData& run) {
  try {
    return bench_or_take_back(folder, run.blocks, "rows", keys_of({}));
  } catch (const NotMeasurable&) {
    remove_face_bands(folder);
    std::filesystem::remove(folder.file("hole_polygons.csv"));
    throw;
  }
}

}  // namespace

void report_rows(const ResultFolder& folder, const MeasureOptions& measure) {
  if (!std::filesystem::exists(folder.dump("holes.csv")))
    refuse_to_measure(folder, "rows", "needs the run's hole table, dump/holes.csv");
  const RunData run(folder, measure);
  const BenchScene bench = bench_or_nothing(folder, run);
  const Rows rows = rows_of(folder, run, bench);
  write_tables(rows, folder, bench.planes);
  write_hole_outlines(folder, hole_outlines(folder, bench, run.blocks), 0.5 * bench.height);
  write_face_bands(folder, rows.bands, run.still);
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(keys_of(rows));
  folder.merge_into_summary(keys, {refusal_key("rows")});
}

}  // namespace muckpile
