// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command damage: rings and radii worked by hand, and what a run and one without charges leave.
// Scope: a made-up bench of cubes with a known share at each distance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "args/csv_table.h"
#include "golden_files.h"
#include "measure/damage.h"
#include "report/damage_report.h"
#include "report/not_measurable.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

TEST(DamageRings, WeighBlocksByVolume) {
  const auto rings = damage_rings({{0.2, 1.0, 1.0}, {0.9, 3.0, 0.2}, {2.5, 1.0, 0.1}}, 1.0);
  ASSERT_EQ(rings.size(), 2U);  // none at 1.5 m
  EXPECT_DOUBLE_EQ(rings[0].distance, 0.5);
  EXPECT_EQ(rings[0].blocks, 2);
  EXPECT_DOUBLE_EQ(rings[0].volume, 4.0);
  EXPECT_DOUBLE_EQ(rings[0].broken_fraction, 0.4);  // (1 x 1 + 3 x 0.2) / 4
  EXPECT_DOUBLE_EQ(rings[1].distance, 2.5);
}

// The share falls below a half twice; the second time, from 0.6 at 2.5 m to 0.2 at 3.5 m, a quarter
// of the way.
TEST(DamageRadius, IsThatOfTheLastFall) {
  const std::vector<DamageRing> rings = {
      {0.5, 1, 1.0, 0.9}, {1.5, 1, 1.0, 0.4}, {2.5, 1, 1.0, 0.6}, {3.5, 1, 1.0, 0.2}};
  EXPECT_NEAR(damage_radius(rings, 0.5).value(), 2.75, 1e-12);
  EXPECT_FALSE(damage_radius(rings, 0.1));   // the last ring has more
  EXPECT_FALSE(damage_radius(rings, 0.95));  // no ring has as much
}

// One upright charge at x = -5, y = 0; the share is 1 - distance / 4 m, so it is a half at 2 m and
// a tenth at 3.6 m. The hole's radius is 0.05 m.
class DamageOfARun : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bench(temporary_.path());
    BenchRun run = bench_run();
    for (size_t b = 0; b < run.blocks.size(); ++b) {
      const Vec3& at = run.blocks[b].centroid;
      const double distance = std::hypot(at.x() + 5.0, at.y());
      run.last.states[b].broken_fraction = std::max(0.0, 1.0 - distance / 4.0);
    }
    write_snapshot(temporary_.path() / "dump/blocks_000002000.csv", run.blocks, run.last);
  }
  void set_charge() {
    const auto path = temporary_.path() / "dump/run.json";
    std::string text = text_of(path);
    write_text(path, text.insert(1,
                                 "\"holes\": [{\"toe_m\": [-5, 0, -1], \"collar_m\": [-5, 0, "
                                 "10.5], \"radius_m\": 0.15}], "));
  }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] nlohmann::ordered_json summary() const {
    return read_json_object(folder().file("summary.json"));
  }
  TemporaryFolder temporary_;
};

TEST_F(DamageOfARun, FindsTheKnownRadii) {
  set_charge();
  report_damage(folder());
  const auto keys = summary();
  EXPECT_NEAR(keys["damage_half_radius_m"], 2.0, 0.1);  // a fifth of a ring
  EXPECT_NEAR(keys["damage_tenth_radius_m"], 3.6, 0.1);
  EXPECT_NEAR(keys["damage_half_hole_radii"], 20.0 * keys["damage_half_radius_m"].get<double>(),
              1e-9);
  EXPECT_TRUE(keys["damage_note"].is_null());
  const CsvTable table = CsvTable::read(folder().file("damage.csv"));
  double volume = 0.0;
  for (size_t row = 0; row < table.rows(); ++row)
    volume += table.number(row, table.column("volume_m3"));
  EXPECT_NEAR(volume, 8.0 * 2.0 * 11.5, 1e-3);
  EXPECT_GT(std::filesystem::file_size(folder().file("damage.png")), 200U);
}

TEST_F(DamageOfARun, TheTableIsTheGoldenOne) {
  set_charge();
  report_damage(folder());
  expect_golden(folder().file("damage.csv"), "bench_damage");
}

TEST_F(DamageOfARun, WithoutChargesIsNotMeasured) {
  EXPECT_THROW(report_damage(folder()), NotMeasurable);
  EXPECT_TRUE(summary().contains("damage_refused"));
  set_charge();
  report_damage(folder());
  EXPECT_FALSE(summary().contains("damage_refused"));
}

}  // namespace
}  // namespace muckpile
