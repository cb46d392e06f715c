// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/wall in the engine: blocks thrown, sliding and at rest on planes and meshes, beside
// LIGGGHTS' own walls; its books and sleep.
// Scope: one block, or some 27 of 0.5 m.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "wall_scene.h"

namespace muckpile::test {
namespace {

struct Bounce {
  double speed, depth;  ///< after [m/s], of the centre [m]
};

/// One cube with one sphere falls on the floor at 10 m/s.
Bounce bounce_on(const std::string& wall, double restitution) {
  RockScene scene = scene_on(MPI_COMM_WORLD, wall, restitution);
  scene.cut("0 0.5 -0.25 0.25 0.3 0.8", words(1));
  scene.set_motion([](int, const Vec3&) { return Motion{Vec3(0, 0, -10), Vec3::Zero()}; });
  const double radius = scene.all_spheres().at(1).radius;
  double lowest = 1.0;
  for (int look = 0; look < 120; ++look) {
    scene.run(50, kStep);
    lowest = std::min(lowest, scene.all_spheres().at(1).centre.z() - radius);
  }
  return {scene.blocks().at(1).velocity.z(), -lowest};
}

TEST(FixMuckpileWall, BlockComesBackAsFromLiggghtsOwnWall) {
  const Bounce elastic = bounce_on(kPlane, 1.0), theirs = bounce_on(kStockPlane, 1.0);
  const Bounce damped = bounce_on(kPlane, 0.5), stock_damped = bounce_on(kStockPlane, 0.5);
  std::cout << "rebound: speed " << elastic.speed << " (LIGGGHTS " << theirs.speed
            << "), depth off by " << elastic.depth / theirs.depth - 1.0
            << "; restitution 0.5: " << damped.speed / 10.0 << " (LIGGGHTS "
            << stock_damped.speed / 10.0 << ")\n";
  EXPECT_NEAR(elastic.speed, 10.0, 1e-3);
  EXPECT_NEAR(elastic.depth / theirs.depth, 1.0, 1e-6);
  EXPECT_NEAR(damped.speed, 5.0, 0.02);
  EXPECT_NEAR(damped.speed, stock_damped.speed, 0.01);
}

/// Acceleration of a block on four of its nine spheres, once it slides down a slope of 25 degrees.
double acceleration_on(const std::string& wall) {
  RockScene scene = scene_on(MPI_COMM_WORLD, wall, 0.3);
  scene.cut("-0.5 0 -0.25 0.25 0.05 0.55", words(9, 1.0));
  scene.command("fix weight all gravity 9.81 vector 0 0 -1");
  scene.run(30000, kStep);
  scene.command("unfix weight");
  scene.command("fix weight all gravity 9.81 vector 0.4226183 0 -0.9063078");
  scene.run(5000, kStep);
  const double before = scene.blocks().at(1).velocity.x();
  scene.run(15000, kStep);
  return (scene.blocks().at(1).velocity.x() - before) / (15000 * kStep);
}

/// g (sin a - mu cos a) for a block that stays on its base.
TEST(FixMuckpileWall, BlockSlidesDownASlopeAsCoulombSays) {
  const ScratchFolder folder("wall_slide");
  const double theory = 9.81 * (0.4226183 - 0.3 * 0.9063078);
  const double plane = acceleration_on(kPlane), stock = acceleration_on(kStockPlane);
  const double mesh = acceleration_on("muckpile/wall mesh " + mesh_of(folder, 20.0, 5.0, 100));
  std::cout << "slide: acceleration off by " << plane / theory - 1.0 << ", on a mesh by "
            << mesh / theory - 1.0 << ", on LIGGGHTS' plane by " << stock / theory - 1.0 << "\n";
  EXPECT_NEAR(plane / theory, 1.0, 3e-3);
  EXPECT_NEAR(plane / stock, 1.0, 5e-3);
  EXPECT_NEAR(mesh / theory, 1.0, 3e-3);
}

/// A plane, triangles far smaller than a block and some 1 km long ones: the same for 0.2 s.
TEST(FixMuckpileWall, BlocksDoNotFeelTheTrianglesOfAFlatFloor) {
  const ScratchFolder fine("wall_fine"), wide("wall_wide"), thin("wall_thin");
  RockScene plane = thrown(MPI_COMM_WORLD, kPlane, 5.0);
  plane.run(10000, kStep);
  EXPECT_GT(plane.output("floor", rubbed), 100.0);  // they hit
  const auto apart_on = [&](const std::string& file) {
    RockScene scene = thrown(MPI_COMM_WORLD, "muckpile/wall mesh " + file, 5.0);
    scene.run(10000, kStep);
    return farthest_apart(plane, scene);
  };
  const double small = apart_on(mesh_of(fine, 12.0, 5.0, 120)),
               large = apart_on(mesh_of(wide, 500.0, 500.0, 2)),
               long_thin = apart_on(mesh_of(thin, 10000.0, 4.5, 1));
  std::cout << "apart from those on a plane [m]: small triangles " << small << ", ground of 1 km "
            << large << ", floor of 20 km by 9 m " << long_thin << "\n";
  EXPECT_LT(std::max({small, large, long_thin}), 1e-10);
}

/// Thrown so hard that centres of spheres get behind the faces.
TEST(FixMuckpileWall, BlocksThrownAtTheFloorStayAboveIt) {
  const ScratchFolder folder("wall_thrown");
  RockScene scene = thrown(MPI_COMM_WORLD, "muckpile/wall mesh " + mesh_of(folder, 12, 4, 7), 45.0);
  const double brought = scene.kinetic_energy();
  double lowest = 1.0, deepest = 0.0;
  for (int look = 0; look < 50; ++look) {
    scene.run(100, kStep);
    lowest = std::min(lowest, lowest_centre(scene));
    deepest = std::max(deepest, scene.output("floor", 2));
  }
  EXPECT_GT(deepest, 1.0);  // overlap over radius
  EXPECT_GT(lowest, 0.0);
  EXPECT_LT(scene.kinetic_energy(), brought);
  EXPECT_LT(scene.output("ledger", 0), 0.005);
}

/// What the ledger measures from the forces on the blocks is what the law says it took.
TEST(FixMuckpileWall, BooksOfTheWallAreThoseOfTheLedger) {
  RockScene scene = thrown(MPI_COMM_WORLD, kPlane, 5.0);
  double worst = 0.0;
  const double brought = scene.kinetic_energy();
  for (int look = 0; look < 40; ++look) {
    scene.run(1000, kStep);
    const double told = scene.output("floor", stored) + scene.output("floor", rubbed) +
                        scene.output("floor", damped);
    worst = std::max(worst, std::abs(told - scene.output("ledger", walls)) / brought);
  }
  std::cout << "books: wall and ledger differ by " << worst
            << " of the energy brought; balance error " << scene.output("ledger", 0) << "\n";
  EXPECT_GT(scene.output("floor", rubbed), 0.01 * brought);
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(scene.output("ledger", 0), 1e-3);
}

/// The wall bears the weight; blocks fall asleep on it and stay, with what its springs hold.
TEST(FixMuckpileWall, BlocksRestOnTheWall) {
  RockScene scene = scene_on(MPI_COMM_WORLD, kPlane + " rolling_friction 0.5", 0.3);
  scene.cut("-0.75 0.75 -0.75 0.75 0.0 0.5", words(5));
  scene.command("fix weight all gravity 9.81 vector 0 0 -1");
  scene.command("fix sleep all muckpile/sleep distance 1e-3 time 0.1");
  double weight = 0.0;
  for (const auto& [tag, block] : scene.blocks()) weight += 9.81 * block.mass;
  double lifted = 0.0;  // while all were awake, last
  for (int look = 0; look < 200 && scene.output("sleep", 0) < 1.0; ++look) {
    scene.run(500, kStep);
    if (scene.output("sleep", 0) == 0.0) lifted = -scene.output("floor", lift);
  }
  EXPECT_NEAR(lifted / weight, 1.0, 0.1);
  ASSERT_EQ(scene.output("sleep", 0), 1.0);
  const double held = scene.output("floor", stored), touching = scene.output("floor", contacts);
  const auto before = scene.blocks();
  scene.run(2000, kStep);
  for (const auto& [tag, block] : scene.blocks())
    EXPECT_EQ((block.centre - before.at(tag).centre).norm(), 0.0);
  EXPECT_GT(held, 0.0);
  EXPECT_EQ(scene.output("floor", stored), held);
  EXPECT_EQ(scene.output("floor", contacts), touching);
}

/// An elastic sphere is stopped short of its radius behind a face below
/// (16/15 E* sqrt(R) (2 R)^2.5 / m)^0.5 = 63 m/s.
TEST(FixMuckpileWall, SphereThatGetsTooDeepIsCounted) {
  const ScratchFolder folder("wall_through");
  const std::string wall = "muckpile/wall mesh " + mesh_of(folder, 12.0, 4.0, 7);
  for (const double speed : {55.0, 80.0}) {
    RockScene scene = scene_on(MPI_COMM_WORLD, wall, 1.0);
    scene.cut("0 0.5 -0.25 0.25 0.3 0.8", words(1, 1.0));
    scene.set_motion([&](int, const Vec3&) { return Motion{Vec3(0, 0, -speed), Vec3::Zero()}; });
    scene.run(2000, 0.5 * kStep);
    EXPECT_EQ(scene.output("floor", let_go), speed > 63.0 ? 1.0 : 0.0) << speed;
    EXPECT_EQ(scene.blocks().at(1).velocity.z() < 0.0, speed > 63.0) << speed;
  }
}

}  // namespace
}  // namespace muckpile::test
