// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command survey: volumes, heights and toes by hand, files as points and triangles, and every
// file that is refused.
// Scope: the made-up bench, whose pile has steps 1 m long and 0.65 m high, against made-up surveys.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <sstream>

#include "args/csv_table.h"
#include "geometry/files/point_file.h"
#include "geometry/files/stl_file.h"
#include "input_error_of.h"
#include "measure/surface_comparison.h"
#include "measure/survey_heights.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kCell = 0.125;  // of the measuring columns [m]

// Top of the made-up bench after its blast, on a floor that falls by so much per metre.
double run_height(double x, double fall = 0.0) {
  if (x < -kBurden) return kBenchHeight;
  if (x < 0.0) return 0.0;
  if (x > kSteps) return -fall * x;
  const double middle = (std::floor(x / kCube) + 0.5) * kCube;  // of the column of cubes [m]
  return kLayer * (kSteps - std::floor(x)) - fall * middle;
}

// Planes that rise by 3 in 4 and are 0.5 m apart along their normal: 0.5/0.8 = 0.625 m vertically.
// Compared 2 m within the run's edge, where each foot is on its surface.
TEST(SurfaceDistance, OfAPlaneMovedAlongItsNormalIsTheMove) {
  SurfacePair pair{column_grid(0.0, 10.0, 0.0, 10.0, 0.25), {}, {}, {}};
  for (int j = 0; j < pair.grid.ny; ++j) {
    for (int i = 0; i < pair.grid.nx; ++i) {
      const double x = pair.grid.x(i), y = pair.grid.y(j);
      pair.run.push_back(0.75 * x);
      pair.survey.push_back(0.75 * x - 0.625);
      pair.compared.push_back(x > 2.0 && x < 8.0 && y > 2.0 && y < 8.0 ? 1 : 0);
    }
  }
  const SurfaceDistance distance = distance_of(pair);
  EXPECT_NEAR(distance.mean, 0.5, 1e-12);
  EXPECT_NEAR(distance.rms, 0.5, 1e-12);
  EXPECT_NEAR(distance.p90, 0.5, 1e-12);
  EXPECT_NEAR(difference_of(pair).mean, 0.625, 1e-12);
}

// A wall 8 m high that the survey has one column farther on: vertically 8 m off there, in truth
// one column at most, as the wall is a steep triangle between two columns.
TEST(SurfaceDistance, OfAWallIsAcrossIt) {
  SurfacePair pair{column_grid(0.0, 10.0, 0.0, 5.0, 0.25), {}, {}, {}};
  for (int j = 0; j < pair.grid.ny; ++j) {
    for (int i = 0; i < pair.grid.nx; ++i) {
      pair.run.push_back(i < 20 ? 8.0 : 0.0);
      pair.survey.push_back(i < 21 ? 8.0 : 0.0);
      pair.compared.push_back(1);
    }
  }
  EXPECT_LE(distance_of(pair).mean, 0.25 / pair.grid.nx);
  EXPECT_NEAR(difference_of(pair).mean, -8.0 / pair.grid.nx, 1e-12);
}

class Survey : public ::testing::Test {
 protected:
  void SetUp() override { write_bench(temporary_.path()); }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] nlohmann::ordered_json summary() const {
    return read_json_object(folder().file("summary.json"));
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (temporary_.path() / name).string();
  }
  // A point at the middle of each column and beyond, `lower` than the run [m].
  std::string points(double lower, const std::function<Vec3(const Vec3&)>& in_file,
                     double fall = 0.0) const {
    std::ostringstream out;
    out.precision(12);
    for (double y = -2.0 + 0.5 * kCell; y < 2.0; y += kCell) {
      for (double x = -10.0 + 0.5 * kCell; x < 16.0; x += kCell) {
        const Vec3 p = in_file({x, y, run_height(x, fall) - lower});
        out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
      }
    }
    return out.str();
  }
  void measure(const std::string& file, SurveyOptions options = {}) const {
    options.surface = path(file);
    report_survey(folder(), {kCube, kCell}, options);
  }
  [[nodiscard]] std::string refused(const std::string& name, const std::string& text,
                                    const SurveyOptions& options = {}) const {
    write_text(temporary_.path() / name, text);
    return input_error_of([&] { measure(name, options); });
  }
  TemporaryFolder temporary_;
};

