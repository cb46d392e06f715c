// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command damage: rings and radii worked by hand, cracks, and what a run and one without
// charges leave. Scope: a made-up bench of cubes with a known share at each distance, and a slab
// with a crack.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "draw/colours.h"
#include "drawn_picture.h"
#include "geometry/files/block_file.h"
#include "golden_files.h"
#include "input_error_of.h"
#include "measure/damage.h"
#include "measure/joint_faces.h"
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

TEST_F(DamageOfARun, WithoutJointsHasNoCracks) {
  set_charge();
  report_damage(folder());
  EXPECT_TRUE(summary()["crack_reach_half_m"].is_null());
  EXPECT_NE(summary()["crack_note"].get<std::string>().find("joints.csv"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder().file("cracks.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder().file("cracks.png")));
}

// A slab of cubes 3.5 m wide and 0.5 m thick around a shaft of one cube, with a charge of 0.2 m of
// hole in it. Broken are the joints in the plane y = 0.25 m from x = 0.25 m to the side, and one at
// x = -1 m, y = 1.25 m.
class CracksOfARun : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bench(temporary_.path());
    std::vector<Block> cubes = cubes_in({-1.75, -1.75, 0.0}, {1.75, 1.75, 0.5});
    std::erase_if(cubes,
                  [](const Block& cube) { return cube.mass.centroid.head<2>().norm() < 0.1; });
    write_blocks((dump() / "blocks.vtk").string(), cubes, 1, kDensity);
    const std::vector<StartBlock> blocks = as_start_blocks(cubes);
    for (const char* step : {"000000000", "000001000"})
      std::filesystem::remove(dump() / ("blocks_" + std::string(step) + ".csv"));
    Snapshot last = start_snapshot(blocks);
    last.step = 2000;
    write_snapshot(dump() / "blocks_000002000.csv", blocks, last);
    write_text(dump() / "scene.json", R"({"case": "other", "hole_diameter_m": 0.2})");
    std::string run = text_of(dump() / "run.json");
    run.insert(1,
               R"("holes": [{"toe_m": [0, 0, 0], "collar_m": [0, 0, 0.5], "radius_m": 0.25}], )");
    write_text(dump() / "run.json", run);
    write_joints(blocks, 2000);
  }
  void write_joints(const std::vector<StartBlock>& blocks, int step) {
    std::string rows;
    for (const RockFace& face : faces_of_rock(blocks)) {
      if (!face.other || is_broken(face)) continue;
      rows += std::to_string(blocks[face.block].id) + ',' + std::to_string(face.face) + ",0\n";
    }
    write_text(dump() / "joints.csv",
               "# step=" + std::to_string(step) + " time_s=4.5\nid,face,broken_share\n" + rows);
  }
  static bool is_broken(const RockFace& face) {
    const Vec3& c = face.centroid;
    const bool crack = std::abs(c.y() - 0.25) < 0.01 && c.x() > 0.25;
    return std::abs(face.normal.y()) > 0.9 && (crack || (c - Vec3(-1.0, 1.25, 0.25)).norm() < 0.01);
  }
  [[nodiscard]] std::filesystem::path dump() const { return temporary_.path() / "dump"; }
  [[nodiscard]] nlohmann::ordered_json damage() const {
    const ResultFolder folder(temporary_.path());
    report_damage(folder);
    return read_json_object(folder.file("summary.json"));
  }
  TemporaryFolder temporary_;
};

TEST_F(CracksOfARun, AreThoseOfTheCharge) {
  const auto keys = damage();
  const double farthest = std::hypot(1.75, 0.25);
  EXPECT_NEAR(keys["crack_reach_farthest_m"], farthest, 1e-9);
  EXPECT_NEAR(keys["crack_reach_farthest_hole_radii"], farthest / 0.1, 1e-9);
  EXPECT_NEAR(keys["crack_reach_half_m"], 0.25, 1e-9);
  EXPECT_NEAR(keys["crack_connected_share"], 3.0 / 4.0, 1e-12);
  EXPECT_NEAR(keys["crack_directions_beyond_30_radii"], 0.0, 1e-12);
  EXPECT_TRUE(keys["crack_note"].is_null());
}

// Each of the crack's six cubes has it as one of its joints: three have 4 joints, the one beside
// the shaft and two at the side 3.
TEST_F(CracksOfARun, HaveTheirShareInTheRings) {
  (void)damage();
  const CsvTable table = CsvTable::read(temporary_.path() / "damage.csv");
  double share = 0.0;
  for (size_t row = 0; row < table.rows(); ++row)
    share += table.number(row, table.column("connected_fraction")) *
             table.number(row, table.column("volume_m3"));
  EXPECT_NEAR(share, 0.125 * (3.0 / 4.0 + 3.0 / 3.0), 1e-5);  // six digits of the table
}

TEST_F(CracksOfARun, TheTableIsTheGoldenOne) {
  (void)damage();
  expect_golden(temporary_.path() / "cracks.csv", "slab_cracks");
}

TEST_F(CracksOfARun, AreDrawn) {
  (void)damage();
  const DrawnPicture picture(temporary_.path() / "cracks.png");
  EXPECT_GT(picture.count(kSignal, picture.all()), 200);
}

// A run that was cut short behind an end of a run: joints of another step.
TEST_F(CracksOfARun, OfAnotherStepAreNotTaken) {
  std::string text = text_of(dump() / "joints.csv");
  write_text(dump() / "joints.csv", text.replace(text.find("2000"), 4, "1000"));
  EXPECT_FALSE(damage()["crack_note"].is_null());
}

TEST_F(CracksOfARun, OfAnotherRunAreRefused) {
  for (const char* name :
       {"blocks.vtk", "run.json", "scene.json", "history.csv", "blocks_000002000.csv"})
    mark_with_run(dump() / name, "0123456789abcdef");
  mark_with_run(dump() / "joints.csv", "0123456789abcdee");
  EXPECT_THROW(ResultFolder{temporary_.path()}, InputError);
}

TEST_F(CracksOfARun, FaultyJointsAreRefused) {
  std::string text = text_of(dump() / "joints.csv");
  write_text(dump() / "joints.csv", text + "1,1,0\n1,1,0\n");
  EXPECT_THROW(damage(), InputError);
}

// The first line tells how many rows there are: a row that is missing is a joint that has broken.
TEST_F(CracksOfARun, JointsCutShortAreRefused) {
  std::string text = text_of(dump() / "joints.csv");
  const auto rows = std::ranges::count(text, '\n') - 2;
  text.replace(text.find("time_s"), 0, "rows=" + std::to_string(rows) + ' ');
  write_text(dump() / "joints.csv", text);
  EXPECT_NO_THROW((void)damage());
  text.erase(text.rfind('\n', text.size() - 2) + 1);
  write_text(dump() / "joints.csv", text);
  const std::string error = input_error_of([&] { (void)damage(); });
  EXPECT_NE(
      error.find("joints.csv:" + std::to_string(rows + 1) + ": the table must have " +
                 std::to_string(rows) + " rows, as its first line says, but ends here behind " +
                 std::to_string(rows - 1) + ": it has been cut short"),
      std::string::npos)
      << error;
}

// Of a block that the rock does not have, and of a face of block 1 that is on the outside.
TEST_F(CracksOfARun, JointsOfOtherRockAreRefused) {
  const std::string text = text_of(dump() / "joints.csv");
  const auto rows = std::ranges::count(text, '\n') - 2;
  write_text(dump() / "joints.csv", text + "9999,0,0\n1,77,0\n");
  const std::string error = input_error_of([&] { (void)damage(); });
  EXPECT_NE(error.find("joints.csv: 2 of " + std::to_string(rows + 2) +
                       " rows are of no joint of blocks.vtk, the first of face 77 of block 1"),
            std::string::npos)
      << error;
}

}  // namespace
}  // namespace muckpile
