// SPDX-License-Identifier: GPL-2.0-or-later
// The spheres in a block: never outside, large enough, reaching the corners, covering the volume.
// Scope: relaxed and unrelaxed Voronoi cells, box and tetrahedron; lengths in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "args/input_error.h"
#include "geometry/spheres/sphere_filling.h"
#include "math/random.h"
#include "shapes.h"

namespace muckpile {
namespace {

// How far the worst sphere sticks out of the block [m]; negative inside.
double worst_overhang(const Polyhedron& shape, const std::vector<Sphere>& spheres) {
  double worst = -std::numeric_limits<double>::infinity();
  for (int f = 0; f < static_cast<int>(shape.faces.size()); ++f) {
    const FaceGeometry face = face_geometry(shape, f);
    if (face.area < 1e-12) continue;  // the direction of such a sliver is noise
    for (const Sphere& s : spheres) {
      worst = std::max(worst, face.normal.dot(s.centre - face.centroid) + s.radius);
    }
  }
  return worst;
}

double covered_share(const Block& block, const std::vector<Sphere>& spheres) {
  Random random(17);
  Vec3 lo = block.shape.vertices.front(), hi = lo;
  for (const Vec3& v : block.shape.vertices) {
    lo = lo.cwiseMin(v);
    hi = hi.cwiseMax(v);
  }
  constexpr int kSamples = 2000;
  int hits = 0;
  for (int k = 0; k < kSamples; ++k) {
    const double u = random.uniform(), v = random.uniform(), w = random.uniform();
    const Vec3 p = lo + Vec3(u, v, w).cwiseProduct(hi - lo);
    const auto holds = [&](const Sphere& s) { return (p - s.centre).norm() < s.radius; };
    hits += std::any_of(spheres.begin(), spheres.end(), holds) ? 1 : 0;
  }
  return static_cast<double>(hits) / kSamples * (hi - lo).prod() / block.mass.volume;
}

double mean_coverage(const Tessellation& cells, int count) {
  double sum = 0.0;
  for (const Block& block : cells.blocks) {
    sum += covered_share(block, fill_with_spheres(block.shape, block.mass.centroid, count));
  }
  return sum / static_cast<double>(cells.blocks.size());
}

TEST(SphereFilling, OneSphereIsTheInscribedOne) {
  const Polyhedron cube = test::box(Vec3(1, 1, 1), Vec3(3, 3, 3));
  const std::vector<Sphere> spheres = fill_with_spheres(cube, Vec3(2, 2, 2), 1);
  ASSERT_EQ(spheres.size(), 1u);
  EXPECT_NEAR(spheres[0].radius, 1.0, 1e-9);
  // Inscribed radius of the corner tetrahedron 1 / (3 + sqrt 3) = 0.21132; the search promises 1 %.
  const Polyhedron corner = test::corner_tetrahedron();
  const double radius = fill_with_spheres(corner, Vec3::Constant(0.25), 1)[0].radius;
  EXPECT_LE(radius, 1.0 / (3.0 + std::sqrt(3.0)));
  EXPECT_GT(radius, 0.99 / (3.0 + std::sqrt(3.0)));
}

TEST(SphereFilling, NothingSticksOutOfAThousandCells) {
  for (const int sweeps : {0, 5}) {
    const Tessellation cells = test::cube_of_blocks(8.0, sweeps, 11);
    EXPECT_GT(cells.blocks.size(), 500u);
    for (const Block& block : cells.blocks) {
      const auto spheres = fill_with_spheres(block.shape, block.mass.centroid, 8);
      ASSERT_EQ(spheres.size(), 8u);
      // Planes of small faces carry rounding of 1e-16 m / 1e-6 m edge over 1 m.
      EXPECT_LT(worst_overhang(block.shape, spheres), 1e-9);
      for (const Sphere& s : spheres) EXPECT_GE(s.radius, 0.49 * spheres[0].radius);
    }
  }
}

TEST(SphereFilling, MoreSpheresThanCornersAreAllDifferent) {
  const Polyhedron shape = test::corner_tetrahedron();
  const auto spheres = fill_with_spheres(shape, Vec3::Constant(0.25), 9);
  ASSERT_EQ(spheres.size(), 9u);
  EXPECT_LT(worst_overhang(shape, spheres), 1e-12);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    EXPECT_GE(spheres[i].radius, 0.2 * spheres[0].radius);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT((spheres[i].centre - spheres[j].centre).norm(), 0.01);
    }
  }
}

TEST(SphereFilling, CoverageGrowsWithTheNumberOfSpheres) {
  const Tessellation cells = test::cube_of_blocks(4.0, 10, 3);
  // Measured 0.47, 0.55, 0.63, 0.69 on such cells; cells vary by 0.03 with the seed.
  const double one = mean_coverage(cells, 1), four = mean_coverage(cells, 4);
  const double eight = mean_coverage(cells, 8), sixteen = mean_coverage(cells, 16);
  EXPECT_GT(one, 0.42);
  EXPECT_GT(four, one + 0.04);
  EXPECT_GT(eight, 0.58);
  EXPECT_GT(sixteen, eight + 0.03);
}

TEST(SphereFilling, CornerSpheresReachOutFurtherThanTheInscribedOne) {
  const Polyhedron cube = test::box(Vec3::Zero(), Vec3::Ones());
  const auto spheres = fill_with_spheres(cube, Vec3::Constant(0.5), 9);
  for (const Vec3& corner : cube.vertices) {
    double gap = 1.0;
    for (const Sphere& s : spheres) gap = std::min(gap, (corner - s.centre).norm() - s.radius);
    // Sphere of radius 1/4 in the corner: (sqrt 3 - 1) / 4 = 0.183; one sphere alone leaves 0.366.
    EXPECT_NEAR(gap, (std::sqrt(3.0) - 1.0) / 4.0, 1e-9);
  }
}

TEST(SphereFilling, IsRepeatable) {
  const Polyhedron cell = test::voronoi_cell(4);
  const Vec3 centroid = mass_properties(cell).centroid;
  const auto first = fill_with_spheres(cell, centroid, 8);
  const auto second = fill_with_spheres(cell, centroid, 8);
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first[k].centre, second[k].centre);
    EXPECT_EQ(first[k].radius, second[k].radius);
  }
}

TEST(SphereFilling, RejectsACountBelowOne) {
  const Polyhedron cube = test::box(Vec3::Zero(), Vec3::Ones());
  EXPECT_THROW((void)fill_with_spheres(cube, Vec3::Constant(0.5), 0), InputError);
}

}  // namespace
}  // namespace muckpile
