// SPDX-License-Identifier: GPL-2.0-or-later
// The words of create_blocks: what they ask for, and what each wrong one says.
// Scope: core only; the engine repeats some of the messages in tests/errors.
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "input_error_of.h"
#include "rock/cut_options.h"
#include "rock/cut_table.h"

namespace muckpile {
namespace {

const std::string kRock = "density 2700 block_min 0.1 block_max 0.5 ";

constexpr std::size_t kMemory = 8'000'000'000;  // [bytes]

CutOptions read(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return cut_options(parse_args(cut_table(), kCreateBlocks, words), kMemory);
}

std::string message(const std::string& text) {
  return input_error_of([&] { (void)read(text); });
}

TEST(CutOptions, ReadsAPlainCut) {
  const CutOptions options =
      read(kRock + "size power 0.1 1 hole 0 0 0 0 0 5 0.2 seed 7 spheres_per_block 9");
  EXPECT_TRUE(options.is_plain_voronoi());
  EXPECT_EQ(options.rock.seed, 7u);
  EXPECT_EQ(options.spheres.count, 9);
  EXPECT_EQ(options.spheres.surface_gap, std::numeric_limits<double>::infinity());
  ASSERT_EQ(options.rock.holes.size(), 1u);
  EXPECT_EQ(options.rock.holes[0].radius, 0.2);
  EXPECT_DOUBLE_EQ(options.rock.size.at(3.0), 0.3);
  EXPECT_DOUBLE_EQ(options.rock.size.at(1e3), 0.5);
}

TEST(CutOptions, TheGapBetweenSpheresIsAShareOfTheSmallestBlock) {
  const CutOptions options = read(kRock + "size uniform 0.3 sphere_growth 1.2 sphere_gap 0.8");
  EXPECT_DOUBLE_EQ(options.spheres.surface_gap, 0.08);
  EXPECT_EQ(options.spheres.growth, 1.2);
  EXPECT_EQ(message(kRock + "size uniform 0.3 sphere_gap 0.19"),
            "create_blocks: sphere_gap must be 0 or >= 0.2, got '0.19'");
}

TEST(CutOptions, ARowIsShiftedAndComesAfterSingleHoles) {
  const CutOptions options =
      read(kRock + "size uniform 0.3 hole_row 3 0 2 0 1 0 0 1 0 4 0.2 hole 9 9 0 9 9 4 0.1");
  ASSERT_EQ(options.rock.holes.size(), 4u);
  EXPECT_EQ(options.rock.holes[0].radius, 0.1);
  EXPECT_EQ(options.rock.holes[3].toe, Vec3(1, 4, 0));
  EXPECT_EQ(options.rock.holes[3].collar, Vec3(1, 4, 4));
}

TEST(CutOptions, NaturalJointsAreCutPlanesToo) {
  const CutOptions options = read(kRock + "size uniform 0.3 joint_plane 1 2 3 90 90 2 5");
  ASSERT_EQ(options.natural_joints.size(), 1u);
  EXPECT_EQ(options.natural_joints[0].joint_class, 2);
  EXPECT_EQ(options.natural_joints[0].radius, 5.0);
  ASSERT_EQ(options.rock.planes.size(), 1u);
  EXPECT_NEAR(std::abs(options.rock.planes[0].normal.x()), 1.0, 1e-15);  // dips to the east
}

TEST(CutOptions, ASetOfNaturalJointsIsReadWithItsOptions) {
  const CutOptions options =
      read(kRock +
           "size uniform 0.3 natural_joints 90 0 1.5 2 natural_joints 30 90 "
           "2 1 persistence 0.5 3 fisher 40 spacings even natural_joints 0 0 0 1 seed 4");
  ASSERT_EQ(options.natural_joint_sets.size(), 2u);
  const NaturalJointSet &plain = options.natural_joint_sets[0],
                        &full = options.natural_joint_sets[1];
  EXPECT_NEAR(plain.normal.y(), 1.0, 1e-15);  // upright, dips to the north
  EXPECT_EQ(plain.spacing, 1.5);
  EXPECT_EQ(plain.least_spacing, 0.05);  // half of block_min
  EXPECT_EQ(plain.joint_class, 2);
  EXPECT_EQ(plain.persistence, 1.0);
  EXPECT_NEAR(full.normal.x(), 0.5, 1e-15);  // dips to the east
  EXPECT_EQ(full.persistence, 0.5);
  EXPECT_EQ(full.radius, 3.0);
  EXPECT_EQ(full.concentration, 40.0);
  EXPECT_EQ(full.least_spacing, 2.0);
  EXPECT_EQ(options.rock.seed, 4u);
}

/// Planes through a box of 10 m.
CutOptions laid(const std::string& words) {
  CutOptions options = read(kRock + "size uniform 0.3 " + words);
  options.rock.hi = Vec3::Constant(10.0);
  lay_natural_joint_sets(options);
  return options;
}

TEST(CutOptions, PlanesOfSetsFollowSinglePlanesAndDoNotDependOnLaterSets) {
  const CutOptions one = laid("joint_plane 1 2 3 90 90 2 natural_joints 60 120 1 1"),
                   two = laid(
                       "natural_joints 60 120 1 1 natural_joints 0 0 0.5 2 joint_plane 1 2 "
                       "3 90 90 2");
  ASSERT_GT(one.rock.planes.size(), 8u);
  ASSERT_GT(two.rock.planes.size(), one.rock.planes.size() + 10);
  ASSERT_EQ(one.natural_joints.size(), one.rock.planes.size());
  EXPECT_EQ(one.natural_joints[0].joint_class, 2);
  for (std::size_t k = 0; k < one.rock.planes.size(); ++k)
    EXPECT_EQ((one.rock.planes[k].point - two.rock.planes[k].point).norm(), 0.0);
}

TEST(CutOptions, ASetThatIsRefusedSaysWhichOfItsWordsIs) {
  const auto refused = [](const std::string& words) {
    return message(kRock + "size uniform 0.3 natural_joints " + words);
  };
  const std::string name = "create_blocks: natural_joints ";
  EXPECT_EQ(refused("95 0 1 1"), name + "dip must be >= 0 and <= 90 deg, got '95'");
  EXPECT_EQ(refused("5 361 1 1"), name + "dip direction must be >= 0 and <= 360 deg, got '361'");
  EXPECT_EQ(refused("5 0 0.05 1"),
            name + "spacing must be >= 0.1 and <= 10000 m, got '0.05'; 0 is allowed too");
  EXPECT_EQ(refused("5 0 1 256"), name + "class must be >= 0 and <= 255, got '256'");
  EXPECT_EQ(refused("5 0 1 1 persistence 1.2 3"),
            name + "persistence, the share of the planes must be > 0 and <= 1, got '1.2'");
  EXPECT_EQ(refused("5 0 1 1 persistence 0.5"),
            name + "persistence needs the radius of the discs after it, got nothing");
  EXPECT_EQ(refused("5 0 1 1 persistence 0.5 0.01"),
            name +
                "persistence, the radius of the discs must be >= 0.1 and <= 1e+07 m, got "
                "'0.01'");
  EXPECT_EQ(refused("5 0 1 1 fisher 2"),
            name + "fisher, the constant K must be >= 5 and <= 1e+06, got '2'");
  EXPECT_EQ(refused("5 0 1 1 spacings evne"),
            name + "spacings must be exponential or even, got 'evne'; did you mean 'even'?");
  EXPECT_EQ(refused("5 0 1 1 persistense 0.5 2"),
            name +
                "takes persistence, fisher, spacings after its class, got 'persistense'; did "
                "you mean 'persistence'?");
}

TEST(CutOptions, MoreThanAThousandPlanesAreRefused) {
  std::string words;  // 10 sqrt(3) / 0.1 = 174 planes each
  for (int set = 0; set < 6; ++set) words += "natural_joints 0 0 0.1 1 ";
  EXPECT_EQ(input_error_of([&] { (void)laid(words); }),
            "create_blocks: natural_joints must be at most 1000 planes through the rock, all sets "
            "together, got up to '1040' with the set of spacing 0.1 m; take a wider spacing");
}

TEST(CutOptions, MoreThanAMillionDiscsAreRefusedWithTheLeastRadius) {
  // 173.2 planes, covered -ln(0.4) = 0.916 times, in squares of 10 sqrt(3) m + 2 radii: with 0.1 m
  // 173.2 0.916 / pi 175.2^2 = 1.55e6 discs; (17.32 m / radius + 2)^2 at most pi 1e6 / (173.2
  // 0.916)
  const std::string set = "natural_joints 0 0 0.1 1 persistence 0.6 ";
  const std::string text = input_error_of([&] { (void)laid(set + "0.1"); });
  EXPECT_EQ(text.rfind("create_blocks: natural_joints persistence must be at most 1000000 discs, "
                       "all sets together, got up to '155",
                       0),
            0u)
      << text;
  EXPECT_NE(text.find("with the set of spacing 0.1 m and radius 0.1 m; take a radius of at least "
                      "0.125 m"),
            std::string::npos)
      << text;
  EXPECT_NO_THROW((void)laid(set + "0.125"));
  EXPECT_NE(input_error_of([&] { (void)laid(set + "0.125 " + set + "0.125"); }), "");
}

TEST(CutOptions, AnOptionOfASetIsTakenOnce) {
  EXPECT_EQ(message(kRock + "size uniform 0.3 natural_joints 5 0 1 1 fisher 20 fisher 20"),
            "create_blocks: natural_joints takes fisher once");
}

TEST(CutOptions, OtherCutsAreNotPlain) {
  EXPECT_FALSE(read(kRock + "size target kuz_ram 0.3 1.2").is_plain_voronoi());
  EXPECT_FALSE(read(kRock + "size import rock.vtk").is_plain_voronoi());
  const CutOptions sets =
      read(kRock + "size uniform 0.3 cut joint_sets joint_set 90 0 joint_set 90 90 2");
  EXPECT_FALSE(sets.is_plain_voronoi());
  ASSERT_TRUE(sets.joint_sets);
  EXPECT_EQ(sets.joint_sets->sets[1].spacing, 2.0);
}

TEST(CutOptions, MemoryBoundsTheBlocksUnlessTheUserDoes) {
  // half of 8 GB, 9 kB a block and 0.7 kB for each of 10 spheres
  EXPECT_EQ(read(kRock + "size uniform 0.3 spheres_per_block 10").rock.max_blocks, 250000u);
  EXPECT_EQ(read(kRock + "size uniform 0.3 max_blocks 77").rock.max_blocks, 77u);
}

TEST(CutOptions, RingsAroundHolesBeginAtOneAndAHalfRadiiOrWhereAsked) {
  const std::string hole = "size uniform 0.3 hole 0 0 0 0 0 5 0.16 ";
  EXPECT_EQ(read(kRock + hole).rock.rings_from, 1.5);
  EXPECT_EQ(read(kRock + hole + "rings_from 1.75").rock.rings_from, 1.75);
  EXPECT_EQ(message(kRock + hole + "rings_from 1.4"),
            "create_blocks: rings_from must be >= 1.5 and <= 2, got '1.4'");
  EXPECT_EQ(message(kRock + hole + "rings_from 1.8 cut joint_sets joint_set 90 0 joint_set 90 90"),
            "create_blocks: rings_from needs 'cut voronoi'");
}

TEST(CutOptions, RefusesWhatDoesNotFitTogether) {
  EXPECT_EQ(message("density 2700 block_min 0.5 block_max 0.1 size uniform 0.3"),
            "create_blocks: block_max must be >= block_min (0.5 m), got '0.1'");
  EXPECT_EQ(message(kRock), "create_blocks: keyword 'size' is required");
  EXPECT_EQ(message(kRock + "size power 1"), "create_blocks: size power takes 2 value(s), got 1");
  EXPECT_EQ(message(kRock + "size bands 1 0.2 3"),
            "create_blocks: size bands takes pairs of a radius and a size");
  EXPECT_EQ(message(kRock + "size linear 1"),
            "create_blocks: size must be harries, power, table, bands, uniform, target or import, "
            "got 'linear'");
  EXPECT_EQ(message(kRock + "size uniform 0.3 superpose yes"),
            "create_blocks: superpose yes needs size harries");
  EXPECT_EQ(message(kRock + "size uniform 0.3 joint_set 90 0"),
            "create_blocks: joint_set and sliver need 'cut joint_sets'");
  EXPECT_EQ(message(kRock + "size import a.vtk cut voronoi"),
            "create_blocks: size import leaves nothing to cut: no 'cut'");
  EXPECT_EQ(message(kRock + "size target kuz_ram 0.3 1 cut joint_sets joint_set 90 0"),
            "create_blocks: size target needs 'cut voronoi': joint sets halve block sizes in "
            "steps");
  EXPECT_EQ(message(kRock + "size uniform 0.3 hole 0 0 0 0 0 5 0.2 hole 0.1 0 0 0.1 0 5 0.2")
                .substr(0, 15),
            "create_blocks: ");
  EXPECT_EQ(message(kRock + "size target kuz_ram 0.3"),
            "create_blocks: size target must be followed by 'kuz_ram x50 n' or 'swebrec x50 xmax "
            "b'");
}

}  // namespace
}  // namespace muckpile
