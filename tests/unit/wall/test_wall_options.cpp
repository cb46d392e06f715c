// SPDX-License-Identifier: GPL-2.0-or-later
// Words of fix muckpile/wall: what they make, and what is refused.
// Scope: files of a few triangles.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "input_error_of.h"
#include "temporary_folder.h"
#include "wall/wall_options.h"

namespace muckpile::test {
namespace {

WallOptions options_of(const std::vector<std::string>& words) {
  const std::string where = "fix muckpile/wall 'floor'";
  return wall_options(parse_args(wall_table(), where, words), {Vec3(0, 0, -5), Vec3(20, 20, 15)},
                      where);
}
std::string refusal_of(const std::vector<std::string>& words) {
  return input_error_of([&] { (void)options_of(words); });
}

const std::vector<std::string> kLevel{"plane", "0", "0", "2", "0", "0", "1"};

std::vector<std::string> level_and(const std::vector<std::string>& more) {
  std::vector<std::string> words = kLevel;
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(WallOptions, WhatIsNotToldIsAsBetweenBlocks) {
  ContactParameters rock;
  rock.friction = 0.7;
  const ContactParameters same = options_of(kLevel).parameters(rock);
  EXPECT_EQ(same.friction, 0.7);
  EXPECT_EQ(same.youngs_modulus, rock.youngs_modulus);
  EXPECT_EQ(same.restitution, rock.restitution);
  EXPECT_EQ(same.rolling_friction, rock.rolling_friction);
  const ContactParameters other =
      options_of(level_and({"friction", "0", "rolling_friction", "0.3", "restitution", "0.9",
                            "youngs_modulus", "5e9"}))
          .parameters(rock);
  EXPECT_EQ(other.friction, 0.0);
  EXPECT_EQ(other.rolling_friction, 0.3);
  EXPECT_EQ(other.restitution, 0.9);
  EXPECT_NEAR(other.youngs_modulus, 2.0 / (1.0 / rock.youngs_modulus + 1.0 / 5e9), 1.0);
}

TEST(WallOptions, MeshIsReadInItsUnitAndFromItsOrigin) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder.path() / "ground.xyz").string();
  testing::write_text(file, "100 200 10\n140 200 10\n100 240 10\n140 240 10\n");
  const WallOptions options = options_of({"mesh", file, "unit", "0.5", "origin", "50", "100", "2"});
  // Heights: 10 * 0.5 - 2 = 3 m; from x, y = 0 to 20 m.
  EXPECT_NEAR(options.surface->depth({10, 5, 2.5}), 0.5, 1e-12);
  EXPECT_EQ(options.surface->depth({10, 5, 3.5}), 0.0);
  EXPECT_EQ(options.surface->depth({30, 5, 2.5}), 0.0);
  const std::string told = "fix muckpile/wall 'floor': mesh " + file +
                           ": 2 triangles of 400 m2 from 0 0 3 to 20 20 3 m, ";
  EXPECT_TRUE(options.told.starts_with(told)) << options.told;
  EXPECT_TRUE(options.told.ends_with(" MB on each rank\n")) << options.told;
  EXPECT_EQ(options_of(kLevel).told, "");
}

/// Two triangles from x, y = 0, the second of which may be turned.
std::string square(const testing::TemporaryFolder& folder, const std::string& side, bool turned) {
  const std::string file = (folder.path() / "square.stl").string();
  const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 0\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
           "\nendloop\nendfacet\n";
  };
  const std::string a = "0 0 0", b = side + " 0 0", c = side + " " + side + " 0",
                    d = "0 " + side + " 0";
  testing::write_text(file, "solid s\n" + facet(a, b, c) +
                                (turned ? facet(a, d, c) : facet(a, c, d)) + "endsolid s\n");
  return file;
}

TEST(WallOptions, MeshThatCannotBeMeantIsRefused) {
  const testing::TemporaryFolder folder;
  const auto says = [&](const std::string& side, bool turned, const std::string& text,
                        const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"mesh", square(folder, side, turned)};
    words.insert(words.end(), more.begin(), more.end());
    const std::string where = "fix muckpile/wall 'floor': mesh " + words[1] + ": ";
    const std::string got = refusal_of(words);
    EXPECT_EQ(got.substr(0, (where + text).size()), text.empty() ? "" : where + text);
  };
  says("20", false, "");
  says("20", true,
       "has triangles that are turned against each other at 1 edges, one of them from 20 20 0 to 0 "
       "0 0 m; turn them so that all normals look out of the ground, or take out one of them where "
       "they lie on each other");
  says("20000", false,
       "must be in metres, got one from 0 0 0 to 20000 20000 0 m beside a simulation "
       "box from 0 0 -5 to 20 20 15 m; it looks like millimetres: give unit 0.001");
  says("20000", false, "", {"unit", "1"});
  says("0.02", false, "must be in metres, ");
  says("20", false,
       "must be where the simulation box is, got one from -5000 -7000 0 to -4980 -6980 0 m",
       {"origin", "5000", "7000", "0"});
}