void expect_in(const std::string& part, const std::string& whole) {
  EXPECT_NE(whole.find(part), std::string::npos) << whole;
}

// Compared is the rock: 3 m behind the hole and 14 m of pile, 2 m wide. Where the run has been
// thrown away, both are floor.
void expect_low_survey(const nlohmann::ordered_json& keys) {
  EXPECT_NEAR(keys["survey_compared_area_m2"], 34.0, 1e-9);
  EXPECT_NEAR(keys["survey_compared_pile_fraction"], 1.0, 1e-12);
  EXPECT_NEAR(keys["survey_run_above_m3"], 6.8, 1e-5);
  EXPECT_NEAR(keys["survey_run_below_m3"], 0.0, 1e-5);
  EXPECT_NEAR(keys["survey_mean_difference_m"], 0.2, 1e-6);
  EXPECT_NEAR(keys["survey_rms_difference_m"], 0.2, 1e-6);
  EXPECT_NEAR(keys["survey_p90_difference_m"], 0.2, 1e-6);
  EXPECT_LE(keys["survey_mean_distance_m"], 0.2);
  EXPECT_NEAR(keys["survey_p90_distance_m"], 0.2, 1e-6);
  EXPECT_NEAR(keys["survey_run_height_m"], 9.1, 1e-6);
  EXPECT_NEAR(keys["survey_height_m"], 8.9, 1e-6);
  // One block, 0.5 m, between 0.65 and 0 m at x = 13.9375 and 14.0625; of the survey between 1.1
  // and 0.45 m, a step before.
  EXPECT_NEAR(keys["survey_run_toe_m"], 13.9375 + 0.125 * 0.15 / 0.65, 1e-6);
  EXPECT_NEAR(keys["survey_toe_m"], 12.9375 + 0.125 * 0.60 / 0.65, 1e-6);
}

TEST_F(Survey, ThatLiesLowerIsLowerByAsMuch) {
  write_text(temporary_.path() / "pile.xyz", points(0.2, [](const Vec3& p) { return p; }));
  measure("pile.xyz");
  expect_low_survey(summary());
  EXPECT_EQ(summary()["survey_file"], "pile.xyz");
  EXPECT_GT(std::filesystem::file_size(folder().file("survey.png")), 2000U);
}

// On a floor that falls by 1 in 10 the rock is what it is on a level one, whatever the rock stood
// on; heights over the floor and toes are not measured there.
TEST_F(Survey, OfAPileOnASlopeIsLowerByAsMuch) {
  put_on_slope(temporary_.path(), 0.1);
  write_text(temporary_.path() / "pile.xyz", points(
                                                 0.2, [](const Vec3& p) { return p; }, 0.1));
  measure("pile.xyz");
  const nlohmann::ordered_json keys = summary();
  EXPECT_NEAR(keys["survey_compared_area_m2"], 34.0, 1e-9);
  EXPECT_NEAR(keys["survey_compared_pile_fraction"], 1.0, 1e-12);
  EXPECT_NEAR(keys["survey_run_above_m3"], 6.8, 1e-5);
  EXPECT_NEAR(keys["survey_run_below_m3"], 0.0, 1e-5);
  EXPECT_NEAR(keys["survey_p90_difference_m"], 0.2, 1e-6);
  EXPECT_TRUE(keys["survey_height_m"].is_null());
  EXPECT_TRUE(keys["survey_run_toe_m"].is_null());
}

// What lies on the floor of the survey alone is compared with that floor: half a metre of rock that
// the run does not have, from x = 14.5 to 15.5 m.
TEST_F(Survey, OfRockThatTheRunDoesNotHaveIsComparedWithTheSlope) {
  put_on_slope(temporary_.path(), 0.1);
  write_text(temporary_.path() / "pile.xyz", points(
                                                 0.0,
                                                 [](const Vec3& p) {
                                                   const bool more = p.x() > 14.5 && p.x() < 15.5;
                                                   return Vec3(p + Vec3(0, 0, more ? 0.5 : 0.0));
                                                 },
                                                 0.1));
  measure("pile.xyz");
  EXPECT_NEAR(summary()["survey_compared_area_m2"], 36.0, 1e-9);
  EXPECT_NEAR(summary()["survey_run_below_m3"], 0.5 * 1.0 * 2.0, 1e-5);
  EXPECT_NEAR(summary()["survey_run_above_m3"], 0.0, 1e-5);
}

