// SPDX-License-Identifier: GPL-2.0-or-later
// The void of a hole is its cylinder's, whatever planes cross it, with rings and without.
// Scope: random scenes of some 300 blocks of 1 m, with whole, half and quarter holes of 0.9 to 4
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

/// Blocks over the radius of a hole.
struct Blocks {
  double least, most;
};

Scene scene_of(int number, const Blocks& blocks) {
  Random random(static_cast<std::uint64_t>(number));
  Scene scene;
  TessellationOptions& rock = scene.rock;
  rock.lo = Vec3(-3.5, -3.0, 0.0);
  rock.hi = Vec3(3.5, 3.0, 7.0);
  rock.size = SizeLaw::uniform(1.0);
  rock.seed = static_cast<unsigned long>(number) + 1;
  const double radius = 1.0 / between(random, blocks.least, blocks.most);
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

/// Of all scenes.
struct Voids {
  double narrowest = 2.0, widest = 0.0;   // over the cylinder
  double unclosed = 0.0;                  // rock lost elsewhere, over the cylinder
  double smallest = 1.0, thinnest = 1.0;  // block, and its 3 V / A, over its size
  std::size_t lost = 0;                   // parts
};

Voids voids_of_scenes(const Blocks& over_radius) {
  constexpr double kRounding = 100.0;  // heights of walls are solved to 1e-9 of a cell's volume
  Voids found;
  for (int number = 0; number < kScenes; ++number) {
    SCOPED_TRACE(number);
    const auto [rock, share] = scene_of(number, over_radius);
    const Tessellation cut = tessellate(rock);
    double voids = 0.0, cylinders = 0.0;
    for (std::size_t h = 0; h < rock.holes.size(); ++h) {
      const double cylinder = share * cylinder_volume(rock.holes[h]);
      const double ratio = cut.statistics.hole_volume[h] / cylinder;
      found.narrowest = std::min(found.narrowest, ratio);
      found.widest = std::max(found.widest, ratio);
      voids += cut.statistics.hole_volume[h];
      cylinders += cylinder;
    }
    const double unclosed = std::abs(cut.statistics.void_volume - voids) / cylinders;
    found.unclosed = std::max(found.unclosed, unclosed);
    found.lost += cut.statistics.lost_parts;
    for (const Block& block : cut.blocks) {
      test::expect_convex_and_closed(block, kRounding);
      found.smallest = std::min(found.smallest, std::cbrt(block.mass.volume) / block.target_size);
      found.thinnest = std::min(found.thinnest, mean_radius(block.shape) / block.target_size);
    }
    (void)test::expect_shared_faces(cut.blocks, kRounding);
  }
  std::printf(
      "void over cylinder %.4f to %.4f, rock lost elsewhere up to %.4f of it; smallest "
      "block over its size %.3f, its 3 V / A %.3f\n",
      found.narrowest, found.widest, found.unclosed, found.smallest, found.thinnest);
  return found;
}

TEST(HoleVoids, AreTheCylindersWhateverPlanesCrossThem) {
  const Voids voids = voids_of_scenes({1.6, 4.0});
  EXPECT_GT(voids.narrowest, 0.999);
  EXPECT_LT(voids.widest, 1.001);
  EXPECT_LT(voids.unclosed, 1e-3);
  EXPECT_EQ(voids.lost, 0U);
  EXPECT_GT(voids.smallest, 0.45);
  EXPECT_GT(voids.thinnest, 0.12);
}

/// Images of the seeds would leave up to 1.96 times the cylinder. Three thin parts get no seed:
/// what they had of the rock is missing beside the void, by up to 1.3 % of it.
TEST(HoleVoids, AreTheCylindersWithoutRingsToo) {
  const Voids voids = voids_of_scenes({0.9, 1.45});
  EXPECT_GT(voids.narrowest, 0.995);
  EXPECT_LT(voids.widest, 1.015);
  EXPECT_LT(voids.unclosed, 1e-3);
  EXPECT_LE(voids.lost, 3U);  // parts too thin for a seed
  EXPECT_GT(voids.smallest, 0.4);
  EXPECT_GT(voids.thinnest, 0.12);
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
