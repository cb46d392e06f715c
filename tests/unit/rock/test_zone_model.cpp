// SPDX-License-Identifier: GPL-2.0-or-later
// Zones of rock by a block model: what a file may say, which cell holds a place, and that a model
// of half spaces is the same rock as layers.
// Scope: a cube of rock of 4 m; refusals of create_blocks as a whole are in tests/errors, too.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "input_error_of.h"
#include "math/random.h"
#include "rock/cut_options.h"
#include "rock/cut_table.h"
#include "rock/rock_model.h"
#include "rock/zone_model.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

const RockNames kNames{{"cap", "ore", "waste"}, {false, true, true}};

class ZoneModels : public ::testing::Test {
 protected:
  std::string file(const std::string& text) {
    return testing::write_text(folder_.path() / "model.csv", text);
  }
  std::vector<RockCell> cells(const std::string& text) {
    return read_rock_cells(file(text), kNames, 1.0);
  }
  std::string refusal(const std::string& text) {
    const std::string message = input_error_of([&] { (void)cells(text); });
    const std::size_t name = message.find("model.csv");
    return name == std::string::npos ? message : message.substr(name);
  }
  CutOptions options_of(const std::string& zones) {
    std::istringstream words(
        "density 2600 size uniform 0.6 block_min 0.6 block_max 0.6 sweeps 5 "
        "spheres_per_block 1 " +
        zones);
    const std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
    CutOptions options = cut_options(parse_args(cut_table(), kCreateBlocks, all), 1ull << 33);
    options.rock.lo = Vec3::Constant(-2.0);
    options.rock.hi = Vec3::Constant(2.0);
    lay_zones(options);
    return options;
  }

  testing::TemporaryFolder folder_;
};

RockModel cut(const CutOptions& options) {
  return cut_rock(options, 1, [](const Vec3&) { return Support::free; });
}

TEST_F(ZoneModels, MayHaveTheirColumnsInAnyOrderAndOthersBeside) {
  const auto named = cells("grade,rock,dz,dy,dx,Z,Y,X\n1.2,ore,4,5,6,3,2,1\n0,rock,1,1,1,9,9,9\n");
  ASSERT_EQ(named.size(), 2u);
  EXPECT_EQ(named[0].middle, Vec3(1, 2, 3));
  EXPECT_EQ(named[0].size, Vec3(6, 5, 4));
  EXPECT_EQ(named[0].lo(), Vec3(-2, -0.5, 1));
  EXPECT_EQ(named[0].zone, 2);  // the second of three zones
  EXPECT_EQ(named[1].zone, 0);
  const auto numbered = cells("XC,YC,ZC,XINC,YINC,ZINC,zone\n1,2,3,6,5,4,3\n0,0,0,1,1,1,0\n");
  EXPECT_EQ(numbered[0].zone, 3);
  EXPECT_EQ(numbered[1].zone, 0);
  EXPECT_EQ(read_rock_cells(file("x,y,z,dx,dy,dz,zone\n10,0,0,10,1,1,0\n"), kNames, 0.3048)[0].size,
            Vec3(3.048, 0.3048, 0.3048));
}

