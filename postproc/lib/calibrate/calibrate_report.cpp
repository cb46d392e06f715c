// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command calibrate fit: constants of a sweep from the figures measured at one blast.
// Scope: see the header.
#include "calibrate/calibrate_report.h"

#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "args/rounded_text.h"
#include "args/suggestion.h"
#include "calibrate/fitting.h"
#include "calibrate/site_file.h"
#include "draw/png_file.h"
#include "io/csv_writer.h"

namespace muckpile {
namespace {

using Eigen::Index;

// Of the constants in the product that stands for a direction; the largest is 1.
Eigen::VectorXd exponents(const Fitting& f, const Direction& direction) {
  Eigen::VectorXd all = direction.way;
  for (Index i = 0; i < all.size(); ++i) all[i] /= f.constants[static_cast<size_t>(i)].scale.half;
  Index largest = 0;
  all.cwiseAbs().maxCoeff(&largest);
  return all / all[largest];
}

// By which factors the constants change along half a swept range of a direction.
std::vector<double> factors(const Fitting& f, const Direction& direction) {
  std::vector<double> all;
  for (size_t i = 0; i < f.constants.size(); ++i)
    all.push_back(std::exp(f.constants[i].scale.half * direction.way[static_cast<Index>(i)]));
  return all;
}

// "energy_share times 1.3 with friction times 0.7".
std::string trade_text(const Fitting& f, const Direction& direction) {
  constexpr double kLeast = 0.05;  // of a place: less changes next to nothing
  const std::vector<double> all = factors(f, direction);
  std::vector<std::string> words;
  for (size_t i = 0; i < all.size(); ++i) {
    if (std::abs(direction.way[static_cast<Index>(i)]) < kLeast) continue;
    words.push_back(f.sweep.variables[i].name + " times " + spelled(all[i], 2));
  }
  return joined(words, " with ");
}

std::string names_of(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const SweptVariable& variable : sweep.variables) names.push_back(variable.name);
  return joined(names, ",");
}

void write_constants(const Fitting& f) {
  CsvWriter csv(f.sweep.folder / "calibrate.csv",
                "constant,estimate,low,high,standard_error_ln,told_fraction,at_edge,swept_from,"
                "swept_to");
  for (size_t i = 0; i < f.constants.size(); ++i) {
    const double value = estimate(f, i), factor = std::exp(error_ln(f, i));
    csv.row(f.sweep.variables[i].name,
            {value, value / factor, value * factor, error_ln(f, i), told(f, i),
             f.result.at_edge(i) ? 1.0 : 0.0, f.constants[i].scale.value_at(-1.0),
             f.constants[i].scale.value_at(1.0)});
  }
}

void write_figures(const Fitting& f) {
  CsvWriter csv(f.sweep.folder / "calibrate_figures.csv",
                "figure,measured,uncertainty,fitted,surface_scatter,off_by_deviations,"
                "least_in_sweep,largest_in_sweep,runs,runs_to_spare");
  for (size_t k = 0; k < f.figures.size(); ++k) {
    const Target& t = f.targets[k];
    const double value = t.surface.at(f.result.place);
    csv.row(f.measured[k].key,
            {t.value, f.measured[k].uncertainty, value, t.surface.scatter(),
             (value - t.value) / t.deviation, f.figures[k].values.minCoeff(),
             f.figures[k].values.maxCoeff(), static_cast<double>(f.figures[k].values.size()),
             static_cast<double>(t.surface.spare())});
  }
}

void write_directions(const Fitting& f) {
  std::vector<std::string> header{"direction", "sharpness", "resolved"};
  for (const char* kind : {"exponent_", "factor_"})
    for (const SweptVariable& variable : f.sweep.variables) header.push_back(kind + variable.name);
  CsvWriter csv(f.sweep.folder / "calibrate_directions.csv", joined(header, ","));
  for (size_t k = 0; k < f.result.directions.size(); ++k) {
    const Direction& each = f.result.directions[k];
    std::vector<double> row{static_cast<double>(k + 1), each.sharpness,
                            each.is_resolved() ? 1.0 : 0.0};
    for (const double exponent : exponents(f, each)) row.push_back(exponent);
    for (const double factor : factors(f, each)) row.push_back(factor);
    csv.row(row);
  }
}

void write_covariance(const Fitting& f) {
  CsvWriter csv(f.sweep.folder / "calibrate_covariance.csv", "constant," + names_of(f.sweep));
  for (size_t i = 0; i < f.constants.size(); ++i) {
    std::vector<double> row;
    for (size_t j = 0; j < f.constants.size(); ++j)
      row.push_back(f.constants[i].scale.half * f.constants[j].scale.half *
                    f.result.covariance(static_cast<Index>(i), static_cast<Index>(j)));
    csv.row(f.sweep.variables[i].name, row);
  }
}

std::string line_of_constant(const Fitting& f, size_t i) {
  const double value = estimate(f, i), factor = std::exp(error_ln(f, i));
  const LogScale& scale = f.constants[i].scale;
  std::string line = spelled(value / factor) + " to " + spelled(value * factor) +
                     " (one standard deviation), swept " + spelled(scale.value_at(-1.0)) + " to " +
                     spelled(scale.value_at(1.0));
  constexpr double kAll = 0.5;
  if (told(f, i) < kAll) line += ", NOT TOLD by the measures";
  if (f.result.at_edge(i)) line += ", AT THE EDGE of the sweep";
  return line;
}

std::string line_of_figure(const Fitting& f, size_t k) {
  const Target& t = f.targets[k];
  const double value = t.surface.at(f.result.place);
  std::string line = f.measured[k].key + ": measured " + spelled(t.value, 4) + " +- " +
                     spelled(f.measured[k].uncertainty, 2) + ", fitted " + spelled(value, 4) +
                     ", off by " + spelled((value - t.value) / t.deviation, 2) +
                     " deviations (with a scatter of the runs of " +
                     spelled(t.surface.scatter(), 2) + ")";
  const auto& values = f.figures[k].values;
  if (t.value + t.deviation < values.minCoeff() || t.value - t.deviation > values.maxCoeff())
    line += ", OUTSIDE of what the sweep reached";
  return line;
}

std::vector<std::string> notes_of(const Fitting& f) {
  std::vector<std::string> notes;
  for (const Direction& each : f.result.directions)
    if (!each.is_resolved())
      notes.push_back("not told by the measures: " + trade_text(f, each) +
                      " changes the figures by less than they are known; that way the constants "
                      "stay as in the middle of the sweep");
  const size_t figures = f.targets.size(), resolved = f.result.resolved();
  const std::string misfit = "sum of squared deviations " + spelled(f.result.misfit);
  if (figures > resolved)
    notes.push_back(misfit + " with " + std::to_string(figures - resolved) +
                    " figures more than resolved combinations");
  else
    notes.push_back(misfit +
                    ": no figure more than resolved combinations, so that a close fit "
                    "proves nothing; check it on another blast");
  return notes;
}

void require_name(const std::string& name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (name.empty() || !std::ranges::all_of(name, fits))
    refuse("calibrate", "--site must be a name of letters, digits, _ and -, got '" + name + "'");
}

std::filesystem::path site_path(const Fitting& f, const FitOptions& options) {
  return f.sweep.folder / ("site_" + options.site + ".in");
}

std::filesystem::path write_site(const Fitting& f, const FitOptions& options,
                                 const std::vector<std::string>& notes) {
  std::vector<std::string> remarks{
      "Site constants '" + options.site + "': muckpile-post calibrate fit " + options.measured +
          " " + options.sweep,
      "Give it to a run of the same rock by -var site FILE; what -var sets besides wins."};
  for (size_t k = 0; k < f.targets.size(); ++k) remarks.push_back(line_of_figure(f, k));
  remarks.insert(remarks.end(), notes.begin(), notes.end());
  SiteConstants constants;
  std::vector<std::string> beside;
  for (size_t i = 0; i < f.constants.size(); ++i) {
    constants.emplace_back(f.sweep.variables[i].name, rounded_text(estimate(f, i)));
    beside.push_back(line_of_constant(f, i));
  }
  const std::filesystem::path path = site_path(f, options);
  write_site_file(path, remarks, constants, beside);
  return path;
}

}  // namespace

