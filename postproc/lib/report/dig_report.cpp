// SPDX-License-Identifier: GPL-2.0-or-later
// Dilution and ore loss of a dig line.
// Scope: see the header.
#include "report/dig_report.h"

#include <cmath>
#include <limits>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "measure/dig_line.h"
#include "measure/ore_shares.h"
#include "report/notes.h"

namespace muckpile {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTonne = 1000.0;  // [kg]

// The user's own lines must not be taken away as what an earlier call has left.
void refuse_result(const std::string& file, const std::filesystem::path& result) {
  std::error_code none;
  if (!file.empty() && std::filesystem::equivalent(file, result, none))
    refuse("movement: --dig", "must not be " + result.string() + ", where the result goes");
}

std::vector<OreCell> cells_of(const MovementOptions& options) {
  const CsvTable table = CsvTable::read(options.model);
  const size_t x = table.column("x_m"), y = table.column("y_m"), z = table.column("z_m"),
               grade = table.column(options.ore_column);
  std::vector<OreCell> cells;
  for (size_t row = 0; row < table.rows(); ++row)
    cells.push_back({{table.number(row, x), table.number(row, y), table.number(row, z)},
                     table.number(row, grade) >= options.cutoff});
  if (cells.empty()) refuse(options.model, "has no row");
  return cells;
}

std::vector<double> ore_shares(const RunData& run, const MovementOptions& options,
                               const std::vector<OrePolygon>& ore, const SurveyPose& pose) {
  if (!options.ore_column.empty()) {
    if (options.model.empty())
      refuse("movement: --ore-column", "needs --model, the block model that has it");
    return ore_of_cells(cells_of(options), pose, run.blocks);
  }
  if (ore.empty())
    refuse("movement: --dig", "needs ore: --polygons, or --model with --ore-column and --cutoff");
  return ore_in_polygons(ore, run.blocks);
}

void write_table(const std::filesystem::path& path, const std::vector<OrePolygon>& lines,
                 const DigResult& dug) {
  CsvWriter table(path,
                  "polygon,z_low_m,z_high_m,dug_t,ore_t,waste_t,dilution_fraction,"
                  "ore_recovered_fraction,ore_loss_t,ore_loss_fraction");
  const auto level = [](double z) { return std::isfinite(z) ? z : kNaN; };
  const auto row = [&](const std::string& name, double low, double high, const DugRock& rock,
                       double loss, double loss_share) {
    table.row(name, {level(low), level(high), rock.rock / kTonne, rock.ore / kTonne,
                     (rock.rock - rock.ore) / kTonne, rock.dilution(), rock.ore / dug.ore, loss,
                     loss_share});
  };
  for (size_t k = 0; k < lines.size(); ++k)
    row(lines[k].name, lines[k].low, lines[k].high, dug.of_polygon[k], kNaN, kNaN);
  row("all", kNaN, kNaN, dug.all, dug.loss() / kTonne, dug.loss_share());
}

PlotCurve outline_of(const OrePolygon& line, int colour) {
  PlotCurve outline{line.name, CurveStyle::kLine, colour, line.corners};
  outline.points.push_back(line.corners.front());
  return outline;
}

// The broken-out rock from above: what is ore and lost shows outside of the lines, waste within.
CurvePlot plot_of(const std::vector<OrePolygon>& lines, const RunData& run,
                  const std::vector<double>& ore, const DigResult& dug) {
  constexpr double kHalf = 0.5;
  PlotCurve waste{"blocks of waste", CurveStyle::kPoints, 7, {}},
      of_ore{"blocks of ore", CurveStyle::kPoints, 1, {}};
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    if (run.moved[b] == 0) continue;
    (ore[b] > kHalf ? of_ore : waste).points.emplace_back(run.last.states[b].centre.head<2>());
  }
  CurvePlot plot;
  plot.title = "Dig line: dilution " + spelled(100.0 * dug.all.dilution()) + " %, ore loss " +
               spelled(100.0 * dug.loss_share()) + " %";
  plot.x_label = "x, along the throw [m]";
  plot.y_label = "y [m]";
  plot.warning = motion_warning(run.still);
  plot.curves = {waste, of_ore};
  int colour = 2;  // of the next line
  for (const OrePolygon& line : lines) plot.curves.push_back(outline_of(line, colour++));
  return plot;
}

nlohmann::ordered_json keys_of(const DigResult& dug) {
  nlohmann::ordered_json keys;
  keys["dig_rock_t"] = dug.all.rock / kTonne;
  keys["dig_ore_t"] = dug.all.ore / kTonne;
  keys["dig_dilution_fraction"] = dug.all.dilution();
  keys["dig_ore_before_t"] = dug.ore / kTonne;
  keys["dig_ore_unbroken_t"] = dug.ore_unbroken / kTonne;
  keys["dig_ore_loss_t"] = dug.loss() / kTonne;
  keys["dig_ore_loss_fraction"] = dug.loss_share();
  return keys;
}

}  // namespace

const std::vector<std::string>& dig_keys() {
  static const std::vector<std::string> names = [] {
    const nlohmann::ordered_json keys = keys_of({});
    std::vector<std::string> all;
    for (const auto& [key, value] : keys.items()) all.push_back(key);
    return all;
  }();
  return names;
}

nlohmann::ordered_json write_dig(const ResultFolder& folder, const RunData& run,
                                 const MovementOptions& options, const std::vector<OrePolygon>& ore,
                                 const SurveyPose& pose) {
  refuse_result(options.dig, folder.file("dig.csv"));
  for (const char* name : {"dig.csv", "dig.png"}) std::filesystem::remove(folder.file(name));
  if (options.dig.empty()) return nlohmann::ordered_json::object();
  const std::vector<OrePolygon> in_file = read_ore_polygons(options.dig);
  std::vector<OrePolygon> lines;
  for (const OrePolygon& line : in_file) lines.push_back(placed(line, pose));
  const std::vector<double> shares = ore_shares(run, options, ore, pose);
  const DigResult dug = dig(lines, run.blocks, run.last, run.moved, shares);
  if (!(dug.ore > 0.0)) refuse("movement: --dig", "no block of the run is ore");
  if (!(dug.all.rock > 0.0))
    refuse(
        options.dig,
        "no rock lies in its polygons after the blast; see their place (--shift, --turn, --mine) "
        "and heights");
  write_table(folder.file("dig.csv"), in_file, dug);
  write_png(draw_curves(plot_of(lines, run, shares, dug)), folder.file("dig.png"));
  return keys_of(dug);
}

}  // namespace muckpile
