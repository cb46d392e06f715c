// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command energy: where the energy of the run is and where it went, over time.
// Scope: what fix muckpile/progress wrote of fix muckpile/ledger into history.csv, and of the audit
// of the explosive's energy into run.json.
#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "draw/share_bar.h"
#include "io/csv_writer.h"
#include "io/energy_history.h"
#include "report/energy_audit.h"
#include "report/hole_audit.h"
#include "report/notes.h"
#include "report/reports.h"

namespace muckpile {
namespace {

constexpr int kColours = 8;  // of colour_of_curve; they begin again, dashed

struct EnergyUnit {
  double size;  // [J]
  const char* name;
};

/// The largest unit of which the largest energy has at least one.
EnergyUnit unit_for(double largest) {
  for (const EnergyUnit unit :
       {EnergyUnit{1e9, "GJ"}, EnergyUnit{1e6, "MJ"}, EnergyUnit{1e3, "kJ"}}) {
    if (largest >= unit.size) return unit;
  }
  return {1.0, "J"};
}

EnergyHistory whole_blast(const ResultFolder& folder) {
  EnergyHistory history = read_energies(folder.dump("history.csv"));
  for (EnergyGroup& group : history.groups) {
    for (double& energy : group.energy) energy *= folder.symmetry();
  }
  return history;
}

double largest_of(const EnergyHistory& history) {
  double largest = 0.0;
  for (const EnergyGroup& group : history.groups) {
    for (const double energy : group.energy) largest = std::max(largest, std::abs(energy));
  }
  return largest;
}

/// The wave takes milliseconds and the throw seconds, so time is logarithmic; row 0 is at time 0.
CurvePlot plot_of(const EnergyHistory& history) {
  const EnergyUnit unit = unit_for(largest_of(history));
  CurvePlot plot;
  plot.title = "Energy of the run";
  plot.x_label = "time [s]";
  plot.y_label = std::string("energy [") + unit.name + "]";
  plot.x_scale = Scale::kLogarithmic;
  const auto add = [&](const std::string& name, const std::vector<double>& energy) {
    const int number = static_cast<int>(plot.curves.size());
    PlotCurve curve{
        name, number < kColours ? CurveStyle::kLine : CurveStyle::kDashed, number % kColours, {}};
    for (size_t row = 0; row < energy.size(); ++row) {
      if (history.time[row] > 0.0)
        curve.points.emplace_back(history.time[row], energy[row] / unit.size);
    }
    plot.curves.push_back(std::move(curve));
  };
  for (const EnergyGroup& group : history.groups) {
    const bool any = std::ranges::any_of(group.energy, [](double e) { return e != 0.0; });
    if (any) add(group.name, group.energy);
  }
  add("missing", history.missing());
  return plot;
}

// Of a group in energy.csv.
std::string column_of(std::string name) {
  std::erase(name, ':');
  std::ranges::replace(name, ' ', '_');
  return name + "_J";
}

// What the curves show, with the row at the start.
void write_curves(const EnergyHistory& history, const std::filesystem::path& path) {
  std::string header = "time_s";
  for (const EnergyGroup& group : history.groups) header.append(",").append(column_of(group.name));
  CsvWriter csv(path, header + ",missing_J");
  const std::vector<double> missing = history.missing();
  for (size_t row = 0; row < history.time.size(); ++row) {
    std::vector<double> values{history.time[row]};
    for (const EnergyGroup& group : history.groups) values.push_back(group.energy[row]);
    values.push_back(missing[row]);
    csv.row(values);
  }
}

std::vector<BarShare> audit_of(const ResultFolder& folder) {
  std::vector<BarShare> shares;
  for (const AuditTerm& term : energy_audit(folder)) shares.push_back({term.label, term.share});
  return shares;
}

}  // namespace

void report_energy(const ResultFolder& folder) {
  const EnergyHistory history = whole_blast(folder);
  const auto after_start = [](double time) { return time > 0.0; };
  if (std::ranges::count_if(history.time, after_start) < 2)
    throw InputError(folder.dump("history.csv").string() + ": needs two rows after time 0");
  CurvePlot plot = plot_of(history);
  plot.warning = motion_warning(folder.is_still());
  const std::vector<BarShare> audit = audit_of(folder);
  if (!audit.empty()) plot.room_below = kShareBarHeight;
  Canvas canvas = draw_curves(plot);
  if (!audit.empty())
    draw_share_bar(canvas, canvas.height() - kShareBarHeight, "Energy of the explosive", audit);
  write_png(canvas, folder.file("energy.png"));
  write_curves(history, folder.file("energy.csv"));
  write_hole_audits(folder);
  folder.merge_into_summary(common_keys(folder));
}

}  // namespace muckpile
