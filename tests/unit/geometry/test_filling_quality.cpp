// SPDX-License-Identifier: GPL-2.0-or-later
// Coverage and surface deviation of sphere fillings, and how both improve with the number of
// spheres. Scope: a cube with one ball by hand; relaxed Voronoi blocks for the table in
// docs/styles/create_blocks.md.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/spheres/filling_quality.h"
#include "shapes.h"

namespace muckpile {
namespace {

TEST(FillingQuality, OfTheBallInACube) {
  const Polyhedron cube = test::box(Vec3::Constant(-0.5), Vec3::Constant(0.5));
  const FillingQuality q = filling_quality(cube, {{Vec3::Zero(), 0.5}});
  EXPECT_NEAR(q.coverage, M_PI / 6.0, 0.01);
  // mean over a face of sqrt(x^2 + y^2 + 1/4) - 1/2: the mean distance of the unit cube's faces
  // from its centre is 0.640395 (numerical integral, 4000 x 4000 points)
  EXPECT_NEAR(q.surface_deviation, 0.140395, 0.003);
}

TEST(FillingQuality, CountsASurfaceInsideASphereToo) {
  const Polyhedron cube = test::box(Vec3::Constant(-0.5), Vec3::Constant(0.5));
  const FillingQuality q = filling_quality(cube, {{Vec3::Zero(), 1.0}});
  EXPECT_EQ(q.coverage, 1.0);
  EXPECT_NEAR(q.surface_deviation, 1.0 - 0.640395, 0.003);
}

TEST(FillingQuality, ImprovesWithTheNumberOfSpheres) {
  const Tessellation cells = test::cube_of_blocks(5.0, 20, 3);
  double coverage_before = 0.0, deviation_before = 1.0;
  for (const int count : {1, 4, 8, 16, 32}) {
    FillingQuality mean;
    for (const Block& block : cells.blocks) {
      const FillingQuality q =
          filling_quality(block.shape, fill_with_spheres(block.shape, block.mass.centroid, count));
      mean.coverage += q.coverage / static_cast<double>(cells.blocks.size());
      mean.surface_deviation += q.surface_deviation / static_cast<double>(cells.blocks.size());
    }
    std::printf("n %d: coverage %.3f, surface deviation %.4f\n", count, mean.coverage,
                mean.surface_deviation);
    EXPECT_GT(mean.coverage, coverage_before) << count;
    EXPECT_LT(mean.surface_deviation, deviation_before) << count;
    coverage_before = mean.coverage;
    deviation_before = mean.surface_deviation;
  }
}

}  // namespace
}  // namespace muckpile