std::vector<std::string> report_calibration(const FitOptions& options) {
  require_name(options.site);
  const Fitting f = fitted(options);
  write_constants(f);
  write_figures(f);
  write_directions(f);
  write_covariance(f);
  write_png(draw_panels(plot_of_calibration(f.constants, f.figures, f.targets, f.result)),
            f.sweep.folder / "calibrate.png");
  std::vector<std::string> lines{f.order == SurfaceOrder::kLinear ? "linear surfaces"
                                                                  : "quadratic surfaces"};
  for (size_t k = 0; k < f.targets.size(); ++k) lines.push_back(line_of_figure(f, k));
  if (f.result.resolved() == 0) {
    std::filesystem::remove(site_path(f, options));  // of an earlier fit: no run is to include it
    refuse("calibrate", "the measures tell no combination of " + names_of(f.sweep) +
                            "; there is no site file. " + joined(lines, "; "));
  }
  for (size_t i = 0; i < f.constants.size(); ++i)
    lines.push_back(f.sweep.variables[i].name + " " + rounded_text(estimate(f, i)) + ": " +
                    line_of_constant(f, i));
  const std::vector<std::string> notes = notes_of(f);
  lines.insert(lines.end(), notes.begin(), notes.end());
  lines.push_back("site file " + write_site(f, options, notes).string());
  return lines;
}

}  // namespace muckpile