/// Of 20 m, far below the box or beside it.
TEST(WallOptions, SidesThatFollowTheRockMayReachAMesh) {
  const testing::TemporaryFolder folder;
  const std::string file = square(folder, "20", false), where = "fix muckpile/wall 'floor'";
  const auto refused = [&](const WallBox& box, const std::vector<std::string>& origin) {
    std::vector<std::string> words{"mesh", file, "origin"};
    words.insert(words.end(), origin.begin(), origin.end());
    return !input_error_of([&] {
              (void)wall_options(parse_args(wall_table(), where, words), box, where);
            }).empty();
  };
  const Vec3 lo(0, 0, -5), hi(20, 20, 15);
  const WallBox still{lo, hi}, down{lo, hi, {false, false, true}, {}},
      east{lo, hi, {}, {true, false, false}};
  const std::vector<std::string> below{"0", "0", "40"}, beside{"-300", "0", "0"},
      mine{"-478000", "0", "0"};
  EXPECT_TRUE(refused(still, below));
  EXPECT_FALSE(refused(down, below));
  EXPECT_TRUE(refused(east, below));
  EXPECT_TRUE(refused(down, beside));
  EXPECT_FALSE(refused(east, beside));
  EXPECT_TRUE(refused(east, mine));
  // Coordinates of a small mine, in a box of 150 m that follows the rock to all sides.
  const std::array<bool, 3> all{true, true, true};
  EXPECT_TRUE(refused({Vec3::Zero(), Vec3::Constant(87.0), all, all}, {"-5000", "-12000", "-300"}));
}

/// A plate in a box of 20 m may be small, if its numbers cannot be the kilometres of a survey.
TEST(WallOptions, WideMeshIsInMetres) {
  const testing::TemporaryFolder folder;
  const auto refusal_in = [&](const std::string& side, double box) {
    const std::string where = "fix muckpile/wall 'floor'";
    const std::vector<std::string> words{"mesh", square(folder, side, false)};
    return input_error_of([&] {
      (void)wall_options(parse_args(wall_table(), where, words),
                         {Vec3::Zero(), Vec3::Constant(box)}, where);
    });
  };
  EXPECT_NE(refusal_in("4", 1000.0).find("it looks like kilometres"), std::string::npos);
  EXPECT_EQ(refusal_in("6", 1000.0), "");
}

/// A triangle that is there twice would close the open rim of a mesh.
TEST(WallOptions, TrianglesThatAreThereTwiceAreLeftOut) {
  const testing::TemporaryFolder folder;
  const std::string file = square(folder, "20", false);
  std::string text = testing::text_of(file);
  const std::size_t first = text.find("facet"),
                    second = text.find("facet", text.find("endfacet") + 8);
  const std::string facet = text.substr(first, second - first);
  text.insert(second, facet);
  testing::write_text(file, text);
  const WallOptions options = options_of({"mesh", file});
  EXPECT_NE(options.told.find(": 2 triangles of 400 m2 "), std::string::npos) << options.told;
  EXPECT_NE(options.told.find(": 1 triangles that are there twice have been left out\n"),
            std::string::npos);
  EXPECT_EQ(options.surface->depth({5.0, -0.1, -0.1}), 0.0);  // beside the rim, not behind it
}

TEST(WallOptions, WhatDoesNotFitIsRefused) {
  const std::string where = "fix muckpile/wall 'floor': ";
  EXPECT_EQ(refusal_of({}), where + "needs one of plane and mesh, got none");
  EXPECT_EQ(refusal_of(level_and({"mesh", "a.stl"})),
            where + "needs one of plane and mesh, got both");
  EXPECT_EQ(refusal_of({"plane", "0", "0", "0", "0", "0", "0"}),
            where + "plane needs a point and a normal of some length, got the normal 0 0 0");
  EXPECT_EQ(refusal_of(level_and({"unit", "0.3048"})), where + "unit is about a mesh, got a plane");
  EXPECT_EQ(refusal_of(level_and({"restitution", "0.01"})),
            where + "restitution must be 0 or >= 0.05, got '0.01'");
  EXPECT_EQ(refusal_of(level_and({"friction", "-0.5"})),
            where + "friction must be -1 or >= 0, got '-0.5'");
  EXPECT_EQ(refusal_of(level_and({"rolling_friction", "-0.5"})),
            where + "rolling_friction must be -1 or >= 0, got '-0.5'");
  EXPECT_EQ(refusal_of(level_and({"youngs_modulus", "5"})),
            where + "youngs_modulus must be 0 or >= 1000 Pa, got '5'");
  EXPECT_TRUE(refusal_of({"mesh", "no_such_file.stl"}).starts_with(where + "no_such_file.stl: "));
}

}  // namespace
}  // namespace muckpile::test
