// SPDX-License-Identifier: GPL-2.0-or-later
// Floors of surveyed ground against the planes and steps that were surveyed.
// Scope: no engine; that blocks rest on them is in tests/regression/floor_survey.sh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "args/input_error.h"
#include "geometry/files/panel_mesh.h"
#include "geometry/surface/ground_panels.h"
#include "geometry/surface/rock_body.h"

namespace muckpile {
namespace {

/// Points each metre over x from -5 to 20, y from -8 to 8 m, at z(x, y).
template <class Height>
GroundHeights surveyed(Height&& z) {
  SurveyedSurface survey;
  for (int x = -5; x <= 20; ++x)
    for (int y = -8; y <= 8; ++y) survey.points.emplace_back(x, y, z(x, y));
  return GroundHeights(terrain_triangles(survey), "ground");
}

double slope(double x, double y) { return -0.1 * x + 0.02 * y; }
constexpr FloorExtent kExtent{3.05, 120.0, -60.0, 60.0, 0.5};

double area_above(const SurveyedFloor& floor, double steepness) {
  double area = 0.0;
  for (const auto& [a, b, c] : floor.triangles) {
    const Vec3 twice = (b - a).cross(c - a);
    if (twice.z() > steepness * twice.norm()) area += 0.5 * twice.z();
  }
  return area;
}

TEST(SurveyedFloor, LiesOnASurveyedSlope) {
  const GroundHeights ground = surveyed(slope);
  EXPECT_NEAR(ground.at(7.3, -2.9), -0.1 * 7.3 - 0.02 * 2.9, 1e-12);  // -0.788
  const SurveyedFloor floor = surveyed_floor(ground, kExtent);
  for (const StlTriangle& triangle : floor.triangles)
    for (const Vec3& p : triangle) {
      const bool in_survey = p.x() <= 20.0 && std::abs(p.y()) <= 8.0;
      if (!in_survey) continue;
      EXPECT_NEAR(p.z(), slope(p.x(), p.y()), 1e-12);
    }
}

/// As high as at the nearest place of the survey: at x = 50, y = 30 that is its corner 20, 8.
TEST(SurveyedFloor, GoesOnBeyondTheSurvey) {
  const GroundHeights ground = surveyed(slope);
  EXPECT_NEAR(ground.at(50.0, 30.0), -0.1 * 20.0 + 0.02 * 8.0, 1e-12);  // -1.84
  EXPECT_NEAR(ground.at(50.0, 3.0), -0.1 * 20.0 + 0.02 * 3.0, 1e-12);   // -1.94
  EXPECT_NEAR(ground.at(10.0, -40.0), -0.1 * 10.0 - 0.02 * 8.0, 1e-12);
}

/// 116.95 by 120 m in plan. Panels of half a metre over 17 by 16 m and few beyond.
TEST(SurveyedFloor, CoversItsExtentOnce) {
  const SurveyedFloor floor = surveyed_floor(surveyed(slope), kExtent);
  EXPECT_NEAR(area_above(floor, 1e-9), 116.95 * 120.0, 1e-6);
  EXPECT_LT(floor.triangles.size(), 10000u);
  EXPECT_NEAR(floor.lowest, -2.0 - 0.16, 1e-12);  // at x = 20, y = -8 and beyond
  EXPECT_NEAR(floor.highest, -0.305 + 0.16, 1e-12);
}

/// Two levels with a step of 1.5 m between x = 10 and 11, which no panel is farther from than its
/// width.
TEST(SurveyedFloor, FollowsASurveyedStep) {
  const SurveyedFloor floor =
      surveyed_floor(surveyed([](double x, double) { return x > 10.5 ? 1.5 : 0.0; }), kExtent);
  for (const StlTriangle& triangle : floor.triangles)
    for (const Vec3& p : triangle) {
      if (p.x() <= 10.0) {
        EXPECT_EQ(p.z(), 0.0);
      } else if (p.x() >= 11.0) {
        EXPECT_EQ(p.z(), 1.5);
      }
    }
}

TEST(SurveyedFloor, TakesWiderPanelsForALargeSurvey) {
  const FloorExtent fine{3.05, 20.0, -8.0, 8.0, 0.01};
  const SurveyedFloor floor = surveyed_floor(surveyed(slope), fine);
  EXPECT_NEAR(floor.cell, std::sqrt(16.95 * 16.0 / 4e4), 1e-12);  // 0.082 m
  EXPECT_LT(floor.triangles.size(), 90000u);
}

TEST(SurveyedFloor, IsAsSurveyedWhereTheSurveyDoesNotReach) {
  const SurveyedFloor floor = surveyed_floor(surveyed(slope), {30.0, 60.0, 20.0, 40.0, 0.5});
  EXPECT_NEAR(floor.lowest, -1.84, 1e-12);
  EXPECT_NEAR(floor.highest, -1.84, 1e-12);
}

GroundPanels panels_on_a_slope(const std::vector<std::string>& more,
                               const std::string& x_lo = "3.05") {
  const std::string survey = testing::TempDir() + "slope.csv";
  std::ofstream out(survey);
  for (int x = -8; x <= 20; ++x)
    for (int y = -8; y <= 8; ++y) out << x << ',' << y << ',' << slope(x, y) << '\n';
  out.close();
  std::vector<std::string> words{"file", "f.stl", "ground", survey, x_lo, "120", "-60", "60"};
  words.insert(words.end(), more.begin(), more.end());
  return ground_panels(parse_args(write_panels_table(), "write_panels", words), "write_panels");
}

/// Areas of walls that stand at x or y = `place`, by where they look along that axis [m2].
struct WallAreas {
  double ahead = 0.0, back = 0.0;
};
WallAreas walls_at(const SurveyedFloor& floor, Eigen::Index axis, double place) {
  WallAreas areas;
  for (const auto& [a, b, c] : floor.triangles) {
    if (a[axis] != place || b[axis] != place || c[axis] != place) continue;
    const double area = 0.5 * (b - a).cross(c - a)[axis];
    (area > 0.0 ? areas.ahead : areas.back) += std::abs(area);
  }
  return areas;
}

/// From the lowest ground less a panel, 2.66 m deep, to the mean height -0.305 m.
TEST(GroundPanels, HaveAStepAtTheRock) {
  const GroundPanels made = panels_on_a_slope({"-2", "0.5"});
  const WallAreas step = walls_at(made.floor, 0, 3.05);
  EXPECT_NEAR(step.back, 120.0 * (2.66 - 0.305), 1e-6);
  EXPECT_EQ(step.ahead, 0.0);
  EXPECT_TRUE(made.under_rock.empty());
}

/// The front once, 116.95 by 120 m, and beside rock from x = -4 to 3.05 the strips y < -3 and y >
/// 5, 57 and 55 m wide: 7.05 by 112 m more. The rock stands between on a floor at z = -2, with
/// walls along it and nothing beneath the ground beside it.
TEST(GroundPanels, LieBesideTheRock) {
  const GroundPanels made = panels_on_a_slope({"-2", "0.5", "beside", "-4", "-3", "5"});
  EXPECT_NEAR(area_above(made.floor, 1e-9), 116.95 * 120.0 + 7.05 * 112.0, 1e-6);
  // Mean heights at x = -0.475: 0.0475 and 0.02 y; at x = 3.05 over y: -0.305 + 0.02.
  const WallAreas high = walls_at(made.floor, 1, 5.0), low = walls_at(made.floor, 1, -3.0),
                  step = walls_at(made.floor, 0, 3.05);
  EXPECT_NEAR(high.back, 7.05 * (0.0475 + 0.1 + 2.0), 1e-6);  // looks to -y, at the rock
  EXPECT_EQ(high.ahead, 0.0);
  EXPECT_NEAR(low.ahead, 7.05 * (0.0475 - 0.06 + 2.0), 1e-6);
  EXPECT_EQ(low.back, 0.0);
  EXPECT_NEAR(step.back, 8.0 * (-0.305 + 0.02 + 2.0), 1e-6);
  EXPECT_EQ(step.ahead, 0.0);
  ASSERT_EQ(made.under_rock.size(), 2U);
  for (const StlTriangle& triangle : made.under_rock)
    for (const Vec3& p : triangle) {
      EXPECT_TRUE(p.x() == -4.0 || p.x() == 3.05);
      EXPECT_TRUE(p.y() == -3.0 || p.y() == 5.0);
      EXPECT_EQ(p.z(), -2.0);
    }
}

/// The rock stands at the height of the ground in front of it at y = 0: for y > 0 a wall rises 0.02
/// y to the ground, 0.01 * 5^2 in all, for y < 0 one falls to it, 0.01 * 3^2, and looks at the pit.
TEST(GroundPanels, FallLowerThanTheRockStands) {
  const GroundPanels made = panels_on_a_slope({"-0.305", "0.5", "beside", "-4", "-3", "5"});
  const WallAreas step = walls_at(made.floor, 0, 3.05);
  EXPECT_NEAR(step.back, 0.25, 1e-9);
  EXPECT_NEAR(step.ahead, 0.09, 1e-9);
  EXPECT_NEAR(made.floor.lowest, -2.16, 1e-12);
}

/// Beside the rock the survey is so large, 23 by 16 m, that panels are wider than asked for: those
/// in front are, too, so that both share their corners.
TEST(GroundPanels, AreAsWideInFrontAsBeside) {
  const GroundPanels made = panels_on_a_slope({"-2", "0.01", "beside", "-60", "-3", "5"}, "15");
  EXPECT_NEAR(made.floor.cell, std::sqrt(23.0 * 16.0 / 4e4), 1e-12);
  std::set<double> front, beside;  // y of corners at x_lo
  for (const StlTriangle& t : made.floor.triangles) {
    const double least = std::min({t[0].x(), t[1].x(), t[2].x()});
    const bool stands = t[0].x() == t[1].x() && t[1].x() == t[2].x();
    for (const Vec3& p : t)
      if (!stands && p.x() == 15.0 && p.y() > 5.0) (least < 15.0 ? beside : front).insert(p.y());
  }
  EXPECT_EQ(front, beside);
}

std::string refusal_of(const std::vector<std::string>& words) {
  try {
    (void)ground_panels(parse_args(write_panels_table(), "write_panels", words), "write_panels");
  } catch (const InputError& refused) {
    return refused.what();
  }
  return "";
}

TEST(GroundPanels, RefusesWhatIsNoGround) {
  EXPECT_EQ(refusal_of({"file", "f.stl", "unit", "1"}), "write_panels: unit needs ground");
  EXPECT_EQ(
      refusal_of({"file", "f.stl", "ground", "s.csv", "3", "1", "-1", "1", "0", "1"}),
      "write_panels: ground needs x and y that rise, got x from '3' to '1' and y from '-1' to "
      "'1'");
  EXPECT_EQ(refusal_of({"file", "f.stl", "ground", "s.csv", "1", "3", "-1", "1", "0", "0"}),
            "write_panels: ground needs panels wider than 0 m, got '0'");
  const std::string line = testing::TempDir() + "line.csv";
  std::ofstream(line) << "0,0,0\n1,0,0\n2,0,0\n";
  EXPECT_EQ(refusal_of({"file", "f.stl", "ground", line, "1", "3", "-1", "1", "0", "1"}),
            "write_panels: ground " + line +
                ": must have ground that looks up, on more than one line in plan");
}

// A survey of 48 x 40 m, in millimetres, beside a floor of 117 x 120 m: 410 and 333 times as large.
TEST(GroundPanels, RefusesMillimetresUnlessUnitSaysSo) {
  const std::string survey = testing::TempDir() + "millimetres.csv";
  std::ofstream out(survey);
  for (int x = -20000; x <= 28000; x += 2000)
    for (int y = -20000; y <= 20000; y += 2000) out << x << ',' << y << ',' << 0.5 * y << '\n';
  out.close();
  std::vector<std::string> words{"file", "f.stl", "ground", survey, "3",   "120",
                                 "-60",  "60",    "-20",    "1",    "unit"};
  words.emplace_back("auto");
  const std::string got = refusal_of(words);
  EXPECT_NE(
      got.find("write_panels: ground " + survey + ": must be in metres, got one from -20000 "),
      std::string::npos)
      << got;
  EXPECT_NE(got.find("beside a floor from 3 -60 0 to 120 60 1 m; it looks like millimetres: give "
                     "unit 0.001, or unit 1 if it is in metres (inputs/quarry: -var terrain_unit)"),
            std::string::npos)
      << got;
  words.back() = "0.001";
  const GroundPanels made =
      ground_panels(parse_args(write_panels_table(), "write_panels", words), "write_panels");
  EXPECT_NEAR(made.floor.highest, 10.0, 1e-9);
  words.back() = "1";
  EXPECT_EQ(refusal_of(words), "");
  words.back() = "mm";
  EXPECT_EQ(refusal_of(words), "write_panels: unit must be a number in m, got 'mm'");
}

/// Level ground at z = 0 to x = 20 and at z = 4 from x = 19.3 on, with the face between them.
std::string overhanging_face() {
  const std::string survey = testing::TempDir() + "overhang.stl";
  std::ofstream out(survey);
  out << "solid s\n";
  const auto quad = [&](double x0, double z0, double x1, double z1) {
    const auto corner = [&](double x, double y, double z) {
      out << "vertex " << x << ' ' << y << ' ' << z << '\n';
    };
    out << "facet normal 0 0 0\nouter loop\n";
    corner(x0, 0.0, z0), corner(x1, 0.0, z1), corner(x1, 40.0, z1);
    out << "endloop\nendfacet\nfacet normal 0 0 0\nouter loop\n";
    corner(x0, 0.0, z0), corner(x1, 40.0, z1), corner(x0, 40.0, z0);
    out << "endloop\nendfacet\n";
  };
  quad(0.0, 0.0, 20.0, 0.0);
  quad(20.0, 0.0, 19.3, 4.0);
  quad(19.3, 4.0, 40.0, 4.0);
  out << "endsolid s\n";
  return survey;
}

TEST(GroundPanels, TakeAFaceThatHangsOverSomewhat) {
  EXPECT_EQ(refusal_of({"file", "f.stl", "ground", overhanging_face(), "0", "40", "0", "40", "-1",
                        "0.5", "unit", "1"}),
            "");
}

// The slope's survey ends at x = -8 and begins at x = 20: a file in other coordinates would be a
// level floor at the height of its nearest point.
TEST(GroundPanels, RefusesASurveyOfAnotherPlace) {
  try {
    (void)panels_on_a_slope({"-2", "0.5", "origin", "5000", "0", "0"});
    FAIL() << "made";
  } catch (const InputError& refused) {
    EXPECT_NE(std::string(refused.what())
                  .find("must have points of the floor, x = 3.05 to 120 and y = -60 to 60 m of the "
                        "run; they lie at x = -5008 to -4980 and y = -8 to 8 m: give the place"),
              std::string::npos)
        << refused.what();
  }
}

TEST(GroundPanels, TellWhereASurveyBeginsInFrontOfTheRock) {
  EXPECT_EQ(panels_on_a_slope({"-2", "0.5"}).told.find("WARNING"), std::string::npos);
  const GroundPanels made = panels_on_a_slope({"-2", "0.5"}, "-30");
  EXPECT_NE(
      made.told.find("WARNING: the survey begins at x = -8 m, the floor at x = -30 m; between "
                     "them the floor is as high as the survey's edge"),
      std::string::npos)
      << made.told;
}

}  // namespace
}  // namespace muckpile
