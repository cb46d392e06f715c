// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of fix muckpile/gauges.
// Scope: see the header.
#include "gauge_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "args/csv_table.h"

namespace muckpile::test {

std::vector<GaugeRow> gauge_rows(const std::filesystem::path& file) {
  const CsvTable table = CsvTable::read(file);
  std::vector<GaugeRow> rows;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const auto of = [&](const char* name) { return table.number(r, table.column(name)); };
    GaugeRow row;
    row.step = table.whole(r, table.column("step"));
    row.time = of("time_s");
    row.gauge = table.whole(r, table.column("gauge"));
    row.block = table.whole(r, table.column("block"));
    row.start = {of("x_m"), of("y_m"), of("z_m")};
    row.moved = {of("ux_m"), of("uy_m"), of("uz_m")};
    row.velocity = {of("vx_m_s"), of("vy_m_s"), of("vz_m_s")};
    const double xy = of("sxy_Pa"), yz = of("syz_Pa"), zx = of("szx_Pa");
    row.stress << of("sxx_Pa"), xy, zx, xy, of("syy_Pa"), yz, zx, yz, of("szz_Pa");
    row.pressure = of("pressure_Pa");
    rows.push_back(row);
  }
  return rows;
}

std::vector<GaugeRow> rows_of(const std::vector<GaugeRow>& rows, int gauge) {
  std::vector<GaugeRow> those;
  std::ranges::copy_if(rows, std::back_inserter(those),
                       [gauge](const GaugeRow& row) { return row.gauge == gauge; });
  return those;
}

double difference(const std::vector<GaugeRow>& one, const std::vector<GaugeRow>& other) {
  EXPECT_EQ(one.size(), other.size());
  Vec3 apart = Vec3::Zero(), largest = Vec3::Constant(1e-300);
  for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k) {
    const GaugeRow &a = one[k], &b = other[k];
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.gauge, b.gauge);
    EXPECT_EQ(a.block, b.block);
    apart = apart.cwiseMax(Vec3((a.moved - b.moved).norm(), (a.velocity - b.velocity).norm(),
                                (a.stress - b.stress).norm()));
    largest = largest.cwiseMax(Vec3(a.moved.norm(), a.velocity.norm(), a.stress.norm()));
  }
  return apart.cwiseQuotient(largest).maxCoeff();
}

}  // namespace muckpile::test
