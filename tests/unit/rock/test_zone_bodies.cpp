// SPDX-License-Identifier: GPL-2.0-or-later
// Zones of rock inside of closed surfaces: which blocks they have, in mine coordinates, and what
// the log says.
// Scope: a ball of 1.2 m in a cube of rock of 4 m; refusals are in tests/errors.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "../geometry/surface_shapes.h"
#include "args/input_error.h"
#include "rock/cut_options.h"
#include "rock/cut_table.h"
#include "rock/rock_model.h"
#include "rock/rock_surfaces.h"
#include "rock/zone_bodies.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

constexpr double kRadius = 1.2;
const Vec3 kCentre(0.3, -0.2, 0.1);
const MineFrame kMine{Vec3(5000.0, 7000.0, 100.0), std::numbers::pi};  // x looks south

void write_ball(const std::string& path) {
  std::ofstream out(path);
  out.precision(15);
  out << "solid ore\n";
  for (const StlTriangle& triangle : test::ball(kRadius, 4)) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const Vec3& corner : triangle)
      out << "vertex " << kMine.to_mine(corner + kCentre).transpose() << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid ore\n";
}

class ZoneBodies : public ::testing::Test {
 protected:
  ZoneBodies() { write_ball(file_); }

  CutOptions options_of(const std::string& size, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{
        "density", "2600",      "size", "uniform", size,     "block_min",
        size,      "block_max", size,   "sweeps",  "5",      "spheres_per_block",
        "1",       "origin",    "5000", "7000",    "100",    "x_bearing",
        "180",     "zone",      "ore",  "3400",    "inside", file_};
    words.insert(words.end(), more.begin(), more.end());
    CutOptions options = cut_options(parse_args(cut_table(), kCreateBlocks, words), 1ull << 33);
    options.rock.lo = Vec3::Constant(-2.0);
    options.rock.hi = Vec3::Constant(2.0);
    lay_zones(options);
    return options;
  }

  testing::TemporaryFolder folder_;
  std::string file_ = (folder_.path() / "ore.stl").string();
};

RockModel cut(const CutOptions& options) {
  return cut_rock(options, 1, [](const Vec3&) { return Support::free; });
}

double volume_of(const RockModel& model, std::size_t zone) {
  double volume = 0.0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    volume += model.zone_of[b] == zone ? model.bodies[b].volume : 0.0;
  return volume;
}

TEST_F(ZoneBodies, HaveTheBlocksWithTheirCentroidInside) {
  const RockModel model = cut(options_of("0.4"));
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const double off = (model.rock.blocks[b].mass.centroid - kCentre).norm() - kRadius;
    if (std::abs(off) > 6e-3) {  // the sagitta of flat triangles
      EXPECT_EQ(model.zone_of[b], off < 0.0 ? 1 : 0) << off;
    }
    const double density = model.zone_of[b] == 1 ? 3400.0 : 2600.0;
    EXPECT_NEAR(model.bodies[b].mass, density * model.bodies[b].volume, 1e-6);
  }
  for (const Facet& facet : model.facets.facets) EXPECT_EQ(facet.joint_class, 0);
}

// Blocks that stand out on one side make up for those on the other: the volume is nearer to the
// ball's than a block.
TEST_F(ZoneBodies, HaveTheVolumeOfTheirSurface) {
  const double ball = 4.0 / 3.0 * std::numbers::pi * std::pow(kRadius, 3);
  for (const char* size : {"0.5", "0.25"}) {
    const RockModel model = cut(options_of(size));
    const double error = volume_of(model, 1) / ball - 1.0;
    std::printf("blocks of %s m: volume of the zone off by %.2f %%\n", size, 100.0 * error);
    EXPECT_LT(std::abs(error), std::string(size) == "0.5" ? 0.05 : 0.02);
  }
}

TEST_F(ZoneBodies, AreToldOfInTheLog) {
  const CutOptions options = options_of("0.5");
  const std::string text = describe_zone_bodies(options, cut(options));
  EXPECT_NE(text.find("zone 'ore': inside " + file_ + ": 3072 triangles around 7.2"),
            std::string::npos)
      << text;
  EXPECT_EQ(describe_mine_frame(options),
            "  place 0 0 0 is 5000 7000 100 m of the files in mine coordinates; x looks to the "
            "bearing 180 degrees\n");
}

TEST_F(ZoneBodies, GiveWayToZonesBeforeThem) {
  CutOptions options =
      options_of("0.5", {"zone", "all", "2500", "below", "0", "0", "1.9", "0", "0"});
  std::swap(options.zones[0], options.zones[1]);
  EXPECT_EQ(zone_at(options.zones, kCentre), 1);
}

}  // namespace
}  // namespace muckpile
