// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/ground: blocks thrown at a floor and pressed into it come back out, with the
// energy that they brought; LIGGGHTS' own fix wall/gran lets them through.
// Scope: a single sphere with a closed form, blocks of five spheres, a pile on a block.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"
#include "wall_scenes.h"

namespace muckpile::test {
namespace {

constexpr double kDensity = 2600.0, kSide = 0.5;     // [kg/m3], [m]
constexpr double kModulus = 2.5e7, kPoisson = 0.25;  // of blocks, and of the floor [Pa], [-]
constexpr double kStep = 1e-5, kSpeed = 35.0;        // [s], [m/s]

/// The floor z = 0 for x > 0, and the step down to z = -1 at x = 0, as in common/pit_floor.in.
void write_floor(const std::filesystem::path& path) {
  write_facets(path, [](const auto& facet) {
    facet("0 -3.9 0", "7.9 -3.9 0", "7.9 3.9 0");
    facet("0 -3.9 0", "7.9 3.9 0", "0 3.9 0");
    facet("0 -3.9 -1", "0 -3.9 0", "0 3.9 0");
    facet("0 -3.9 -1", "0 3.9 0", "0 3.9 -1");
  });
}

/// Contacts and that floor.
void add_floor(RockScene& scene, const std::string& wall, const ScratchFolder& folder,
               double restitution) {
  add_contacts(scene, restitution, "", "0.7");
  write_floor(folder / "floor.stl");
  scene.command("fix floor all mesh/surface file " + (folder / "floor.stl").string() + " type 1");
  scene.command("fix ground all " + wall +
                " model hertz tangential history mesh n_meshes 1 meshes floor");
}

/// A scene with that floor, whose blocks are still to be cut.
RockScene scene_above_floor(const std::string& wall, const ScratchFolder& folder,
                            double restitution) {
  RockScene scene(MPI_COMM_WORLD, "-2 8 -4 4 -4 6", "* * 1", "multisphere/muckpile");
  add_floor(scene, wall, folder, restitution);
  return scene;
}

/// Some blocks of five spheres just above the floor, which go down at `speed` and turn.
RockScene thrown_blocks(const std::string& wall, const ScratchFolder& folder, double speed) {
  RockScene scene = scene_above_floor(wall, folder, 0.5);
  scene.cut("2 3.5 -0.75 0.75 0.2 1.7", half_metre_blocks(5, 1.19));
  throw_down(scene, speed);
  return scene;
}

/// One cube with one sphere falls at kSpeed on the floor, right over the edge of two triangles.
RockScene thrown_sphere(const std::string& wall, const ScratchFolder& folder) {
  RockScene scene = scene_above_floor(wall, folder, 1.0);
  scene.cut("3.7 4.2 -0.25 0.25 0.3 0.8", half_metre_blocks(1, 1.0));
  scene.set_motion([](int, const Vec3&) { return Motion{Vec3(0, 0, -kSpeed), Vec3::Zero()}; });
  return scene;
}

TEST(FixMuckpileGround, SpherePressedThroughAFaceComesBackAsFastAsItCame) {
  const ScratchFolder folder("one_sided_rebound");
  RockScene scene = thrown_sphere("muckpile/ground", folder);
  const double radius = scene.all_spheres().at(1).radius, mass = scene.blocks().at(1).mass;
  double lowest = 1.0;
  for (int look = 0; look < 120; ++look) {
    scene.run(50, kStep);
    lowest = std::min(lowest, lowest_centre(scene));
  }
  // Hertz up to the centre, 8/15 E* sqrt(R) R^2.5; behind it the sphere counts as one of radius
  // R + h with overlap R + h: 4/9 E* ((R + h)^3 - R^3).
  const double contact = kModulus / (2.0 * (1.0 - kPoisson * kPoisson));
  const double before = 8.0 / 15.0 * contact * std::pow(radius, 3);
  const double behind = 0.5 * mass * kSpeed * kSpeed - before;
  ASSERT_GT(behind, 0.0);
  const double depth = std::cbrt(std::pow(radius, 3) + 9.0 / 4.0 * behind / contact) - radius;
  EXPECT_NEAR(-lowest / depth, 1.0, 0.03);  // shown 0.01 R larger; a look every 50 steps
  EXPECT_NEAR(scene.blocks().at(1).velocity.z(), kSpeed, 1e-3 * kSpeed);
  EXPECT_NEAR(scene.blocks().at(1).velocity.head<2>().norm(), 0.0, 1e-6);
}

/// What the style is for: without it, the sphere goes through and is shot on.
TEST(FixMuckpileGround, LiggghtsOwnWallLetsThatSphereThrough) {
  const ScratchFolder folder("two_sided_through");
  RockScene scene = thrown_sphere("wall/gran", folder);
  scene.run(6000, kStep);
  EXPECT_LT(lowest_centre(scene), -0.5);
}

/// Some land on others.
TEST(FixMuckpileGround, BlocksThrownAtTheFloorStayAboveIt) {
  const ScratchFolder folder("one_sided_blocks");
  RockScene scene = thrown_blocks("muckpile/ground", folder, 45.0);
  ASSERT_GE(scene.blocks().size(), 20u);
  const double brought = scene.kinetic_energy();
  double lowest = 1.0;
  for (int look = 0; look < 50; ++look) {
    scene.run(100, 2.0 * kStep);
    lowest = std::min(lowest, lowest_centre(scene));
  }
  EXPECT_GT(lowest, 0.0);
  EXPECT_LT(scene.kinetic_energy(), brought);
}

TEST(FixMuckpileGround, BlocksThatAreNotPressedThroughMoveAsOnLiggghtsOwnWall) {
  const ScratchFolder one("one_sided_slow"), two("two_sided_slow");
  RockScene ours = thrown_blocks("muckpile/ground", one, 5.0);
  const double start = ours.kinetic_energy();
  ours.run(2500, 2.0 * kStep);
  RockScene theirs = thrown_blocks("wall/gran", two, 5.0);
  theirs.run(2500, 2.0 * kStep);
  EXPECT_LT(ours.kinetic_energy(), 0.8 * start) << "they hit";
  EXPECT_EQ(farthest_apart(ours, theirs), 0.0);
}

TEST(FixMuckpileGround, RestartWithSpheresBehindTheFaceGoesOnAsWithout) {
  const ScratchFolder folder("one_sided_restart");
  const std::string file = (folder / "deep.restart").string();
  RockScene went_on = thrown_blocks("muckpile/ground", folder, 45.0);
  went_on.run(850, kStep);
  double lowest = 1.0;
  for (const auto& [tag, sphere] : went_on.all_spheres())
    lowest = std::min(lowest, sphere.centre.z());
  ASSERT_LT(lowest, -0.01);
  went_on.command("write_restart " + file);
  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add_floor(restarted, "muckpile/ground", folder, 0.5);
  went_on.run(300, kStep);
  restarted.run(300, kStep);
  EXPECT_LT(farthest_apart(went_on, restarted), 1e-9);
}

/// In front of the step rock lies deeper than the floor; the step holds it.
TEST(FixMuckpileGround, BlockPressedAtTheStepGoesBackTheWayItCame) {
  const ScratchFolder folder("one_sided_step");
  RockScene scene = scene_above_floor("muckpile/ground", folder, 1.0);
  scene.cut("-0.8 -0.3 -0.25 0.25 -0.6 -0.1", half_metre_blocks(1, 1.0));
  scene.set_motion([](int, const Vec3&) { return Motion{Vec3(kSpeed, 0, 0), Vec3::Zero()}; });
  const double radius = scene.all_spheres().at(1).radius;
  double deepest = -1.0;
  for (int look = 0; look < 60; ++look) {
    scene.run(100, kStep);
    deepest = std::max(deepest, scene.blocks().at(1).centre.x());
  }
  EXPECT_GT(deepest, 0.0);  // through the face
  EXPECT_LT(deepest, radius);
  EXPECT_NEAR(scene.blocks().at(1).velocity.x(), -kSpeed, 1e-3 * kSpeed);
}

}  // namespace
}  // namespace muckpile::test
