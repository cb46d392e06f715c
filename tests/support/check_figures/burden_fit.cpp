// SPDX-License-Identifier: GPL-2.0-or-later
// Speed of a burden against its width.
// Scope: see the header.
#include "check_figures/burden_fit.h"

#include <utility>
#include <vector>

#include "args/input_error.h"
#include "check_figures/positive_number.h"
#include "check_figures/power_exponent.h"

namespace muckpile::check {
namespace {

constexpr double kQuotedBurden = 3.0;  // m

struct Run {
  double burden, velocity, wave_share, gas_share;
};

std::vector<Run> read_runs(const CsvTable& table) {
  std::vector<Run> runs;
  for (size_t row = 0; row < table.rows(); ++row) {
    const double energy = positive_number(table, row, "explosive_energy_J");
    runs.push_back({positive_number(table, row, "burden_m"),
                    positive_number(table, row, "face_velocity_m_s"),
                    positive_number(table, row, "wave_work_J") / energy,
                    positive_number(table, row, "gas_work_J") / energy});
  }
  return runs;
}

}  // namespace

Json fit_burdens(const std::filesystem::path& table) {
  const std::vector<Run> runs = read_runs(CsvTable::read(table));
  std::vector<std::pair<double, double>> velocities;
  for (const Run& run : runs) velocities.emplace_back(run.burden, run.velocity);
  const auto exponent = power_exponent(velocities);
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