// The bench goes on beside the model, which ends at |y| = 1 m; how is not known. Compared are
// the 34 m2 as ever, and the block, 0.5 m high on 0.25 m2, over a surveyed floor at -0.2 m.
TEST_F(Survey, OfABlockThatRestsAsideHasNoFloorInTheBenchBesideTheModel) {
  BenchRun run = bench_run();
  run.last.states[0].centre = {2.0, 6.0, 0.25};  // from below the floor
  write_snapshot(folder().dump("blocks_000002000.csv"), run.blocks, run.last);
  std::ostringstream wide;
  for (double y = -2.0 + 0.5 * kCell; y < 7.0; y += kCell) {
    for (double x = -10.0 + 0.5 * kCell; x < 16.0; x += kCell) {
      const double height = x < 0.0 || std::abs(y) < 1.0 ? run_height(x) : 0.0;
      wide << x << ' ' << y << ' ' << height - 0.2 << '\n';
    }
  }
  write_text(temporary_.path() / "pile.xyz", wide.str());
  measure("pile.xyz");
  EXPECT_NEAR(summary()["survey_compared_area_m2"], 34.25, 1e-9);
  EXPECT_NEAR(summary()["survey_run_below_m3"], 0.0, 1e-5);
  EXPECT_NEAR(summary()["survey_run_above_m3"], 6.8 + 0.25 * 0.7, 1e-5);
}

TEST_F(Survey, TableHasEachComparedColumn) {
  write_text(temporary_.path() / "pile.xyz", points(0.2, [](const Vec3& p) { return p; }));
  measure("pile.xyz");
  const CsvTable table = CsvTable::read(folder().file("survey.csv"));
  ASSERT_EQ(table.rows(), 34U * 64U);
  EXPECT_NEAR(table.number(0, table.column("x_m")), -8.0 + 0.5 * kCell, 1e-4);
  EXPECT_NEAR(table.number(0, table.column("run_m")), 10.5, 1e-4);
  EXPECT_NEAR(table.number(0, table.column("survey_m")), 10.3, 1e-4);
  EXPECT_NEAR(table.number(0, table.column("difference_m")), 0.2, 1e-5);
}

TEST_F(Survey, OfAMineGridIsShiftedThenTurned) {
  // In the file north is the throw: the run's (x, y) = (north, -east), after the shift.
  const Vec3 origin(355000.0, 6200000.0, 412.0);
  write_text(temporary_.path() / "pile.csv",
             points(0.2, [&](const Vec3& p) { return Vec3(Vec3(-p.y(), p.x(), p.z()) + origin); }));
  SurveyOptions options;
  options.shift = {-origin.x(), -origin.y(), -origin.z()};
  options.turn_deg = -90.0;
  measure("pile.csv", options);
  expect_low_survey(summary());
  EXPECT_EQ(summary()["survey_turn_deg"], -90.0);
}

TEST_F(Survey, InFeetIsTold) {
  write_text(temporary_.path() / "pile.txt",
             points(0.2, [](const Vec3& p) { return Vec3(p / 0.3048); }));
  SurveyOptions options;
  options.unit = 0.3048;
  measure("pile.txt", options);
  expect_low_survey(summary());
}

TEST_F(Survey, PartOfThePileIsComparedOnThatPart) {
  std::istringstream all(points(0.2, [](const Vec3& p) { return p; }));
  std::ostringstream some;
  for (std::string line; std::getline(all, line);)
    if (line[0] != '-' && std::stod(line) < 7.0) some << line << '\n';
  write_text(temporary_.path() / "pile.xyz", some.str());
  measure("pile.xyz");
  EXPECT_NEAR(summary()["survey_compared_pile_fraction"], 0.5, 0.01);
  EXPECT_NEAR(summary()["survey_mean_difference_m"], 0.2, 1e-6);
  EXPECT_TRUE(summary()["survey_toe_m"].is_null());  // it ends high above the floor
  EXPECT_NEAR(summary()["survey_height_m"], 8.9, 1e-6);
}

