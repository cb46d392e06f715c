// SPDX-License-Identifier: GPL-2.0-or-later
// Zones of rock: their words, which blocks are theirs, and how the cut follows their borders.
// Scope: a cube of rock of 4 m in blocks of 0.7 m; errors of single words are in tests/errors.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "args/input_error.h"
#include "rock/cut_options.h"
#include "rock/cut_table.h"
#include "rock/rock_model.h"

namespace muckpile {
namespace {

CutOptions options_of(const std::vector<std::string>& zones) {
  std::vector<std::string> words{
      "density", "2600",   "size", "uniform",           "0.7", "block_min", "0.7", "block_max",
      "0.7",     "sweeps", "5",    "spheres_per_block", "1"};
  words.insert(words.end(), zones.begin(), zones.end());
  CutOptions options = cut_options(parse_args(cut_table(), kCreateBlocks, words), 1ull << 33);
  options.rock.lo = Vec3::Constant(-2.0);
  options.rock.hi = Vec3::Constant(2.0);
  lay_zones(options);
  return options;
}

RockModel cut(const CutOptions& options) {
  return cut_rock(options, 1, [](const Vec3&) { return Support::free; });
}

TEST(RockZones, HoldWhatLiesAboveBelowAndBetweenTheirPlanes) {
  // dip 30 degrees to the east: (x, z) = (1, -0.577) lies in the plane through the origin.
  const RockZone above = rock_zone_of({"a", "2000", "above", "0", "0", "0", "30", "90"});
  EXPECT_TRUE(above.holds({1, 0, -0.57}));
  EXPECT_FALSE(above.holds({1, 0, -0.58}));
  const RockZone layer = rock_zone_of({"a", "2000", "layer", "0", "0", "-1", "0", "0", "0.5"});
  EXPECT_FALSE(layer.holds({3, 2, -1.01}));
  EXPECT_TRUE(layer.holds({3, 2, -0.99}));
  EXPECT_TRUE(layer.holds({3, 2, -0.51}));
  EXPECT_FALSE(layer.holds({3, 2, -0.49}));
  const RockZone below = rock_zone_of({"b", "2000", "below", "0", "0", "-0.7", "0", "0"});
  EXPECT_EQ(zone_at({layer, below}, {0, 0, -0.8}), 1);  // the first that holds it
  EXPECT_EQ(zone_at({layer, below}, {0, 0, -1.8}), 2);
  EXPECT_EQ(zone_at({layer, below}, {0, 0, 0}), 0);
}

TEST(RockZones, AreCutAlongTheirBordersAndHaveTheirDensity) {
  const RockModel model = cut(
      options_of({"zone", "seam", "1800", "layer", "0", "0", "-0.5", "0", "0", "1", "class", "1"}));
  std::vector<double> volume(2, 0.0), mass(2, 0.0);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    volume[model.zone_of[b]] += model.bodies[b].volume;
    mass[model.zone_of[b]] += model.bodies[b].mass;
  }
  EXPECT_NEAR(volume[0], 48.0, 1e-9);  // of 4 x 4 x 4 m3 less 4 x 4 x 1
  EXPECT_NEAR(volume[1], 16.0, 1e-9);
  EXPECT_NEAR(mass[0], 48.0 * 2600.0, 1e-6);
  EXPECT_NEAR(mass[1], 16.0 * 1800.0, 1e-6);
  double border = 0.0;
  for (const Facet& facet : model.facets.facets) {
    EXPECT_EQ(facet.zone_i != facet.zone_j, facet.joint_class == 1);
    if (facet.zone_i == facet.zone_j) continue;
    border += facet.area;
    EXPECT_NEAR(std::abs(facet.normal.z()), 1.0, 1e-9);
    EXPECT_GT(facet.border_room[0], 0.0f);
    EXPECT_FALSE(facet.sharpened);
  }
  EXPECT_NEAR(border, 32.0, 1e-6);  // both planes
}

TEST(RockZones, ThatShareAPlaneShareItsCut) {
  const CutOptions options =
      options_of({"zone", "a", "2000", "above", "0", "0", "0.3", "0", "0", "zone", "b", "2200",
                  "layer", "0", "0", "-0.4", "0", "0", "0.7"});
  EXPECT_EQ(options.rock.planes.size(), 2u);
  EXPECT_EQ(options.densities(), (std::vector<double>{2600.0, 2000.0, 2200.0}));
}

TEST(RockZones, WithoutBlocksAreToldOf) {
  const RockModel model = cut(options_of({"zone", "a", "2000", "above", "0", "0", "0", "0", "0",
                                          "zone", "b", "2200", "above", "0", "0", "1", "0", "0"}));
  const std::string text = describe(model, 0.0);
  EXPECT_NE(text.find("zone 'b' holds the centroid of no block"), std::string::npos);
  EXPECT_EQ(text.find("zone 'a' holds"), std::string::npos);
}

TEST(RockZones, OfOneNameAreRefused) {
  EXPECT_THROW(
      static_cast<void>(options_of({"zone", "a", "2000", "above", "0", "0", "0", "0", "0", "zone",
                                    "a", "2200", "below", "0", "0", "-1", "0", "0"})),
      InputError);
}

}  // namespace
}  // namespace muckpile
