// SPDX-License-Identifier: GPL-2.0-or-later
// A blast at a corner with two free faces, and holes that are not parallel: rock, throw and
// velocity of each hole along the normal of its burden, by hand.
// Scope: measure/hole_frames, report/hole_frames_of, and the bench's reports with them.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "geometry/files/block_file.h"
#include "measure/hole_polygons.h"
#include "report/bench_scene.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "rock/burden_file.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kHeight = 3.0, kFastX = 8.0, kFastY = 5.0, kFarX = 10.0, kFarY = 6.0;

// Free at x = 0 and y = 0; burden 2 m, spacing 3 m. Holes of the two faces, one of them twice.
constexpr const char* kTable =
    "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,"
    "surface_delay_s\n"
    "a,-2,-5,3,-2,-5,0,0.1,1,3,0\n"
    "b,-2,-2,3,-2,-2,0,0.1,1,3,0\n"
    "c,-5,-2,3,-5,-2,0,0.1,1,3,0\n";

HoleBurden burden_to(const Vec3& at, const Vec3& face) {
  HoleBurden hole;
  for (const double z : {0.5, 1.5}) {
    BurdenPiece piece{z, at, (face - at).norm(), face};
    piece.at.z() = piece.face.z() = z;
    hole.pieces.push_back(piece);
  }
  return hole;
}

class Corner : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bench(temporary_.path());
    const auto shapes = cubes_in({-8, -8, 0}, {0, 0, kHeight});
    const auto blocks = as_start_blocks(shapes);
    Snapshot start = start_snapshot(blocks), middle = start, last = start;
    middle.step = 1000, last.step = 2000;
    middle.time = 0.01, last.time = 4.5;
    for (size_t b = 0; b < blocks.size(); ++b) {
      const Vec3& p = blocks[b].centroid;
      const bool to_x = (p.x() > -2.0 && p.y() > -6.5) || (p.x() > -3.5 && p.y() > -2.0);
      const bool to_y = p.y() > -2.0 && p.x() > -6.5 && p.x() < -3.5;
      middle.states[b].velocity = Vec3(to_x ? kFastX : 0.0, to_y ? kFastY : 0.0, 0.0);
      last.states[b].centre += Vec3(to_x ? kFarX : 0.0, to_y ? kFarY : 0.0, 0.0);
    }
    const auto dump = temporary_.path() / "dump";
    write_blocks((dump / "blocks.vtk").string(), shapes, 1, kDensity);
    write_snapshot(dump / "blocks_000000000.csv", blocks, start);
    write_snapshot(dump / "blocks_000001000.csv", blocks, middle);
    write_snapshot(dump / "blocks_000002000.csv", blocks, last);
    write_text(dump / "holes.csv", kTable);
    write_text(dump / "scene.json",
               "{\"case\": \"bench\", \"bench_height_m\": 3, \"burden_m\": 2, \"spacing_m\": 3,\n"
               " \"hole_diameter_m\": 0.1, \"charge_length_m\": 2, \"stemming_m\": 1, "
               "\"explosive_density_kg_m3\": 800}\n");
    write_faces();
  }
  void write_faces() {
    const BurdenFile burdens{
        {burden_to({-2, -5, 0}, {0, -5, 0}), burden_to({-2, -2, 0}, {0, -2, 0}),
         burden_to({-5, -2, 0}, {-5, 0, 0})},
        2.0};
    write_burdens((temporary_.path() / "dump/burden.csv").string(), burdens, "");
  }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] nlohmann::ordered_json summary() const {
    return read_json_object(folder().file("summary.json"));
  }
  TemporaryFolder temporary_;
};

// Volumes of rock: of a and c in front of them to half a spacing beside, of b with the corner, too.
constexpr double kSide = 2.0 * 3.0 * kHeight;
constexpr double kAtCorner = kSide + (1.5 * 2.0 + 2.0 * 0.5) * kHeight;
constexpr double kAll = 2.0 * kSide + kAtCorner;
constexpr double kToX = (kSide + kAtCorner) / kAll, kToY = kSide / kAll;

TEST_F(Corner, RowsMeasureEachHoleAlongTheNormalOfItsBurden) {
  report_rows(folder(), {kCube, 0.25});
  const CsvTable rows = CsvTable::read(folder().file("rows.csv"));
  ASSERT_EQ(rows.rows(), 5U);  // three holes, one row, all
  const auto value = [&](const std::string& name, const char* column) {
    for (size_t row = 0; row < rows.rows(); ++row)
      if (rows.word(row, 0) == name) return rows.number(row, rows.column(column));
    return std::nan("");
  };
  EXPECT_EQ(value("b", "blocks"), 240.0);
  EXPECT_EQ(value("a", "blocks"), 144.0);
  for (const char* name : {"a", "b"}) {
    EXPECT_NEAR(value(name, "throw_m"), kFarX, 1e-5);
    EXPECT_NEAR(value(name, "velocity_m_s"), kFastX, 1e-5);
    EXPECT_NEAR(value(name, "throw_turn_deg"), 0.0, 1e-9);
  }
  EXPECT_EQ(value("c", "blocks"), 144.0);
  EXPECT_NEAR(value("c", "throw_m"), kFarY, 1e-5);
  EXPECT_NEAR(value("c", "velocity_m_s"), kFastY, 1e-5);
  EXPECT_NEAR(value("c", "throw_turn_deg"), 90.0, 1e-9);
  EXPECT_NEAR(value("all", "throw_m"), kToX * kFarX + kToY * kFarY, 1e-5);
  EXPECT_TRUE(std::filesystem::exists(folder().file("face_velocity.csv")));
}

