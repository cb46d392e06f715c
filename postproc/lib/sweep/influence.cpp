// SPDX-License-Identifier: GPL-2.0-or-later
// What a sweep over sampled ranges tells: which variable a figure follows most, and how.
// Scope: see the header.
#include "sweep/influence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/csv_writer.h"
#include "sweep/correlation.h"

namespace muckpile {
namespace {

using Columns = std::vector<std::vector<double>>;

std::vector<size_t> variables_with_numbers(const Sweep& sweep) {
  std::vector<size_t> variables;
  for (size_t k = 0; k < sweep.variables.size(); ++k) {
    if (!sweep.variables[k].numbers.empty() && sweep.variables[k].name != "seed")
      variables.push_back(k);
  }
  return variables;
}

std::optional<LinearLaw> power_law(Columns x, std::vector<double> y) {
  const auto take_logarithms = [](std::vector<double>& values) {
    for (double& value : values) value = std::log(value);
    return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
  };
  bool positive = take_logarithms(y);
  for (auto& column : x) positive = take_logarithms(column) && positive;
  return positive ? fit_linear(x, y) : std::nullopt;
}

FigureInfluences influences_on(const Sweep& sweep, const std::string& figure) {
  const std::vector<size_t> variables = variables_with_numbers(sweep);
  Columns x(variables.size());
  std::vector<double> y;
  for (const SweepRun& run : sweep.runs) {
    const auto value = run.is_done() ? run.figure(figure) : std::nullopt;
    if (!value) continue;
    y.push_back(*value);
    for (size_t k = 0; k < variables.size(); ++k)
      x[k].push_back(sweep.variables[variables[k]].numbers[run.place[variables[k]]]);
  }
  const std::optional<LinearLaw> law = power_law(x, y);
  FigureInfluences found{figure, y.size(), {}, std::nullopt};
  if (law) found.explained = law->explained;
  for (size_t k = 0; k < variables.size(); ++k) {
    Influence influence{variables[k], rank_correlation(x[k], y), std::nullopt, std::nullopt};
    if (law) {
      influence.exponent = law->slopes[k];
      influence.error = law->errors[k];
    }
    found.of.push_back(influence);
  }
  std::ranges::stable_sort(found.of, std::greater{}, [](const Influence& influence) {
    return std::abs(influence.correlation.value_or(0.0));
  });
  return found;
}

}  // namespace

std::vector<FigureInfluences> influences_of(const Sweep& sweep,
                                            const std::vector<std::string>& figures) {
  std::vector<FigureInfluences> all;
  for (const std::string& figure : figures) all.push_back(influences_on(sweep, figure));
  return all;
}

void write_influence_table(const Sweep& sweep, const std::vector<FigureInfluences>& influences) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  CsvWriter table(sweep.folder / "sweep_influence.csv",
                  "figure,variable,rank_correlation,exponent,standard_error,explained,runs");
  for (const FigureInfluences& found : influences) {
    for (const Influence& one : found.of) {
      table.row(
          {found.figure, sweep.variables[one.variable].name},
          {one.correlation.value_or(kNone), one.exponent.value_or(kNone), one.error.value_or(kNone),
           found.explained.value_or(kNone), static_cast<double>(found.runs)});
    }
  }
}

}  // namespace muckpile
