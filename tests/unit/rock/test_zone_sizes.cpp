// SPDX-License-Identifier: GPL-2.0-or-later
// Block sizes of zones: mean size over that asked for, number of blocks, growth at borders, rings.
// Scope: cubes of rock of 4 m; errors of single words are in tests/errors.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/cut/ground.h"
#include "geometry/cut/hole_rings.h"
#include "geometry/size/size_factor.h"
#include "input_error_of.h"
#include "math/random.h"
#include "rock/cut_options.h"
#include "rock/cut_table.h"
#include "rock/rock_model.h"
#include "rock/zone_sizes.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

const std::string kUniform = "density 2600 size uniform 0.4 block_min 0.1 block_max 1.2 ";
const std::string kAroundAHole =
    "density 2600 size power 0.3 1 block_min 0.2 block_max 0.9 hole 0 0 -1.2 0 0 1.2 0.1 ";
const std::string kJointSets = "cut joint_sets joint_set 75 80 joint_set 85 350 joint_set 10 265 ";

CutOptions options_of(const std::string& text) {
  std::istringstream words("spheres_per_block 1 " + text);
  const std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
  CutOptions options = cut_options(parse_args(cut_table(), kCreateBlocks, all), 1ull << 33);
  options.rock.lo = Vec3::Constant(-2.0);
  options.rock.hi = Vec3::Constant(2.0);
  lay_zones(options);
  return options;
}

RockModel cut(const CutOptions& options) {
  return cut_rock(options, 1, [](const Vec3&) { return Support::free; });
}

/// Of the blocks of a zone: V^(1/3) in the mean over what is asked for at them; and the size that
/// as many blocks of equal volume have [m].
struct ZoneSize {
  double over_target = 0.0, mean = 0.0;
};
ZoneSize size_in(const RockModel& model, std::uint8_t zone) {
  double ratios = 0.0, volume = 0.0, count = 0.0;
  for (std::size_t b = 0; b < model.zone_of.size(); ++b) {
    if (model.zone_of[b] != zone) continue;
    const Block& block = model.rock.blocks[b];
    ratios += std::cbrt(block.mass.volume) / block.target_size;
    volume += block.mass.volume;
    count += 1.0;
  }
  return {ratios / count, std::cbrt(volume / count)};
}

void expect_sizes(const std::string& name, const std::string& words, double most_off) {
  const CutOptions options = options_of(words);
  ASSERT_NE(options.rock.factor, nullptr);
  const RockModel model = cut(options);
  for (std::uint8_t zone = 0; zone <= options.zones.size(); ++zone) {
    const ZoneSize size = size_in(model, zone);
    std::printf("%s, zone %d: %.3f of the size asked for, %.3f m in the mean\n", name.c_str(), zone,
                size.over_target, size.mean);
    EXPECT_NEAR(size.over_target, 1.0, most_off) << name << ", zone " << int(zone);
  }
  const double count = static_cast<double>(model.bodies.size());
  std::printf("%s: %.0f blocks, %.1f expected\n", name.c_str(), count,
              model.rock.statistics.expected_blocks);
  EXPECT_NEAR(count / model.rock.statistics.expected_blocks, 1.0, 0.1) << name;
}

// Measured: 1 % of the size for Voronoi blocks; joint sets halve, and come out 4 % too small.
TEST(ZoneSizes, AreThoseOfTheLawTimesTheFactor) {
  const std::string top = "zone top 2000 above 0 0 0 0 0 size_factor ";
  expect_sizes("twice", kUniform + top + "2", 0.03);
  expect_sizes("half", kUniform + top + "0.5", 0.03);
  expect_sizes("threefold", kUniform + top + "3", 0.03);
  expect_sizes("seam", kUniform + "zone seam 2000 layer 0 0 -0.5 20 40 1 size_factor 0.6", 0.03);
  expect_sizes("around a hole", kAroundAHole + top + "0.6", 0.03);
}

// Coarse blocks within fine rock, in a seam half a block thick: the growth from its borders is all
// that they have.
TEST(ZoneSizes, ThatAThinZoneDoesNotReachAreWarnedOf) {
  const auto told = [](const std::string& words) {
    const CutOptions options = options_of(kUniform + words);
    const RockModel model = cut(options);
    return describe_zone_sizes(options, model.rock, model.zone_of);
  };
  const std::string thin = told("zone seam 2000 layer 0 0 -0.5 20 40 0.2 size_factor 2");
  EXPECT_EQ(thin.find("WARNING: create_blocks: zone 'seam': size_factor 2 leaves all blocks 1"), 0u)
      << thin;
  EXPECT_EQ(told("zone seam 2000 layer 0 0 -0.5 20 40 1 size_factor 0.6"), "");
  EXPECT_EQ(told("zone top 2000 above 0 0 0 0 0 size_factor 2"), "");
  EXPECT_EQ(told("zone top 2000 above 0 0 0 0 0"), "");
}

TEST(ZoneSizes, HoldForJointSets) {
  const std::string top = kJointSets + "zone top 2000 above 0 0 0 0 0 size_factor ";
  expect_sizes("joint sets, twice", kUniform + top + "2", 0.08);
  expect_sizes("joint sets, half", kUniform + top + "0.5", 0.08);
}