// Half of its charge is nearer to one face, half to the other: it throws to the corner, 2 sqrt(2) m
// away, though no nearest place of a face lies there.
TEST_F(Corner, AHoleThatLooksToTwoFacesThrowsToTheirCorner) {
  HoleBurden both = burden_to({-2, -2, 0}, {0, -2, 0});
  both.pieces[1] = burden_to({-2, -2, 0}, {-2, 0, 0}).pieces[1];
  const BurdenFile burdens{
      {burden_to({-2, -5, 0}, {0, -5, 0}), both, burden_to({-5, -2, 0}, {-5, 0, 0})}, 2.0};
  write_burdens((temporary_.path() / "dump/burden.csv").string(), burdens, "");
  const BenchScene bench = bench_scene(folder(), folder().rock());
  ASSERT_NE(bench.planes.frames, nullptr);
  const HoleFrame& hole = bench.planes.frames->holes()[1];
  EXPECT_NEAR(hole.direction.x(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(hole.direction.y(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(bench.planes.frames->burden_at_floor(1), 2.0 * std::numbers::sqrt2, 1e-9);
  for (const Vec2& face : hole.face) EXPECT_NEAR(face.y(), 0.0, 1e-12);
}

TEST_F(Corner, ProfileMeasuresThrowAndFaceButNoPileAlongX) {
  report_profile(folder(), {kCube, 0.25}, {});
  const auto keys = summary();
  EXPECT_NEAR(keys["throw_cg_m"], kToX * kFarX + kToY * kFarY, 1e-6);
  EXPECT_NEAR(keys["throw_max_m"], kFarX, 1e-6);
  EXPECT_NEAR(keys["burden_velocity_m_s"], kToX * kFastX + kToY * kFastY, 1e-6);
  // In front of a and b to the corner 6.5 m of face, of c 3 m.
  EXPECT_NEAR(keys["face_velocity_m_s"], (6.5 * kFastX + 3.0 * kFastY) / 9.5, 1e-6);
  EXPECT_NEAR(keys["beyond_toe_fraction"], 1.0, 1e-12);
  EXPECT_TRUE(keys["pile_height_m"].is_null());
  EXPECT_NE(keys["face_note"].get<std::string>().find("up to 90° off x; no height"),
            std::string::npos);
}

TEST_F(Corner, HeightsCountTheRockInFrontOfTheHoles) {
  report_heights(folder(), {kCube, 0.25});
  EXPECT_NEAR(summary()["prism_volume_m3"], kAll, 1e-9);
  EXPECT_NEAR(summary()["toe_left_volume_m3"], 0.0, 1e-12);
  EXPECT_NEAR(summary()["backbreak_m"], 0.0, 1e-12);
  EXPECT_NEAR(summary()["moved_volume_m3"], kAll, 1e-9);
}

TEST_F(Corner, MovementHasPartsOfBothFaces) {
  report_movement(folder(), {kCube, 0.25}, {});
  const CsvTable parts = CsvTable::read(folder().file("movement.csv"));
  double mass = 0.0, along_y = 0.0;
  for (size_t row = 0; row < parts.rows(); ++row) {
    mass += parts.number(row, parts.column("mass_kg"));
    along_y +=
        parts.number(row, parts.column("mass_kg")) * parts.number(row, parts.column("moved_y_m"));
  }
  EXPECT_NEAR(mass, kAll * kDensity, 1e-3);
  EXPECT_NEAR(along_y / mass, kToY * kFarY, 1e-5);  // digits of the table
}

// From the face to the hole, half a spacing beside the row where no hole stands.
TEST_F(Corner, PolygonsAreTheRockOfEachHole) {
  report_rows(folder(), {kCube, 0.25});
  const CsvTable table = CsvTable::read(folder().file("hole_polygons.csv"));
  std::map<std::string, std::vector<Vec2>> corners;
  for (size_t row = 0; row < table.rows(); ++row) {
    corners[std::string(table.word(row, 0))].emplace_back(table.number(row, 1),
                                                          table.number(row, 2));
    EXPECT_EQ(table.number(row, 3), 0.5 * kHeight);
  }
  ASSERT_EQ(corners.size(), 3U);
  EXPECT_NEAR(area_of(corners["a"]), kSide / kHeight, 1e-6);
  EXPECT_NEAR(area_of(corners["b"]), kAtCorner / kHeight, 1e-6);
  EXPECT_NEAR(area_of(corners["c"]), kSide / kHeight, 1e-6);
}

TEST_F(Corner, BarsAreAsWideAsTheirOwnHoles) {
  std::string table = kTable;
  table.replace(table.find("-2,-2,0,0.1"), 11, "-2,-2,0,0.2");
  write_text(folder().dump("holes.csv"), table);
  const auto bars = hole_bars(bench_scene(folder(), folder().rock()), -2.0);
  ASSERT_EQ(bars.size(), 4U);  // charges of b and c, and their stemming
  EXPECT_NEAR(bars[0].half, 0.1, 1e-12);
  EXPECT_NEAR(bars[1].half, 0.05, 1e-12);
}

// The rock's middle is at y = -4 m: hole c stands there and throws along y, and hole d, half a
// metre from there, stands behind b. Hole a is a metre from it.
TEST_F(Corner, TheSectionGoesThroughAHoleOfTheFrontRowThatThrowsAlongX) {
  std::string table = kTable;
  table.replace(table.find("c,-5,-2,3,-5,-2"), 15, "c,-5,-3,3,-5,-3");
  table += "d,-4,-3.5,3,-4,-3.5,0,0.1,1,3,0\n";
  write_text(folder().dump("holes.csv"), table);
  BurdenFile burdens{{burden_to({-2, -5, 0}, {0, -5, 0}), burden_to({-2, -2, 0}, {0, -2, 0}),
                      burden_to({-5, -3, 0}, {-5, 0, 0}), burden_to({-4, -3.5, 0}, {0, -3.5, 0})},
                     2.0};
  burdens.holes[3].in_front = 1;
  write_burdens((temporary_.path() / "dump/burden.csv").string(), burdens, "");
  BenchScene bench = bench_scene(folder(), folder().rock());
  ASSERT_NE(bench.planes.frames, nullptr);
  EXPECT_EQ(bench.planes.frames->holes()[3].row, 1);
  EXPECT_DOUBLE_EQ(y_of_middle_hole(bench, folder().rock()), -5.0);
  // Of holes that all throw along y the one next to the middle.
  std::erase_if(bench.charges, [](const Charge& charge) { return charge.toe.x() > -4.5; });
  EXPECT_DOUBLE_EQ(y_of_middle_hole(bench, folder().rock()), -3.0);
}

// The middle hole leans aside: without burdens that is refused, with them they are measured.
TEST_F(Corner, HolesThatAreNotParallelNeedTheirBurdens) {
  std::string table = kTable;
  table.replace(table.find("b,-2,-2,3"), 9, "b,-2,-3,3");
  write_text(folder().dump("holes.csv"), table);
  EXPECT_NO_THROW(report_rows(folder(), {kCube, 0.25}));
  std::filesystem::remove(folder().dump("burden.csv"));
  try {
    report_rows(folder(), {kCube, 0.25});
    FAIL() << "measured";
  } catch (const NotMeasurable& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("dump/burden.csv is missing"), std::string::npos)
        << refusal.what();
  }
}

TEST(HoleFrames, TellRowsPlanesAndFaces) {
  // One hole of each of two rows, throwing along y, behind a face that leans back by 0.25.
  const std::vector<Vec2> face{{0.0, 10.0}, {4.0, 9.0}};
  const HoleFrames frames(
      {{"front", {0, 8}, {0, 0}, {0, 1}, face, 0}, {"back", {0, 6}, {0, 0}, {0, 1}, face, 1}},
      {2.0, 3.0});
  EXPECT_EQ(frames.rows(), 2);
  EXPECT_DOUBLE_EQ(frames.depth(), 4.0);
  EXPECT_FALSE(frames.is_last(0));
  EXPECT_TRUE(frames.is_last(1));
  EXPECT_NEAR(frames.largest_turn(), 0.5 * M_PI, 1e-12);
  EXPECT_NEAR(frames.burden_at_floor(0), 2.0, 1e-12);
  EXPECT_NEAR(frames.behind_face({0, 8.5, 2.0}), 1.0, 1e-12);  // 9.5 - 8.5
  EXPECT_NEAR(frames.behind_face({0, 7.5, 6.0}), 1.0, 1e-12);  // straight on: 8.5 - 7.5
  EXPECT_NEAR(frames.row_depth({0, 8.5, 1.0}), 1.5, 1e-12);
  EXPECT_NEAR(frames.row_depth({0, 7.5, 1.0}), 2.5, 1e-12);
  EXPECT_NEAR(frames.row_depth({0, 6.5, 1.0}), 3.5, 1e-12);
  EXPECT_NEAR(frames.row_depth({0, 5.0, 1.0}), 5.0, 1e-12);
  EXPECT_TRUE(frames.abreast({1.4, 9, 1}));
  EXPECT_FALSE(frames.abreast({1.6, 9, 1}));
  EXPECT_TRUE(frames.beyond_toe({0, 9, 1}, {5, 10.1, 0}));
  EXPECT_FALSE(frames.beyond_toe({0, 9, 1}, {5, 9.9, 0}));
}

}  // namespace
}  // namespace muckpile