TEST_F(Survey, AcrossAGapHasNoHeights) {
  std::istringstream all(points(0.2, [](const Vec3& p) { return p; }));
  std::ostringstream some;
  for (std::string line; std::getline(all, line);)
    if (const double x = std::stod(line); x < 4.0 || x > 8.0) some << line << '\n';
  write_text(temporary_.path() / "pile.xyz", some.str());
  measure("pile.xyz");
  EXPECT_NEAR(summary()["survey_compared_pile_fraction"], 10.0 / 14.0, 0.02);
}

// Two triangles at z = 1 m. The run is higher by the sum of 0.65 k - 1 over k = 2 to 14, 54.6, and
// by 9.5 over 3 m, lower by 0.35 at the last step, by 1 over the 5 m dug out, and over the floor
// from the pile's toe to the end of the survey at 16 m; all 2 m wide.
void expect_plane(const nlohmann::ordered_json& keys) {
  EXPECT_NEAR(keys["survey_run_above_m3"], 2.0 * (54.6 + 28.5), 1e-4);
  EXPECT_NEAR(keys["survey_run_below_m3"], 2.0 * (0.35 + 5.0 + 2.0), 1e-4);
  EXPECT_NEAR(keys["survey_volume_difference_m3"], 2.0 * (83.1 - 7.35), 1e-4);
  EXPECT_NEAR(keys["survey_compared_area_m2"], 48.0, 1e-9);
}

constexpr const char* kPlane =
    "solid pile\nfacet normal 0 0 1\nouter loop\nvertex -10 -2 1\nvertex 16 -2 1\nvertex 16 2 1\n"
    "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex -10 -2 1\nvertex 16 2 1\n"
    "vertex -10 2 1\nendloop\nendfacet\nendsolid pile\n";

// The two triangles of the plane, each a solid of its own.
std::string two_solids() {
  std::string text = kPlane;
  return text.insert(text.find("facet", text.find("endfacet") + 8),
                     "endsolid pile\n\nsolid more of it\n");
}

