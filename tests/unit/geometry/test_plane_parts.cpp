// SPDX-License-Identifier: GPL-2.0-or-later
// A cut that follows planes: blocks end at them, nothing is lost, and both sides share their faces.
// Scope: some hundred blocks and two planes that cross; lengths in metres.
#include <gtest/gtest.h>

#include <cmath>

#include "args/input_error.h"
#include "bond/build/facet_builder.h"
#include "bond/build/joint_plane.h"
#include "geometry/shape/plane_parts.h"

namespace muckpile {
namespace {

const Vec3 kBox(4.0, 3.0, 3.0);

TessellationOptions options_with(const std::vector<CutPlane>& planes) {
  TessellationOptions options;
  options.hi = kBox;
  options.size = SizeLaw::uniform(0.5);
  options.planes = planes;
  return options;
}

/// Across the box, leaning, so that it meets its four long sides only.
const CutPlane kAcross{Vec3(2.0, 1.5, 1.5), Vec3(1.0, 0.3, 0.2)};
const CutPlane kAlong{Vec3(2.0, 1.5, 1.5), Vec3(0.1, 0.0, -2.0)};
const double kAreaAcross = 9.0 * std::sqrt(1.0 + 0.09 + 0.04);      // 3 x 3 over the normal's x
const double kAreaAlong = 12.0 * std::sqrt(1.0 + 0.1 * 0.1 / 4.0);  // 4 x 3 over the normal's z

const Tessellation& crossed() {
  static const Tessellation rock = tessellate(options_with({kAcross, kAlong}));
  return rock;
}

double height(const CutPlane& plane, const Vec3& p) {
  return plane.normal.normalized().dot(p - plane.point);
}

TEST(PlaneParts, BlocksFillTheBoxAndAreClosed) {
  double volume = 0.0;
  for (const Block& block : crossed().blocks) {
    volume += block.mass.volume;
    EXPECT_LT(area_vector_sum(block.shape).norm(), 1e-7);  // faces of about 0.25 m2
    EXPECT_NEAR(mass_properties(block.shape).volume, block.mass.volume, 1e-8);
  }
  EXPECT_NEAR(volume, kBox.prod(), 1e-8);
  EXPECT_NEAR(crossed().statistics.median_size_ratio, 1.0, 0.05);
}

TEST(PlaneParts, NoBlockIsOnBothSides) {
  for (const CutPlane& plane : {kAcross, kAlong}) {
    for (const Block& block : crossed().blocks) {
      const double side = height(plane, block.mass.centroid) > 0.0 ? 1.0 : -1.0;
      for (const Vec3& v : block.shape.vertices) EXPECT_GT(side * height(plane, v), -1e-9);
    }
  }
}

TEST(PlaneParts, BothSidesShareEveryFaceInThePlanes) {
  const std::vector<Block>& blocks = crossed().blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::size_t f = 0; f < blocks[b].neighbour.size(); ++f) {
      if (blocks[b].neighbour[f] < 0) continue;
      const Block& other = blocks[static_cast<std::size_t>(blocks[b].neighbour[f])];
      const FaceGeometry face = face_geometry(blocks[b].shape, static_cast<int>(f));
      double nearest = 1e300, area = 0.0;
      for (std::size_t k = 0; k < other.neighbour.size(); ++k) {
        if (other.neighbour[k] != static_cast<int>(b)) continue;
        const FaceGeometry back = face_geometry(other.shape, static_cast<int>(k));
        const double away = (back.centroid - face.centroid).norm();
        if (away > nearest) continue;
        nearest = away;
        area = back.area;
      }
      EXPECT_NEAR(area, face.area, 1e-7);
    }
  }
}

/// Area of the facets that a plane gives its class.
double classed_area(const Tessellation& rock, const CutPlane& plane) {
  FacetSet set = build_facets(rock.blocks, 1, [](const Vec3&) { return Support::free; });
  assign_joint_classes({{plane.point, plane.normal, 1}}, rock.blocks, 1, set.facets);
  double area = 0.0;
  for (const Facet& facet : set.facets) area += facet.joint_class == 1 ? facet.area : 0.0;
  return area;
}

TEST(PlaneParts, AllOfAPlaneIsFacets) {
  EXPECT_NEAR(classed_area(crossed(), kAcross) / kAreaAcross, 1.0, 1e-5);  // slivers have no facet
  EXPECT_NEAR(classed_area(crossed(), kAlong) / kAreaAlong, 1.0, 1e-5);
}

TEST(PlaneParts, HoleThroughAPlaneKeepsItsVolume) {
  TessellationOptions options = options_with({kAlong});
  options.holes = {{Vec3(2.0, 1.5, 0.5), Vec3(2.0, 1.5, 2.5), 0.4}};
  const Tessellation rock = tessellate(options);
  const TessellationStatistics& s = rock.statistics;
  EXPECT_NEAR(s.hole_volume[0] / s.cylinder_volume[0], 1.0, 0.03);  // few, large faces around it
  const double lost = M_PI * 0.16 / kBox.x() / kBox.y();            // part of the plane in the hole
  EXPECT_NEAR(classed_area(rock, kAlong) / kAreaAlong, 1.0 - lost, 0.02);
}

// Blocks of 0.2 m at the hole, up to 1 m beside it. At a plane the blocks of its two sides are
// alike, as many as both ask for together, whichever way its normal looks: seeds of one side alone
// would make 15 % more or fewer of all of them.
TEST(PlaneParts, APlaneBesideAChargeLeavesTheNumberOfBlocks) {
  TessellationOptions options = options_with({});
  options.hi = Vec3(4.0, 4.0, 2.0);
  options.holes = {{Vec3(2.0, 2.0, 0.0), Vec3(2.0, 2.0, 2.0), 0.15}};
  options.size = SizeLaw::power({0.8, 2.0}, {0.2, 1.0});
  const auto blocks = [&] { return static_cast<double>(tessellate(options).blocks.size()); };
  const double without = blocks();
  for (const double x : {1.2, 2.4, 2.6, 2.8}) {
    for (const double side : {1.0, -1.0}) {
      options.planes = {{Vec3(x, 0.0, 0.0), side * Vec3::UnitX()}};
      // Rounding of the number of a layer, and blocks that a plane cuts off too thin.
      EXPECT_NEAR(blocks() / without, 1.0, 0.04) << x << ", normal " << side;
    }
  }
}

TEST(PlaneParts, PlaneWithoutNormalIsRefused) {
  EXPECT_THROW(static_cast<void>(tessellate(options_with({{Vec3::Zero(), Vec3::Zero()}}))),
               InputError);
}

TEST(PlaneParts, PlaneBesideTheRockChangesNothing) {
  const Tessellation plain = tessellate(options_with({})),
                     beside = tessellate(options_with({{Vec3(9.0, 0.0, 0.0), Vec3::UnitX()}}));
  ASSERT_EQ(plain.blocks.size(), beside.blocks.size());
  for (std::size_t b = 0; b < plain.blocks.size(); ++b)
    EXPECT_EQ((plain.blocks[b].mass.centroid - beside.blocks[b].mass.centroid).norm(), 0.0);
}

}  // namespace
}  // namespace muckpile
