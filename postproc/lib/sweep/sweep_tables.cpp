// SPDX-License-Identifier: GPL-2.0-or-later
// The tables of a sweep.
// Scope: see the header.
#include "sweep/sweep_tables.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

#include "args/suggestion.h"
#include "io/csv_writer.h"
#include "sweep/spread.h"

namespace muckpile {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> names_of(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const SweptVariable& variable : sweep.variables) names.push_back(variable.name);
  return names;
}

std::vector<std::string> values_of(const Sweep& sweep, const SweepRun& run) {
  std::vector<std::string> values;
  for (size_t k = 0; k < run.place.size(); ++k)
    values.push_back(sweep.variables[k].values[run.place[k]]);
  return values;
}

std::string header(std::vector<std::string> names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return joined(names, ",");
}

}  // namespace

std::vector<std::vector<const SweepRun*>> combinations_of(const Sweep& sweep) {
  std::vector<std::vector<const SweepRun*>> combinations;
  std::map<std::vector<size_t>, size_t> number;
  for (const SweepRun& run : sweep.runs) {
    if (!run.is_done()) continue;
    const auto [found, is_new] = number.emplace(run.place, combinations.size());
    if (is_new) combinations.emplace_back();
    combinations[found->second].push_back(&run);
  }
  return combinations;
}

void write_runs_table(const Sweep& sweep) {
  std::vector<std::string> names = names_of(sweep);
  if (sweep.has_seeds) names.emplace_back("seed");
  names.emplace_back("state");
  CsvWriter table(sweep.folder / "sweep.csv", header(names, sweep.figures));
  for (const SweepRun& run : sweep.runs) {
    std::vector<std::string> words = values_of(sweep, run);
    if (sweep.has_seeds) words.push_back(run.seed);
    words.push_back(run.state);
    std::vector<double> values;
    for (const std::string& figure : sweep.figures)
      values.push_back(run.figure(figure).value_or(kNone));
    table.row(words, values);
  }
}

void write_spread_table(const Sweep& sweep) {
  const bool all_together =
      sweep.is_sampled || (sweep.variables.size() == 1 && sweep.variables.front().name == "seed");
  std::vector<std::vector<const SweepRun*>> combinations = combinations_of(sweep);
  for (size_t k = 1; all_together && k < combinations.size(); ++k)
    std::ranges::copy(combinations[k], std::back_inserter(combinations.front()));
  if (all_together && !combinations.empty()) combinations.resize(1);
  const std::vector<std::string> names =
      all_together ? std::vector<std::string>{} : names_of(sweep);
  CsvWriter table(sweep.folder / "sweep_mean.csv",
                  header(names, {"figure", "runs", "mean", "standard_deviation", "least", "p10",
                                 "p50", "p90", "largest"}));
  for (const auto& runs : combinations) {
    for (const std::string& figure : sweep.figures) {
      std::vector<double> found;
      for (const SweepRun* run : runs) {
        if (const auto value = run->figure(figure)) found.push_back(*value);
      }
      if (found.empty()) continue;
      const Spread s = spread_of(found);
      std::vector<std::string> words =
          all_together ? std::vector<std::string>{} : values_of(sweep, *runs.front());
      words.push_back(figure);
      table.row(words, {static_cast<double>(s.count), s.mean, s.deviation, s.least, s.p10, s.p50,
                        s.p90, s.largest});
    }
  }
}

void write_fit_table(const Sweep& sweep, const std::vector<SweepFit>& fits) {
  CsvWriter table(sweep.folder / "sweep_fit.csv",
                  "figure,variable,exponent,standard_error,residual_ln,runs,runs_left_out,from,to");
  for (const SweepFit& fit : fits) {
    table.row({fit.figure, sweep.variables[fit.variable].name},
              {fit.law.exponent, fit.law.error.value_or(kNone), fit.law.residual,
               static_cast<double>(fit.runs), static_cast<double>(fit.left_out), fit.from, fit.to});
  }
}

}  // namespace muckpile
