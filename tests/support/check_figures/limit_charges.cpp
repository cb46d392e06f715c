// SPDX-License-Identifier: GPL-2.0-or-later
// Charges of a single hole that just loosen its burden, beside a law of sizes.
// Scope: see the header.
#include "check_figures/limit_charges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "check_figures/positive_number.h"

namespace muckpile::check {
namespace {

constexpr double kLoose = 0.05;       // throw over burden [-]
constexpr double kLeastThrow = 1e-6;  // below that of rock that stays [-]

/// Over the burden [-], by the charge over the burden's cube [kg/m3]; all cuts of one charge.
using Throws = std::map<double, std::vector<double>>;

struct Run {
  double charge, thrown;
};

std::vector<Run> means(const Throws& throws) {
  std::vector<Run> runs;
  for (const auto& [charge, of_cuts] : throws) {
    double sum = 0.0;
    for (const double thrown : of_cuts) sum += thrown;
    runs.push_back({charge, std::max(sum / static_cast<double>(of_cuts.size()), kLeastThrow)});
  }
  return runs;
}

/// [kg/m3]
double langefors(double burden) {
  constexpr double kRock = 0.40, kMargin = 1.2;
  return 0.07 / burden + kRock / kMargin + 0.004 * burden;
}

/// Where the throw crosses kLoose for the last time.
double limit_of(const std::vector<Run>& runs, const std::string& of) {
  for (size_t k = runs.size(); k-- > 1;) {
    const Run &below = runs[k - 1], &above = runs[k];
    if (below.thrown >= kLoose || above.thrown < kLoose) continue;
    const double share = std::log(kLoose / below.thrown) / std::log(above.thrown / below.thrown);
    return below.charge * std::pow(above.charge / below.charge, share);
  }
  throw InputError(of +
                   ": no charge whose throw is below a twentieth of the burden, with a larger "
                   "one beside it whose throw is above");
}

}  // namespace

Json limit_charges(const std::filesystem::path& file) {
  const CsvTable table = CsvTable::read(file);
  std::map<double, Throws> burdens;
  for (size_t row = 0; row < table.rows(); ++row) {
    const double burden = positive_number(table, row, "burden_m");
    const double thrown = table.number(row, table.column("throw_m")) / burden;
    burdens[burden][positive_number(table, row, "charge_kg") / std::pow(burden, 3)].push_back(
        thrown);
  }
  if (burdens.empty()) refuse(file.string(), "has no row");
  Json figures;
  for (const auto& [burden, throws] : burdens) {
    const std::string at = "_at_" + std::to_string(std::lround(100.0 * burden));
    const double limit = limit_of(means(throws), file.string() + ", burden " + text_of(burden));
    figures["limit_kg_m3" + at] = limit;
    figures["limit_over_langefors" + at] = limit / langefors(burden);
  }
  return figures;
}

}  // namespace muckpile::check
