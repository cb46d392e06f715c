// SPDX-License-Identifier: GPL-2.0-or-later
// The void of a hole with rings is its cylinder's, whatever planes cross it.
// Scope: random scenes of some 300 blocks of 1 m, with whole, half and quarter holes of 1.6 to 4
// blocks over radius, up to two of them, that lean, and up to four planes; every scene follows from
// its number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "cut_checks.h"
#include "geometry/cut/open_planes.h"
#include "geometry/cut/tessellation.h"
#include "geometry/holes/hole_surface.h"
#include "math/random.h"

namespace muckpile {
namespace {

constexpr int kScenes = 60;

double between(Random& random, double from, double to) {
  return from + (to - from) * random.uniform();
}

Vec3 around(Random& random, double reach) {
  const double x = between(random, -reach, reach), y = between(random, -reach, reach),
               z = between(random, -reach, reach);
  return {x, y, z};
}

struct Scene {
  TessellationOptions rock;
  double share = 1.0;  // of each hole that is modelled
};

Scene scene_of(int number) {
  Random random(static_cast<std::uint64_t>(number));
  Scene scene;
  TessellationOptions& rock = scene.rock;
  rock.lo = Vec3(-3.5, -3.0, 0.0);
  rock.hi = Vec3(3.5, 3.0, 7.0);
  rock.size = SizeLaw::uniform(1.0);
  rock.seed = static_cast<unsigned long>(number) + 1;
  const double radius = 1.0 / between(random, 1.6, 4.0);
  Vec3 toe = around(random, 0.3) + Vec3(0, 0, 1.5), lean = around(random, 0.5) + Vec3(0, 0, 3.2);
  const int kind = number % 4;  // whole, half, quarter, two
  if (kind == 1 || kind == 2) toe.x() = rock.lo.x(), lean.x() = 0.0;
  if (kind == 2) toe.y() = rock.lo.y(), lean.y() = 0.0;
  scene.share = kind == 1 ? 0.5 : kind == 2 ? 0.25 : 1.0;
  const Vec3 beside(1.7, 0, 0);
  rock.holes = {{toe, toe + lean, radius}};
  if (kind == 3)
    rock.holes = {{toe - beside, toe - beside + lean, radius},
                  {toe + beside, toe + beside + lean, radius}};
  const int planes = 1 + number / 4 % 4;
  for (int k = 0; k < planes; ++k) {
    const Hole& hole = rock.holes[static_cast<std::size_t>(k) % rock.holes.size()];
    const Vec3 at = hole.toe + random.uniform() * (hole.collar - hole.toe) + around(random, 0.6);
    Vec3 normal = around(random, 1.0);
    while (normal.norm() < 0.1) normal = around(random, 1.0);
    rock.planes.push_back({at, normal});
  }
  return scene;
}

TEST(HoleVoids, AreTheCylindersWhateverPlanesCrossThem) {
  constexpr double kRounding = 100.0;  // heights of walls are solved to 1e-9 of a cell's volume
  double narrowest = 2.0, widest = 0.0, smallest = 1.0, thinnest = 1.0, unclosed = 0.0;
  for (int number = 0; number < kScenes; ++number) {
    SCOPED_TRACE(number);
    const auto [rock, share] = scene_of(number);
    const Tessellation cut = tessellate(rock);
    double voids = 0.0, cylinders = 0.0;
    for (std::size_t h = 0; h < rock.holes.size(); ++h) {
      const double cylinder = share * cylinder_volume(rock.holes[h]);
      const double ratio = cut.statistics.hole_volume[h] / cylinder;
      narrowest = std::min(narrowest, ratio);
      widest = std::max(widest, ratio);
      voids += cut.statistics.hole_volume[h];
      cylinders += cylinder;
    }
    unclosed = std::max(unclosed, std::abs(cut.statistics.void_volume - voids) / cylinders);
    EXPECT_EQ(cut.statistics.lost_parts, 0u);
    for (const Block& block : cut.blocks) {
      test::expect_convex_and_closed(block, kRounding);
      smallest = std::min(smallest, std::cbrt(block.mass.volume) / block.target_size);
      thinnest = std::min(thinnest, mean_radius(block.shape) / block.target_size);
    }
    (void)test::expect_shared_faces(cut.blocks, kRounding);
  }
  std::printf(
      "void over cylinder %.4f to %.4f, rock lost elsewhere up to %.4f of it; smallest "
      "block over its size %.3f, its 3 V / A %.3f\n",
      narrowest, widest, unclosed, smallest, thinnest);
  EXPECT_GT(narrowest, 0.999);
  EXPECT_LT(widest, 1.001);
  EXPECT_LT(unclosed, 1e-3);
  EXPECT_GT(smallest, 0.45);
  EXPECT_GT(thinnest, 0.12);
}

TEST(OpenPlanes, AreFacesInPlanesThatLostTheirNeighbour) {
  TessellationOptions rock;
  rock.lo = Vec3::Constant(-2.0);
  rock.hi = Vec3::Constant(2.0);
  rock.size = SizeLaw::uniform(0.8);
  rock.planes.push_back({Vec3(0, 0, 0.1), Vec3::UnitZ()});
  Tessellation cut = tessellate(rock);
  OpenPlanes open = open_planes(rock, cut.blocks);
  EXPECT_EQ(open.faces, 0u);
  EXPECT_NEAR(open.all, 2.0 * 16.0, 1e-6);  // both sides of 4 by 4 m
  bool lost = false;
  double area = 0.0;
  for (Block& block : cut.blocks) {
    for (std::size_t f = 0; f < block.neighbour.size() && !lost; ++f) {
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      if (std::abs(face.centroid.z() - 0.1) > 1e-9 || face.normal.z() < 0.99) continue;
      block.neighbour[f] = kFreeFace;
      area = face.area;
      lost = true;
    }
  }
  open = open_planes(rock, cut.blocks);
  EXPECT_EQ(open.faces, 1u);
  EXPECT_NEAR(open.area, area, 1e-12);
}

}  // namespace
}  // namespace muckpile
