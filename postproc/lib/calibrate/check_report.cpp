// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command calibrate check: runs of a second blast against what was measured there.
// Scope: see the header.
#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "calibrate/calibrate_report.h"
#include "calibrate/measured.h"
#include "calibrate/site_file.h"
#include "compare/inputs_apart.h"
#include "compare/run_figures.h"
#include "draw/axes.h"
#include "io/csv_writer.h"
#include "provenance/knobs.h"
#include "sweep/spread.h"

namespace muckpile {
namespace {

void require_constants(const std::string& run, const SiteConstants& constants,
                       const std::string& site) {
  const std::filesystem::path file = std::filesystem::path(run) / "dump" / "scene.json";
  const check::Json scene = check::read_json_object(file);
  if (!scene.contains("knobs") || !scene["knobs"].is_object())
    refuse(file.string(), "has no object 'knobs': it is no scene of write_scene");
  const check::Json& knobs = scene["knobs"];
  for (const auto& [name, value] : constants) {
    std::string found = "missing";
    if (knobs.contains(name))
      found = knobs[name].is_string() ? knobs[name].get<std::string>() : knobs[name].dump();
    if (!same_value(found, value))
      refuse(file.string(), "is of a run with " + name + " '" + found + "', but " + site +
                                " has '" + value + "'; run it with -var site " + site);
  }
}

/// Their scatter counts as that of the seeds. What a site file sets is among the inputs itself.
void require_one_blast(const std::vector<std::string>& runs) {
  for (const std::string& run : runs) {
    const std::vector<std::string> apart =
        inputs_apart(runs.front(), run, {"seed", "delay_seed", "muck_seed", "site"});
    if (!apart.empty())
      refuse("calibrate check", "runs must be of one blast, with other seeds at most, but " +
                                    runs.front() + " and " + run +
                                    " differ in: " + joined(apart, "; "));
  }
}

double figure_in(const RunFigures& run, const std::string& key) {
  const auto found = run.values.find(key);
  if (found == run.values.end()) {
    std::vector<std::string> known;
    for (const auto& [name, value] : run.values) known.push_back(name);
    refuse(run.name, "has no figure '" + key + "'" + did_you_mean(key, known));
  }
  if (!found->second.is_number())
    refuse(run.name, "has no number for '" + key + "': " + found->second.dump());
  return found->second.get<double>();
}

struct CheckedFigure {
  MeasuredFigure measured;
  Spread runs;
  // Of the measure and, of several runs, of one of them: the blast is one more of those.
  [[nodiscard]] double deviation() const {
    return std::isnan(runs.deviation) ? measured.uncertainty
                                      : std::hypot(measured.uncertainty, runs.deviation);
  }
  [[nodiscard]] double off() const { return (runs.mean - measured.value) / deviation(); }
};

std::string line_of(const CheckedFigure& figure, double within) {
  std::string line = figure.measured.key + ": measured " + spelled(figure.measured.value, 4) +
                     " +- " + spelled(figure.measured.uncertainty, 2) + ", run " +
                     spelled(figure.runs.mean, 4);
  if (figure.runs.count > 1) line += " +- " + spelled(figure.runs.deviation, 2);
  line += ", off by " + spelled(figure.off(), 2) + " deviations";
  return std::abs(figure.off()) <= within ? line : line + "  DIFFERS";
}

void write_table(const std::string& path, const std::vector<CheckedFigure>& figures) {
  CsvWriter csv(path, "figure,measured,uncertainty,runs,run_mean,run_deviation,off_by_deviations");
  for (const CheckedFigure& each : figures)
    csv.row(each.measured.key,
            {each.measured.value, each.measured.uncertainty, static_cast<double>(each.runs.count),
             each.runs.mean, each.runs.deviation, each.off()});
}

}  // namespace

CheckResult check_calibration(const CheckOptions& options) {
  const std::vector<MeasuredFigure> measured = read_measured(options.measured);
  const SiteConstants constants =
      options.site.empty() ? SiteConstants{} : read_site_file(options.site);
  std::vector<RunFigures> runs;
  for (const std::string& run : options.runs) {
    require_constants(run, constants, options.site);
    runs.push_back(read_run_figures(std::filesystem::path(run) / "summary.json"));
  }
  require_one_blast(options.runs);
  std::vector<CheckedFigure> figures;
  for (const MeasuredFigure& each : measured) {
    std::vector<double> values;
    for (const RunFigures& run : runs) values.push_back(figure_in(run, each.key));
    figures.push_back({each, spread_of(values)});
  }
  if (!options.csv.empty()) write_table(options.csv, figures);
  CheckResult result{{}, true};
  double squares = 0.0;
  for (const CheckedFigure& each : figures) {
    result.lines.push_back(line_of(each, options.within));
    result.agrees = result.agrees && std::abs(each.off()) <= options.within;
    squares += each.off() * each.off();
  }
  result.lines.push_back("sum of squared deviations " + spelled(squares) + " of " +
                         std::to_string(figures.size()) + " figures");
  return result;
}

}  // namespace muckpile
