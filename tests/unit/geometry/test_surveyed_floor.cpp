// SPDX-License-Identifier: GPL-2.0-or-later
// Floors of surveyed ground against the planes and steps that were surveyed.
// Scope: no engine; that blocks rest on them is in tests/regression/floor_survey.sh.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

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
constexpr FloorExtent kExtent{3.05, 120.0, -60.0, 60.0, -2.0, 0.5};

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
      const bool of_step = p.x() == 3.05 && p.z() < floor.lowest;
      if (!in_survey || of_step) continue;
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

/// Floor and step once each: 116.95 by 120 m in plan, and a step without area in plan. Panels of
/// half a metre over 17 by 16 m and few beyond.
TEST(SurveyedFloor, CoversItsExtentOnce) {
  const SurveyedFloor floor = surveyed_floor(surveyed(slope), kExtent);
  EXPECT_NEAR(area_above(floor, 1e-9), 116.95 * 120.0, 1e-6);
  EXPECT_LT(floor.triangles.size(), 10000u);
  EXPECT_NEAR(floor.lowest, -2.0 - 0.16, 1e-12);  // at x = 20, y = -8 and beyond
  EXPECT_NEAR(floor.highest, -0.305 + 0.16, 1e-12);
  double step = 0.0;
  for (const auto& [a, b, c] : floor.triangles) {
    const Vec3 twice = (b - a).cross(c - a);
    if (std::abs(twice.z()) > 1e-12 * twice.norm()) continue;
    EXPECT_LT(twice.x(), 0.0);  // looks at the rock
    step += 0.5 * twice.norm();
  }
  // From the lowest ground less a panel, 2.66 m deep, to the mean height -0.305 m.
  EXPECT_NEAR(step, 120.0 * (2.66 - 0.305), 1e-6);
}

/// Two levels with a step of 1.5 m between x = 10 and 11, which no panel is farther from than its
/// width.
TEST(SurveyedFloor, FollowsASurveyedStep) {
  const SurveyedFloor floor =
      surveyed_floor(surveyed([](double x, double) { return x > 10.5 ? 1.5 : 0.0; }), kExtent);
  for (const StlTriangle& triangle : floor.triangles)
    for (const Vec3& p : triangle) {
      if (p.z() < 0.0) continue;  // of the step at the rock
      if (p.x() <= 10.0) {
        EXPECT_EQ(p.z(), 0.0);
      } else if (p.x() >= 11.0) {
        EXPECT_EQ(p.z(), 1.5);
      }
    }
}

TEST(SurveyedFloor, TakesWiderPanelsForALargeSurvey) {
  const FloorExtent fine{3.05, 20.0, -8.0, 8.0, -2.0, 0.01};
  const SurveyedFloor floor = surveyed_floor(surveyed(slope), fine);
  EXPECT_NEAR(floor.cell, std::sqrt(16.95 * 16.0 / 4e4), 1e-12);  // 0.082 m
  EXPECT_LT(floor.triangles.size(), 90000u);
}

TEST(SurveyedFloor, IsAsSurveyedWhereTheSurveyDoesNotReach) {
  const SurveyedFloor floor = surveyed_floor(surveyed(slope), {30.0, 60.0, 20.0, 40.0, -9.0, 0.5});
  EXPECT_NEAR(floor.lowest, -1.84, 1e-12);
  EXPECT_NEAR(floor.highest, -1.84, 1e-12);
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

}  // namespace
}  // namespace muckpile
