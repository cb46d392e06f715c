// SPDX-License-Identifier: GPL-2.0-or-later
// From options to bodies and facets, and what is printed about them.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "args/input_error.h"
#include "rock/cut_table.h"
#include "rock/rock_model.h"

namespace muckpile {
namespace {

SupportRule nothing_is_held() {
  return [](const Vec3&) { return Support::free; };
}

/// A cube of 2 m.
CutOptions cube(const std::string& text) {
  std::istringstream stream("density 2500 block_min 0.3 block_max 0.6 " + text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  CutOptions options = cut_options(parse_args(cut_table(), kCreateBlocks, words), 8'000'000'000);
  options.rock.hi = Vec3::Constant(2.0);
  return options;
}

TEST(RockModel, BodiesHoldAllOfTheRock) {
  const RockModel model =
      cut_rock(cube("size uniform 0.5 spheres_per_block 4"), 11, nothing_is_held());
  ASSERT_EQ(model.bodies.size(), model.rock.blocks.size());
  double mass = 0.0;
  for (const RigidBody& body : model.bodies) mass += body.mass;
  EXPECT_NEAR(mass, 2500.0 * 8.0, 1e-9 * 20000.0);
  int lowest = 1 << 30;
  for (const Facet& facet : model.facets.facets) lowest = std::min(lowest, facet.tag_i);
  EXPECT_EQ(lowest, 11);
  EXPECT_NE(describe(model, 0.0).find("volume 8 m3 in blocks"), std::string::npos);
}

TEST(RockModel, SupportsAndJointClassesReachTheFacets) {
  const SupportRule floor = [](const Vec3& at) {
    return at.z() < 1e-6 ? Support::fixed : Support::free;
  };
  const RockModel model = cut_rock(cube("size uniform 0.5 joint_plane 1 1 1 90 90 3"), 1, floor);
  double supported = 0.0, natural = 0.0;
  for (const Facet& facet : model.facets.facets) {
    if (facet.kind == FacetKind::fixed) supported += facet.area;
    if (facet.joint_class == 3) natural += facet.area;
  }
  EXPECT_NEAR(supported, 4.0, 1e-9);
  EXPECT_NEAR(natural, 4.0, 1e-9);
}

TEST(RockModel, FacetsInTheDiscsOfASetAreTheShareOfItsPlanes) {
  // a handful of planes of 4 m2: few discs lie in them, so the bound of their share is wide
  for (const std::string seed : {"1", "2"}) {
    CutOptions whole = cube("size uniform 0.3 seed " + seed + " natural_joints 90 90 0.5 3"),
               discs = cube("size uniform 0.3 seed " + seed +
                            " natural_joints 90 90 0.5 3 persistence 0.5 0.4");
    lay_natural_joint_sets(whole);
    lay_natural_joint_sets(discs);
    const auto area = [](const CutOptions& options) {
      double sum = 0.0;
      for (const Facet& facet : cut_rock(options, 1, nothing_is_held()).facets.facets)
        sum += facet.joint_class == 3 ? facet.area : 0.0;
      return sum;
    };
    const double planes = 4.0 * static_cast<double>(whole.rock.planes.size());
    EXPECT_NEAR(area(whole), planes, 1e-3 * planes) << seed;
    EXPECT_NEAR(area(discs) / planes, 0.5, 0.2) << seed;
  }
}

TEST(RockModel, SetsThatCrossACrushedZoneMoveNoSeedIntoIt) {
  // Seeds that mirror each other in a plane would meet in the zone if they kept off it one by one.
  CutOptions options = cube(
      "size uniform 0.5 seed 15 hole 0 0 -2 0 0 3 0.3 natural_joints 75 90 1 1 natural_joints 85 0 "
      "1 1 natural_joints 10 270 1 1");
  options.rock.hi = Vec3(5.0, 5.0, 3.0);
  options.rock.lo = -options.rock.hi;
  lay_natural_joint_sets(options);
  const RockModel model = cut_rock(options, 1, nothing_is_held());
  double volume = 0.0;
  for (const Block& block : model.rock.blocks) volume += block.mass.volume;
  EXPECT_NEAR(volume, 600.0 - M_PI * 0.09 * 5.0, 1.5);  // thin rock at the zone goes with it
}

TEST(RockModel, TheReportSaysHowMuchOfTheRockIsNaturalJoint) {
  const std::string text = describe(
      cut_rock(cube("size uniform 0.5 joint_plane 1 1 1 90 90 3"), 1, nothing_is_held()), 0.0);
  EXPECT_NE(text.find("natural joints: 1 planes, 4 m2 of facets with a joint class, 0.5 m2 per m3"),
            std::string::npos)
      << text;
}

TEST(RockModel, ATargetIsReportedPointByPoint) {
  const RockModel model =
      cut_rock(cube("size target kuz_ram 0.45 3 hole 1 1 0 1 1 2 0.3"), 1, nothing_is_held());
  ASSERT_TRUE(model.sizes);
  const std::string text = describe(model, 0.0);
  EXPECT_NE(text.find("P50 0.45 "), std::string::npos) << text;
  EXPECT_EQ(model.sizes->good(), text.find("the target is missed") == std::string::npos);
}

TEST(RockModel, RingsOfBlocksOnCrushedZonesAreStiffenedUnlessTheWallIsThatOfBlocks) {
  const auto stiffest = [](const std::string& words) {
    const RockModel model =
        cut_rock(cube("size uniform 0.4 hole 1 1 0 1 1 2 0.3 " + words), 1, nothing_is_held());
    double most = 0.0;
    for (const Facet& facet : model.facets.facets) most = std::max(most, facet.stiffening);
    return most;
  };
  EXPECT_GT(stiffest(""), 1.2);
  EXPECT_EQ(stiffest("wall round"), stiffest(""));
  EXPECT_EQ(stiffest("wall blocks"), 1.0);
}

}  // namespace
}  // namespace muckpile