// Away from the border, where nothing has to grow, the size is what is typed.
TEST(ZoneSizes, AreWhatIsTypedAwayFromTheBorder) {
  const CutOptions options = options_of(kUniform + "zone top 2000 above 0 0 0 0 0 size_factor 2");
  const Ground ground(options.rock);
  EXPECT_NEAR(ground.size({0.3, 0.2, 1.8}), 0.8, 1e-12);
  EXPECT_NEAR(ground.size({0.3, 0.2, -1.5}), 0.4, 1e-12);
  EXPECT_NEAR(ground.size({0.3, 0.2, -0.1}), 0.4, 1e-12);  // the finer rock is as asked
  EXPECT_NEAR(ground.size({0.3, 0.2, 0.5}), 0.4, 1e-12);   // within 1.5 blocks of it
  EXPECT_NEAR(ground.size({0.3, 0.2, 1.0}), 0.6, 0.05);    // 0.4 + 0.5 x (1.0 - 1.5 x 0.4)
}

TEST(ZoneSizes, InsideOfCellsOfAModelAreTheirs) {
  const testing::TemporaryFolder folder;
  const std::string model =
      testing::write_text(folder.path() / "model.csv", "x,y,z,dx,dy,dz,rock\n0,0,0,2,2,2,ore\n");
  expect_sizes("cells",
               kUniform + "zone ore 3000 model size_factor 0.6 block_model " + model + " partial",
               0.03);
}

TEST(ZoneSizes, GrowByHalfAtMost) {
  const CutOptions options =
      options_of(kAroundAHole +
                 "zone a 2000 above 0 0 0.7 30 50 size_factor 3 zone b 2000 layer 0 "
                 "0 -1.2 0 0 0.7 size_factor 0.5");
  const TessellationOptions& rock = options.rock;
  const Ground ground(rock);
  TessellationOptions plain = rock;
  plain.factor = nullptr;
  const Ground law(plain);
  Random random(5);
  const auto place = [&] {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    return Vec3(4.0 * Vec3(x, y, z) - Vec3::Constant(2.0));
  };
  double steepest = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const Vec3 a = place(), b = a + 0.1 * (place() - a).normalized();
    if (!ground.in_region(b)) continue;
    const double grown = std::abs(ground.size(a) - ground.size(b)) / (a - b).norm();
    steepest = std::max(steepest, grown);
    EXPECT_LE(ground.smallest_size_near(a, 0.1), ground.size(b) * (1 + 1e-9));
    EXPECT_LE(ground.smallest_size_near(a, 1.0), ground.size(a + (place() - a).normalized()));
  }
  // 0.5 on the shortest way through a grid, which is up to a tenth longer than the straight one,
  // and the law's own 0.3 times the factor.
  std::printf("steepest growth: %.3f m per m\n", steepest);
  EXPECT_LE(steepest, 0.5 * 1.1 + 0.3 * 3.0);
}

TEST(ZoneSizes, LeaveTheRingsOfHolesAsTheyAre) {
  const std::string zone = " zone top 2000 above 0 0 0 0 0 size_factor ";
  const auto rings = [&](const std::string& words) {
    return HoleRings(options_of(kAroundAHole + words).rock);
  };
  const HoleRings plain = rings(zone + "1");
  ASSERT_FALSE(plain.seeds().empty());
  for (const char* factor : {"0.5", "2", "4"}) {
    const HoleRings sized = rings(zone + factor);
    ASSERT_EQ(sized.seeds().size(), plain.seeds().size());
    for (std::size_t k = 0; k < plain.seeds().size(); ++k) {
      EXPECT_EQ(sized.seeds()[k].at, plain.seeds()[k].at);
      EXPECT_EQ(sized.seeds()[k].wall.point, plain.seeds()[k].wall.point);
    }
    EXPECT_EQ(sized.reach(0), plain.reach(0));
  }
}

TEST(ZoneSizes, OfOneChangeNoBit) {
  const std::string zone = "zone top 2000 above 0 0 0 0 0 zone b 2000 below 0 0 -1 10 0";
  const CutOptions with = options_of(kAroundAHole + zone + " size_factor 1");
  EXPECT_EQ(with.rock.factor, nullptr);
  const RockModel a = cut(options_of(kAroundAHole + zone)), b = cut(with);
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t k = 0; k < a.bodies.size(); ++k) {
    EXPECT_EQ(a.bodies[k].mass, b.bodies[k].mass);
    EXPECT_EQ(a.rock.blocks[k].mass.centroid, b.rock.blocks[k].mass.centroid);
  }
}

TEST(ZoneSizes, ThatCannotBeAreRefused) {
  const auto refusal = [](const std::string& words) {
    return input_error_of([&] { (void)options_of(words); });
  };
  const std::string top = "zone top 2000 above 0 0 0 0 0 size_factor ";
  EXPECT_EQ(
      refusal(kUniform + top + "0.2"),
      "create_blocks: zone 'top': size_factor must leave blocks between block_min and "
      "block_max, got '0.2', with which all blocks of the zone (0.08 to 0.08 m) would be below "
      "block_min (0.1 m)");
  EXPECT_NE(refusal(kUniform + top + "5").find("would be above block_max (1.2 m)"),
            std::string::npos);
  EXPECT_EQ(refusal(kAroundAHole + top + "4"), "");  // at the hole they would be 0.8 m
}

}  // namespace
}  // namespace muckpile
