// SPDX-License-Identifier: GPL-2.0-or-later
// Values of several uncertain quantities for a number of runs.
// Scope: see the header.
#include "sweep/latin_hypercube.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "math/random.h"
#include "sweep/correlation.h"

namespace muckpile {
namespace {

constexpr int kDesigns = 100;  // among which the least correlated one is chosen

using Design = std::vector<std::vector<double>>;  // by quantity, then by run

std::vector<double> one_in_each_part(size_t runs, Random& random) {
  std::vector<double> shares(runs);
  for (size_t k = 0; k < runs; ++k)
    shares[k] = (static_cast<double>(k) + random.uniform()) / static_cast<double>(runs);
  for (size_t k = runs; k > 1; --k) {  // Fisher and Yates
    const auto other = static_cast<size_t>(random.uniform() * static_cast<double>(k));
    std::swap(shares[k - 1], shares[other]);
  }
  return shares;
}

double worst_correlation(const Design& design) {
  double worst = 0.0;
  for (size_t a = 0; a < design.size(); ++a) {
    for (size_t b = 0; b < a; ++b)
      worst = std::max(worst, std::abs(correlation(design[a], design[b]).value_or(0.0)));
  }
  return worst;
}

bool names_a_variable(const std::string& name) {
  return std::ranges::all_of(name,
                             [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

}  // namespace

SampledRange parse_range(const std::string& words) {
  const auto bad = [&](const std::string& why) {
    throw InputError("sample: '" + words + "' " + why);
  };
  SampledRange range;
  const size_t equals = words.find('=');
  if (equals == std::string::npos || equals == 0)
    bad("must be NAME=FROM..TO, or NAME=log:FROM..TO");
  range.name = words.substr(0, equals);
  if (!names_a_variable(range.name)) bad("must name a variable, of letters, digits and _ alone");
  std::string values = words.substr(equals + 1);
  if (values.starts_with("log:")) {
    range.logarithmic = true;
    values.erase(0, 4);
  }
  const size_t dots = values.find("..");
  if (dots == std::string::npos) bad("must be NAME=FROM..TO, or NAME=log:FROM..TO");
  range.from = parse_number(values.substr(0, dots), "sample: '" + words + "': ");
  range.to = parse_number(values.substr(dots + 2), "sample: '" + words + "': ");
  if (!(range.from < range.to)) bad("must rise from the first to the second value");
  if (range.logarithmic && !(range.from > 0.0)) bad("must be > 0 on a logarithmic scale");
  return range;
}

std::vector<std::vector<double>> latin_hypercube(size_t runs, size_t quantities,
                                                 std::uint64_t seed) {
  Random random(seed);
  Design best;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kDesigns; ++k) {
    Design design;
    for (size_t q = 0; q < quantities; ++q) design.push_back(one_in_each_part(runs, random));
    const double worst = worst_correlation(design);
    if (worst >= least) continue;
    least = worst;
    best = std::move(design);
  }
  std::vector<std::vector<double>> by_run(runs, std::vector<double>(quantities));
  for (size_t run = 0; run < runs; ++run) {
    for (size_t q = 0; q < quantities; ++q) by_run[run][q] = best[q][run];
  }
  return by_run;
}

std::string sampled_value(const SampledRange& range, double share) {
  const double value = range.logarithmic
                           ? std::exp(std::lerp(std::log(range.from), std::log(range.to), share))
                           : std::lerp(range.from, range.to, share);
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace muckpile