TEST_F(ZoneModels, AreRefusedByLineAndColumn) {
  const std::string head = "x,y,z,dx,dy,dz,rock\n";
  EXPECT_EQ(refusal(head + "0,0,0,1,1,1,ore\n0,0,1,1,1,1,oer\n"),
            "model.csv:3: rock must be a 'zone NAME DENSITY model' (ore, waste, rock; rock: that "
            "beside the zones), got 'oer'; did you mean 'ore'?");
  EXPECT_NE(refusal(head + "0,0,0,1,1,1,cap\n").find("got 'cap'"), std::string::npos);
  EXPECT_EQ(refusal("x,y,z,dx,dy,dz,zone\n0,0,0,1,1,1,1\n"),
            "model.csv:2: zone must be 0 (the rock beside the zones) or the number of a 'zone NAME "
            "DENSITY model' among the 3 zones, got '1'");
  EXPECT_EQ(refusal(head + "0,0,0,1,-1,1,ore\n").substr(0, 16), "model.csv:2: dy ");
  EXPECT_EQ(refusal(head + "0,nan,0,1,1,1,ore\n").substr(0, 15), "model.csv:2: y ");
  EXPECT_NE(refusal("x,y,z,dx,dy,rock\n0,0,0,1,1,ore\n")
                .find("must have one of the columns dz, dz_m, zinc, dim_z, z_length, got 'x, y, z"),
            std::string::npos);
  EXPECT_NE(refusal("x,y,z,dx,dy,dz\n0,0,0,1,1,1\n").find("either a column rock"),
            std::string::npos);
  EXPECT_NE(refusal("x,y,z,dx,dy,dz,rock,zone\n0,0,0,1,1,1,ore,2\n").find("either a column rock"),
            std::string::npos);
  EXPECT_EQ(refusal(head), "model.csv: must have a cell, got none");
  EXPECT_EQ(refusal("X,y,z,dx,dy,dz,XC,rock\n0,0,0,1,1,1,0.5,ore\n"),
            "model.csv: a block model must have one alone of the columns x, x_m, xc, centroid_x, "
            "easting, got both 'X' and 'XC'; rename the one that is not meant");
  EXPECT_NE(refusal("x,y,z,dx,dy,dz,lithology,rock\n0,0,0,1,1,1,a,ore\n")
                .find("got both 'lithology' and 'rock'"),
            std::string::npos);
}

TEST_F(ZoneModels, OfTwoHalfSpacesAreTwoLayers) {
  // Mine coordinates: x of the run looks to the bearing 30 degrees. The cut follows the border in
  // both, so that the blocks are the same.
  const std::string zones = "joint_plane 0 0 0.3 0 0 0 ";
  const RockModel layers = cut(options_of(zones + "zone top 2300 above 0 0 0.3 0 0 "
                                                  "zone bottom 2900 below 0 0 0.3 0 0"));
  const std::string model = file(
      "x,y,z,dx,dy,dz,rock\n5000,7000,105.3,20,20,10,top\n"
      "5000,7000,95.3,20,20,10,bottom\n");
  const RockModel cells =
      cut(options_of(zones + "zone top 2300 model zone bottom 2900 model block_model " + model +
                     " origin 5000 7000 100 x_bearing 30"));
  ASSERT_EQ(cells.bodies.size(), layers.bodies.size());
  EXPECT_EQ(cells.zone_of, layers.zone_of);
  std::vector<int> count(3, 0);
  for (std::size_t b = 0; b < cells.bodies.size(); ++b) {
    EXPECT_EQ(cells.bodies[b].mass, layers.bodies[b].mass);
    ++count[cells.zone_of[b]];
  }
  EXPECT_EQ(count[0], 0);
  EXPECT_GT(count[1], 50);
  EXPECT_GT(count[2], 50);
}

TEST_F(ZoneModels, LeaveNoRockBareUnlessTheyArePartial) {
  const std::string half = file("x,y,z,dx,dy,dz,rock\n0,0,-1,4,4,2,ore\n");
  const std::string words = "zone ore 3400 model block_model " + half;
  const std::string message = input_error_of([&] { (void)options_of(words); });
  EXPECT_NE(
      message.find("must cover the rock, leaves 6912 of 13824 points of a grid in no cell and "
                   "no zone, as at"),
      std::string::npos)  // half of 24^3
      << message;
  const RockModel partial = cut(options_of(words + " partial"));
  for (std::size_t b = 0; b < partial.bodies.size(); ++b)
    EXPECT_EQ(partial.zone_of[b], partial.rock.blocks[b].mass.centroid.z() < 0.0 ? 1 : 0);
  EXPECT_EQ(input_error_of([&] {  // what another zone holds need not be in a cell
              (void)cut(options_of("zone cap 2300 above 0 0 0 0 0 " + words));
            }),
            "");
}

