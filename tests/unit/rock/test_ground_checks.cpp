// SPDX-License-Identifier: GPL-2.0-or-later
// Holes that do not begin on surveyed ground, and ground above the region.
// Scope: level ground, or two levels, over a region of 20 m x 20 m that ends at z = 13 m.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "args/input_error.h"
#include "rock/cut_table.h"
#include "rock/ground_checks.h"
#include "rock/rock_surfaces.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

class GroundChecks : public ::testing::Test {
 protected:
  /// Ground of height `low` for x < x_step, `high` beyond; one hole per height, which begins there.
  CutOptions options_of(double low, double high, const std::vector<double>& collars,
                        double x_step = 0.0) {
    std::string ground;
    for (int x = -12; x <= 12; ++x)
      for (int y = -12; y <= 12; y += 4)
        ground += std::to_string(x) + ',' + std::to_string(y) + ',' +
                  std::to_string(x < x_step ? low : high) + '\n';
    testing::write_text(terrain_, ground + more_points_);
    std::string holes =
        "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m\n";
    for (std::size_t h = 0; h < collars.size(); ++h) {
      const std::string place = "-5," + std::to_string(-7.3 + 3.1 * static_cast<double>(h)) + ',';
      holes += 'h' + std::to_string(h + 1) + ',' + place + std::to_string(collars[h]) + ',' +
               place + "1,0.1\n";
    }
    testing::write_text(table_, holes);
    CutOptions options = cut_options(
        parse_args(cut_table(), kCreateBlocks,
                   {"density", "2600", "size", "uniform", "1", "block_min", "1", "block_max", "1",
                    "spheres_per_block", "1", "terrain", terrain_, "hole_table", table_, "2"}),
        1ull << 33);
    options.rock.lo = Vec3(-10.0, -10.0, 0.0);
    options.rock.hi = Vec3(10.0, 10.0, 13.0);
    lay_surfaces(options);
    return options;
  }

  std::string refusal_of(const CutOptions& options) {
    try {
      (void)ground_checks(options);
    } catch (const InputError& refused) {
      return refused.what();
    }
    return "";
  }

  std::string more_points_;  // of the ground, behind the others
  testing::TemporaryFolder folder_;
  std::string terrain_ = (folder_.path() / "ground.csv").string();
  std::string table_ = (folder_.path() / "holes.csv").string();
};

TEST_F(GroundChecks, TakeDecimetres) {
  EXPECT_EQ(ground_checks(options_of(10.0, 10.0, {10.0, 9.6, 10.4})), "");
}

/// Blocks of 1 m do not see 0.25 m.
TEST_F(GroundChecks, WarnOfTwoHeightsAtOnePlace) {
  more_points_ = "3,4,10.2\n5,8,13\n7,8,9.5\n5,8,14\n";
  EXPECT_EQ(ground_checks(options_of(10.0, 10.0, {10.0})),
            "WARNING: create_blocks: terrain " + terrain_ +
                " has two heights at 2 place(s), 4 m apart at x = 5 m, y = 8 m of the run: one of "
                "them counts, and the ground leans from it to the next place. Give a steep face as "
                "triangles, or its toe and its crest at places that differ\n");
}

TEST_F(GroundChecks, WarnOfHolesThatBeginOffTheGround) {
  const std::string told = ground_checks(options_of(10.0, 10.0, {10.0, 9.2, 11.5}));
  EXPECT_EQ(told, "WARNING: create_blocks: hole 'h2' of " + table_ +
                      " begins at z = 9.2 m, 0.8 m below the terrain " + terrain_ +
                      ", which is at z = 10 m there, and 0.8 m from it by the nearest way\n"
                      "WARNING: create_blocks: hole 'h3' of " +
                      table_ + " begins at z = 11.5 m, 1.5 m above the terrain " + terrain_ +
                      ", which is at z = 10 m there, and 1.5 m from it by the nearest way\n");
}

TEST_F(GroundChecks, EndTheListOfHolesAfterThree) {
  const std::string told = ground_checks(options_of(10.0, 10.0, {11.0, 11.0, 11.0, 11.0, 11.0}));
  EXPECT_NE(told.find("and 2 more holes that begin so far from the ground\n"), std::string::npos)
      << told;
}

/// A hole that is drilled from a face begins far below the ground over it, but at the face.
TEST_F(GroundChecks, TakeTheNearestWay) {
  EXPECT_EQ(ground_checks(options_of(12.0, 4.0, {8.0}, -5.0)), "");
}

/// A hole through 4 m of fill that begins on the surface of the rock below the terrain.
TEST_F(GroundChecks, TakeTheNearestSurface) {
  CutOptions options = options_of(10.0, 10.0, {6.0});
  EXPECT_NE(refusal_of(options), "");
  options.surfaces.push_back(options_of(6.0, 6.0, {6.0}).surfaces.front());
  EXPECT_EQ(ground_checks(options), "");
}

/// The farthest one is told, not the first.
TEST_F(GroundChecks, RefuseHolesOfAnotherPlace) {
  const std::string got = refusal_of(options_of(10.0, 10.0, {12.5, 13.5, 9.0}));
  EXPECT_EQ(got.find("create_blocks: hole 'h2' of "), 0U) << got;
  EXPECT_NE(got.find("begins at z = 13.5 m, 3.5 m above the terrain "), std::string::npos) << got;
  EXPECT_NE(got.find("; allowed are 2 m; are holes and ground at one place, and both in metres"),
            std::string::npos)
      << got;
  EXPECT_NE(got.find("-var terrain_unit, terrain_east, terrain_north, terrain_height)?"),
            std::string::npos)
      << got;
}

/// x > 6 of 20 m: a fifth of the plan.
TEST_F(GroundChecks, WarnOfGroundAboveTheRegion) {
  const std::string told = ground_checks(options_of(10.0, 15.0, {10.0}, 6.0));
  EXPECT_NE(told.find("WARNING: create_blocks: terrain " + terrain_ +
                      " is higher than the region, which ends at z = 13 m, over 21.7 % of its "
                      "plan, by up to 2 m: the rock ends level there; take a higher region"),
            std::string::npos)
      << told;
  EXPECT_EQ(ground_checks(options_of(10.0, 15.0, {10.0}, 9.9)), "");
}

}  // namespace
}  // namespace muckpile
