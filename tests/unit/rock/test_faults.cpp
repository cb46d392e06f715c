// SPDX-License-Identifier: GPL-2.0-or-later
// Faults from triangles: which facets get their class, plane ones and others, and where they end.
// Scope: a cube of rock of 4 m in blocks of 0.5 m; refusals are in tests/errors.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "../geometry/surface_shapes.h"
#include "math/random.h"
#include "rock/cut_options.h"
#include "rock/cut_table.h"
#include "rock/faults.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

class Faults : public ::testing::Test {
 protected:
  std::string file(const test::Triangles& triangles) {
    std::ostringstream text;
    text.precision(15);
    text << "solid it\n";
    for (const StlTriangle& triangle : triangles) {
      text << "facet normal 0 0 0\nouter loop\n";
      for (const Vec3& corner : triangle) text << "vertex " << corner.transpose() << '\n';
      text << "endloop\nendfacet\n";
    }
    return testing::write_text(folder_.path() / "it.stl", text.str() + "endsolid it\n");
  }
  RockModel cut(const std::string& more) {
    std::istringstream words(
        "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 sweeps 5 spheres_per_block 1 " +
        more);
    const std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
    CutOptions options = cut_options(parse_args(cut_table(), kCreateBlocks, all), 1ull << 33);
    options.rock.lo = Vec3::Constant(-2.0);
    options.rock.hi = Vec3::Constant(2.0);
    lay_faults(options);
    lay_zones(options);
    RockModel model = cut_rock(options, 1, [](const Vec3&) { return Support::free; });
    log_ = describe_faults(options, model);
    return model;
  }

  testing::TemporaryFolder folder_;
  std::string log_;
};

/// A rectangle that dips 30 degrees to the east through 0 0 0, from y = `from` on.
test::Triangles dipping(double from) {
  const double slope = -std::tan(std::numbers::pi / 6.0);
  const auto at = [&](double x, double y) { return Vec3(x, y, slope * x); };
  return {{at(-9, from), at(9, from), at(9, 9)}, {at(-9, from), at(9, 9), at(-9, 9)}};
}

constexpr double kAll = 4.0 * 4.0 * 1.1547005383792517;  // m2 of that plane in the cube: 1/cos 30

double area_of_class(const RockModel& model, int joint_class) {
  double area = 0.0;
  for (const Facet& facet : model.facets.facets)
    area += facet.joint_class == joint_class ? facet.area : 0.0;
  return area;
}

Vec3 middle_of(const RockModel& model, const Facet& facet) {
  const auto block = static_cast<std::size_t>(facet.tag_i - 1);
  return model.rock.blocks[block].mass.centroid + facet.arm_i;
}

TEST(SurfaceIndex, PartsWhatLiesOnTwoSides) {
  const SurfaceIndex ball(test::ball(1.0, 3));
  Random random(5);
  const auto anywhere = [&] {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    return Vec3(3.0 * Vec3(x, y, z) - Vec3::Constant(1.5));
  };
  int parted = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 from = anywhere(), to = anywhere();
    EXPECT_EQ(ball.parts(from, to), ball.inside(from) != ball.inside(to));
    parted += ball.parts(from, to) ? 1 : 0;
  }
  EXPECT_GT(parted, 500);
  // Through edges of a cube: by one of the two triangles there.
  const SurfaceIndex cube(test::closed_box(Vec3::Constant(-1.0), Vec3::Constant(1.0)));
  EXPECT_TRUE(cube.parts(Vec3::Zero(), Vec3(2, 2, 0)));
  EXPECT_TRUE(cube.parts(Vec3::Zero(), Vec3(0, 0, 3)));
}

TEST_F(Faults, ThatArePlaneAreThoseOfAJointPlane) {
  const RockModel plane = cut("joint_plane 0 0 0 30 90 3");
  const RockModel fault = cut("fault " + file(dipping(-9.0)) + " 3");
  EXPECT_NEAR(area_of_class(plane, 3), kAll, 1e-6);
  EXPECT_NEAR(area_of_class(fault, 3), kAll, 1e-6);
  EXPECT_EQ(fault.facets.facets.size(), plane.facets.facets.size());
  const Vec3 normal(0.5, 0.0, std::sqrt(0.75));
  for (const Facet& facet : fault.facets.facets) {
    const Vec3 middle = middle_of(fault, facet);
    const bool in_plane =
        facet.normal.cross(normal).norm() < 1e-6 && std::abs(normal.dot(middle)) < 1e-6;
    EXPECT_EQ(facet.joint_class, in_plane ? 3 : 0);
  }
  EXPECT_NE(log_.find("18.48 m2 of facets; plane: the cut follows it"), std::string::npos) << log_;
}

TEST_F(Faults, EndWithTheirTriangles) {
  const RockModel model = cut("fault " + file(dipping(0.0)) + " 3");
  EXPECT_NEAR(area_of_class(model, 3), 0.5 * kAll, 0.1 * kAll);
  for (const Facet& facet : model.facets.facets) {
    const double y = middle_of(model, facet).y();
    if (std::abs(y) > 0.5) {  // a block
      EXPECT_TRUE(facet.joint_class == 0 || y > 0.0);
    }
  }
}

// Their facets are those between the blocks inside and outside: steps, at an angle to the surface.
TEST_F(Faults, ThatAreNotPlaneAreStepsOfABlock) {
  const std::string ball = file(test::ball(1.4, 4));
  const RockModel model = cut("fault " + ball + " 2 zone ore 3400 inside " + ball);
  for (const Facet& facet : model.facets.facets)
    EXPECT_EQ(facet.joint_class == 2, facet.zone_i != facet.zone_j);
  const double ratio = area_of_class(model, 2) / (4.0 * std::numbers::pi * 1.4 * 1.4);
  std::printf("facets over surface %.3f\n%s", ratio, log_.c_str());
  EXPECT_GT(ratio, 1.05);
  EXPECT_LT(ratio, 1.5);
  EXPECT_NE(log_.find("not plane: facets are steps of a block, they stand at"), std::string::npos);
}

TEST_F(Faults, WinOverNaturalJoints) {
  const std::string both = "fault " + file(dipping(-9.0)) + " 2 joint_plane 0 0 0 30 90 1";
  EXPECT_NEAR(area_of_class(cut(both), 2), kAll, 1e-6);
  // The other plane through the cube of 4 m is all that is natural joint then.
  const std::string text = describe(cut(both + " joint_plane 0 1 0 90 0 1"), 0.0);
  EXPECT_NE(text.find("natural joints: 2 planes, 16 m2 of facets with a joint class, 0.25 m2 per "
                      "m3 of blocks, without those of faults"),
            std::string::npos)
      << text;
}

TEST_F(Faults, ThatMissTheBlocksAreToldOf) {
  const test::Triangles corner{{Vec3(1.9, 1.9, 9), Vec3(9, 1.9, 1.9), Vec3(1.9, 9, 1.9)}};
  (void)cut("fault " + file(corner) + " 1");
  EXPECT_NE(log_.find("WARNING: create_blocks: fault " + (folder_.path() / "it.stl").string() +
                      " parts no two blocks"),
            std::string::npos)
      << log_;
}

}  // namespace
}  // namespace muckpile