std::string binary_plane(float z) {
  std::string bytes(80, ' ');
  const auto add = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  add(std::uint32_t{2});
  const float corners[2][9] = {{-10, -2, z, 16, -2, z, 16, 2, z},
                               {-10, -2, z, 16, 2, z, -10, 2, z}};
  for (const auto& triangle : corners) {
    bytes.append(12, '\0');  // the normal, which is not read
    for (const float each : triangle) add(each);
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST_F(Survey, TrianglesAreReadFromTextAndBytes) {
  write_text(temporary_.path() / "text.stl", kPlane);
  measure("text.stl");
  expect_plane(summary());
  write_text(temporary_.path() / "solids.stl", two_solids());
  measure("solids.stl");
  expect_plane(summary());
  write_text(temporary_.path() / "bytes.STL", binary_plane(1.0F));
  measure("bytes.STL");
  expect_plane(summary());
}

TEST_F(Survey, FarFromTheRunSaysHowToShiftIt) {
  const Vec3 origin(355000.0, 6200000.0, 412.0);
  const std::string far = points(0.0, [&](const Vec3& p) { return Vec3(p + origin); });
  const std::string message = refused("far.xyz", far);
  expect_in("far.xyz: does not overlap the run", message);
  expect_in("x 354990.1 to 355015.9", message);
  expect_in("for a start by --shift -35", message);
  SurveyOptions in_plan;
  in_plan.shift = {-355000.0, -6200000.0, 0.0};
  expect_in("z 412 to 422.5", refused("far.xyz", far, in_plan));
  expect_in(" -412", refused("far.xyz", far, in_plan));
}

TEST_F(Survey, ThatIsTurnedAndFarIsTakenWithThePrintedShift) {
  const Vec3 origin(355000.0, 6200000.0, 412.0);
  SurveyOptions options;
  options.turn_deg = -90.0;
  const std::string message =
      refused("far.xyz",
              points(0.0, [&](const Vec3& p) { return Vec3(Vec3(-p.y(), p.x(), p.z()) + origin); }),
              options);
  const std::string words = "for a start by --shift ";
  ASSERT_NE(message.find(words), std::string::npos) << message;
  std::istringstream shift(message.substr(message.find(words) + words.size()));
  for (double& each : options.shift) shift >> each;
  ASSERT_FALSE(shift.fail()) << message;
  EXPECT_NO_THROW(measure("far.xyz", options));
}

// Over cells 0.1 m wide, heights of a wall from z = 0 to 10 m that leans by 1e-7 m.
TEST(SurveyedWall, HasHeightsWithinItsCorners) {
  const ColumnGrid grid{6.2e6, 0.0, 0.1, 0.1, 50, 10};
  SurveyedSurface wall;
  for (int i = 0; i < grid.nx; ++i) {
    const double x = grid.x(i);
    wall.triangles.push_back({Vec3(x - 1e-7, 0.0, 0.0), {x + 1e-7, 0.0, 10.0}, {x, 1.0, 5.0}});
  }
  for (const double height : heights_over(grid, wall, std::nullopt)) {
    if (std::isnan(height)) continue;
    EXPECT_GE(height, 0.0);
    EXPECT_LE(height, 10.0);
  }
}

TEST(SurveyedWall, ThatStandsUprightHasNone) {
  const ColumnGrid grid{0.0, 0.0, 1.0, 1.0, 1, 1};
  SurveyedSurface wall;
  wall.triangles.push_back({Vec3(0.5, 0.0, 0.0), {0.5 + 1e-12, 2.0, 0.0}, {0.5, 1.0, 10.0}});
  EXPECT_TRUE(std::isnan(heights_over(grid, wall, std::nullopt)[0]));
}

// Two strips of points 0.5 m apart, 6 m from each other.
TEST(SurveyedPoints, AcrossAGapAreNotJoinedWhereOneStraysFarOff) {
  const ColumnGrid grid{0.0, 0.0, 0.5, 0.5, 24, 8};
  SurveyedSurface strips;
  for (double y = 0.25; y < 4.0; y += 0.5)
    for (double x = 0.25; x < 12.0; x += 0.5)
      if (x < 3.0 || x > 9.0) strips.points.emplace_back(x, y, 1.0);
  const auto in_the_gap = [&] { return heights_over(grid, strips, std::nullopt)[grid.at(12, 4)]; };
  EXPECT_TRUE(std::isnan(in_the_gap()));
  strips.points.emplace_back(5000.0, 5000.0, 0.0);
  EXPECT_TRUE(std::isnan(in_the_gap()));
}

// As grids mark what was not surveyed.
TEST_F(Survey, HeightsThatStandForNoDataAreRefused) {
  std::istringstream all(points(0.2, [](const Vec3& p) { return p; }));
  std::string holed;
  for (std::string line; std::getline(all, line);)
    holed +=
        line.starts_with("3.0625 ") ? line.substr(0, line.rfind(' ')) + " -9999\n" : line + "\n";
  expect_in("pile.xyz: has the height -9999 m at x = 3.0", refused("pile.xyz", holed));
  expect_in("leave out points that stand for no data", refused("pile.xyz", holed));
}

// The advice is about the surveyed ground, which is wrong in height only, however much of the file
// has no data.
TEST_F(Survey, NumbersForNoDataDoNotChangeTheAdvisedShift) {
  std::istringstream all(points(0.0, [](const Vec3& p) { return Vec3(p + Vec3(0, 0, 412)); }));
  std::string holed;
  int number = 0;
  for (std::string line; std::getline(all, line); ++number)
    holed += number % 3 == 0 ? line + "\n" : line.substr(0, line.rfind(' ')) + " -9999\n";
  const std::string error = refused("pile.xyz", holed);
  expect_in("pile.xyz: does not overlap the run", error);
  expect_in("z 412 to 42", error);
  expect_in(" -412", error);
}

// Its walls are higher than any bench, and most of its points are far above the run.
TEST_F(Survey, AWholePitMayLieAboveTheRun) {
  std::string pit = points(0.0, [](const Vec3& p) { return p; });
  for (int k = 0; k < 2000; ++k)
    pit += std::to_string(500 + k) + " 700 " + std::to_string(600.0 + 0.3 * k) + "\n";
  write_text(temporary_.path() / "pit.xyz", pit);
  EXPECT_NO_THROW(measure("pit.xyz"));
}

TEST_F(Survey, PointFilesAreRefusedByLine) {
  expect_in("a.xyz:2: expected 3 fields as in the lines before, got 2",
            refused("a.xyz", "1 2 3\n4 5\n"));
  expect_in("a.xyz:2: z must be a finite number, got 'nan'", refused("a.xyz", "1 2 3\n4 5 nan\n"));
  expect_in("a.xyz:3: y must be a finite number, got 'b'",
            refused("a.xyz", "# remark\n1 2 3\n4 b 6\n"));
  expect_in("a.csv:1: a header must name one of z, z_m", refused("a.csv", "x,y,depth\n1,2,3\n"));
  expect_in("a.csv:2: x must be a finite number, got '1,5'", refused("a.csv", "2;3;4\n1,5;2;3\n"));
  expect_in("a.csv: must have three points at least, got 0", refused("a.csv", ""));
  expect_in("a.laz: must be a surface in one of .xyz", refused("a.laz", "LASF"));
  expect_in("none.xyz: cannot be opened", input_error_of([&] { measure("none.xyz"); }));
}

TEST_F(Survey, StlFilesAreRefusedByLine) {
  std::string text = kPlane;
  expect_in("a.stl: ends at line 9 without endsolid: it is cut",
            refused("a.stl", text.substr(0, text.find("outer", 60))));
  text.replace(text.find("16 -2 1"), 7, "16 2 1");  // on the third corner
  expect_in("a.stl:8: the triangle at (-10, -2, 1) has no area", refused("a.stl", text));
  text = kPlane;
  text.replace(text.find("16 -2 1"), 7, "16 x 1");
  expect_in("a.stl:5: vertex must be a finite number, got 'x'", refused("a.stl", text));
  text.replace(text.find("16 x 1"), 6, "16 1");
  expect_in("a.stl:5: vertex must have three numbers, got 2", refused("a.stl", text));
  text = kPlane;
  text.replace(text.find("endfacet\n"), 9, "");
  expect_in("a.stl:8: facet before the endfacet of the facet before", refused("a.stl", text));
  expect_in("a.stl:18: must begin with solid after endsolid, got 'facet'",
            refused("a.stl", kPlane + std::string("\nfacet normal 0 0 1\n")));
  const std::string bytes = binary_plane(1.0F);
  expect_in("a.stl: must have 184 bytes for its 2 triangles, got 180; it is cut",
            refused("a.stl", bytes.substr(0, 180)));
  expect_in("a.stl: triangle 1: has a coordinate of 6.2e+06, which a binary STL holds to 0.5 m",
            refused("a.stl", binary_plane(6.2e6F)));
  expect_in("a.stl: is empty", refused("a.stl", ""));
  expect_in("a.stl: has no triangles", refused("a.stl", "solid\nendsolid\n"));
}

TEST_F(Survey, OfARunInMotionIsNotMeasured) {
  write_text(temporary_.path() / "text.stl", kPlane);
  measure("text.stl");
  const auto run = temporary_.path() / "dump/run.json";
  std::string text = text_of(run);
  write_text(run, text.replace(text.find("\"still\": true"), 13, "\"still\": false"));
  EXPECT_THROW(measure("text.stl"), NotMeasurable);
  EXPECT_FALSE(std::filesystem::exists(folder().file("survey.csv")));
  EXPECT_FALSE(summary().contains("survey_run_above_m3"));
  EXPECT_TRUE(summary().contains("survey_refused"));
}

TEST(SurveyOfACrater, ReachesBelowTheSurface) {
  TemporaryFolder temporary;
  write_crater(temporary.path());
  std::string plane = binary_plane(-1.0F);
  write_text(temporary.path() / "plane.stl", plane);
  SurveyOptions options;
  options.surface = (temporary.path() / "plane.stl").string();
  report_survey(ResultFolder(temporary.path()), {0.0, kCell}, options);
  const auto keys = read_json_object(temporary.path() / "summary.json");
  // The pit is 2 m deep and reaches over the whole width of the plane, |y| < 2 m, from -3.5 m at
  // least: lower by a metre there, higher by one elsewhere.
  const double below = keys["survey_run_below_m3"];
  EXPECT_GT(below, 4.0 * 7.0);
  EXPECT_LT(below, 4.0 * 8.0);
  EXPECT_TRUE(keys["survey_toe_m"].is_null());
}

}  // namespace
}  // namespace muckpile