// A cell missing that the grid of points does not see, about a block.
TEST_F(ZoneModels, AreCheckedBlockByBlock) {
  const RockModel whole = cut(options_of(""));
  const Vec3 at = whole.rock.blocks[40].mass.centroid;
  std::ostringstream rows;
  rows.precision(15);
  const auto slab = [&](int axis, double lo, double hi, Vec3 from, Vec3 to) {
    from[axis] = lo;
    to[axis] = hi;
    const Vec3 middle = 0.5 * (from + to), size = to - from;
    for (const double value : {middle.x(), middle.y(), middle.z(), size.x(), size.y(), size.z()})
      rows << value << ',';
    rows << "ore\n";
  };
  Vec3 lo = Vec3::Constant(-2.0), hi = Vec3::Constant(2.0);
  for (int axis = 0; axis < 3; ++axis) {  // around a gap of 0.02 m
    slab(axis, lo[axis], at[axis] - 0.01, lo, hi);
    slab(axis, at[axis] + 0.01, hi[axis], lo, hi);
    lo[axis] = at[axis] - 0.01;
    hi[axis] = at[axis] + 0.01;
  }
  const std::string model = file("x,y,z,dx,dy,dz,rock\n" + rows.str());
  const std::string message =
      input_error_of([&] { (void)cut(options_of("zone ore 3400 model block_model " + model)); });
  EXPECT_NE(message.find("leaves 1 of " + std::to_string(whole.bodies.size()) + " blocks in no"),
            std::string::npos)
      << message;
}

TEST_F(ZoneModels, HoldEachPlaceOnce) {
  EXPECT_NE(
      input_error_of(
          [&] { RockCells(cells("x,y,z,dx,dy,dz,zone\n0,0,0,2,2,2,0\n1.5,0,0,2,2,2,0\n"), "it"); })
          .find("it: must have one cell at each place, got two that overlap, around 0 0 0 and "
                "1.5 0 0 m"),
      std::string::npos);
  // Edges rounded to a millimetre of cells of 5/3 m overlap by less than 1.7 mm, and miss by less.
  const RockCells rounded(
      cells("x,y,z,dx,dy,dz,zone\n0.833,0,0,1.667,2,2,2\n2.5,0,0,1.667,2,2,3\n"), "it");
  EXPECT_EQ(rounded.zone_at(Vec3(1.66, 0, 0)), 2);
  EXPECT_EQ(rounded.zone_at(Vec3(1.67, 0, 0)), 3);
  EXPECT_TRUE(rounded.zone_at(Vec3(1.6666, 0, 0)).has_value());
  EXPECT_FALSE(rounded.zone_at(Vec3(-0.1, 0, 0)).has_value());
}

// 27,000 cells of two sizes, as parent cells and parts of them: against a look at each, and the
// time of a look-up.
TEST_F(ZoneModels, FindTheCellOfAPlaceWithoutLookingAtAll) {
  std::vector<RockCell> all;
  for (int k = 0; k < 30 * 30 * 30; ++k) {
    const Vec3 middle(k % 30 + 0.5, k / 30 % 30 + 0.5, k / 900 + 0.5);
    const auto zone = static_cast<std::uint8_t>(k % 7);
    if (k % 5 > 0) {
      all.push_back({middle, Vec3::Ones(), zone});
      continue;
    }
    for (int part = 0; part < 8; ++part) {
      const Vec3 at((part & 1) - 0.5, (part >> 1 & 1) - 0.5, (part >> 2) - 0.5);
      all.push_back({middle + 0.5 * at, Vec3::Constant(0.5), static_cast<std::uint8_t>(part)});
    }
  }
  const RockCells index(all, "it");
  Random random(4);
  for (int n = 0; n < 300; ++n) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    const Vec3 p = 30.0 * Vec3(x, y, z);
    const auto holds = [&](const RockCell& c) {
      return ((p - c.lo()).array() >= 0.0).all() && ((c.hi() - p).array() >= 0.0).all();
    };
    EXPECT_EQ(index.zone_at(p), std::ranges::find_if(all, holds)->zone);
  }
  const auto start = std::chrono::steady_clock::now();
  constexpr int kLooks = 100000;
  int sum = 0;
  for (int n = 0; n < kLooks; ++n) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    sum += *index.zone_at(30.0 * Vec3(x, y, z));
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::printf("%zu cells: %.2f us a look-up (%d)\n", all.size(), 1e6 * took.count() / kLooks, sum);
  EXPECT_LT(took.count() / kLooks, 1e-4);  // a look at each takes about as long
}

}  // namespace
}  // namespace muckpile
