// SPDX-License-Identifier: GPL-2.0-or-later
// Speed of a burden against its width.
// Scope: see the header.
#include "check_figures/burden_fit.h"

#include <cmath>

#include "args/input_error.h"

namespace muckpile::check {
namespace {

constexpr double kQuotedBurden = 3.0;  // m

struct Run {
  double burden, velocity, wave_share, gas_share;
};

std::vector<Run> read_runs(const CsvTable& table) {
  const auto positive = [&table](size_t row, const char* name) {
    const double value = table.number(row, table.column(name));
    if (value <= 0.0)
      throw InputError(table.where(row) + name + " must be > 0, got " + text_of(value));
    return value;
  };
  std::vector<Run> runs;
  for (size_t row = 0; row < table.rows(); ++row) {
    const double energy = positive(row, "explosive_energy_J");
    runs.push_back({positive(row, "burden_m"), positive(row, "face_velocity_m_s"),
                    positive(row, "wave_work_J") / energy, positive(row, "gas_work_J") / energy});
  }
  return runs;
}

/// Nothing if all runs have one burden.
std::optional<double> exponent_of(const std::vector<Run>& runs) {
  double x_mean = 0.0, y_mean = 0.0, xx = 0.0, xy = 0.0;
  for (const Run& run : runs) {
    x_mean += std::log(run.burden) / static_cast<double>(runs.size());
    y_mean += std::log(run.velocity) / static_cast<double>(runs.size());
  }
  for (const Run& run : runs) {
    const double x = std::log(run.burden) - x_mean;
    xx += x * x;
    xy += x * (std::log(run.velocity) - y_mean);
  }
  constexpr double kRoundOff = 1e-20;  // of squares of differences of logarithms
  if (xx <= kRoundOff) return std::nullopt;
  return xy / xx;
}

}  // namespace

Json fit_burdens(const std::filesystem::path& table) {
  const std::vector<Run> runs = read_runs(CsvTable::read(table));
  const auto exponent = exponent_of(runs);
  if (!exponent) refuse(table.string(), "a fit needs runs of two burdens at least");
  Run mean{};
  double count = 0.0;
  for (const Run& run : runs) {
    if (run.burden != kQuotedBurden) continue;
    count += 1.0;
    mean.velocity += run.velocity;
    mean.wave_share += run.wave_share;
    mean.gas_share += run.gas_share;
  }
  if (count == 0.0) refuse(table.string(), "has no run with a burden of 3 m");
  return {{"burden_velocity_exponent", *exponent},
          {"velocity_at_3_m_m_s", mean.velocity / count},
          {"wave_efficiency_at_3_m", mean.wave_share / count},
          {"gas_efficiency_at_3_m", mean.gas_share / count}};
}

}  // namespace muckpile::check
