// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/muckpile gives what fix multisphere gives, and full-step velocities to those who
// read them.
// Scope: a few dozen colliding, spinning blocks; run with mpirun -np 1, 2 and 4 (2 x 2,
// where spheres of one body lie on up to four ranks).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "fixes/engine/bodies.h"
#include "rock_scene.h"
#include "silent_engine.h"

namespace muckpile::test {
namespace {

constexpr double kStep = 1e-4;  // [s]
/// Both rotations are of second order, by different laws: (10 rad/s times the step)^2 apart.
constexpr double kOtherRotation = 1e-6;

/// Loose blocks that fly together under gravity.
void collide(RockScene& scene) {
  scene.command("pair_style muckpile/block youngs_modulus 1e8");
  scene.command("pair_coeff * *");
  scene.cut("-1 1 -0.5 0.5 -0.5 0.5",
            "density 2600 size uniform 0.4 block_min 0.4 block_max 0.4 spheres_per_block 4 seed 2");
  scene.command("fix pull all gravity 9.81 vector 0 0 -1");
  scene.set_motion([](int, const Vec3& at) {
    return Motion{-3.0 * at, Vec3(5.0 * at.y(), 1.0, -4.0 * at.x())};
  });
  scene.run(600, kStep);
}

TEST(FixMultisphereMuckpile, MovesBlocksAndSpheresAsFixMultisphereDoes) {
  std::array<std::map<int, BlockNow>, 2> blocks;
  std::array<std::map<int, SphereNow>, 2> spheres;
  for (const bool ours : {false, true}) {
    RockScene scene(MPI_COMM_WORLD, "-3 3 -3 3 -3 3", "* * 1",
                    ours ? "multisphere/muckpile" : "multisphere");
    collide(scene);
    blocks[ours] = scene.blocks();
    spheres[ours] = scene.all_spheres();
  }
  double hit = 0.0, apart = 0.0;
  for (const auto& [tag, block] : blocks[0]) {
    hit = std::max(hit, (block.spin - Vec3(0.0, 1.0, 0.0)).norm());
    apart = std::max({apart, (block.centre - blocks[1].at(tag).centre).norm(),
                      (block.velocity - blocks[1].at(tag).velocity).norm()});
  }
  EXPECT_GT(hit, 5.0);               // the blocks did collide
  EXPECT_LT(apart, kOtherRotation);  // m and m/s
  // The last step of a run is an output step: spheres carry full-step velocities there.
  for (const auto& [tag, sphere] : spheres[0]) {
    EXPECT_LT((spheres[1].at(tag).centre - sphere.centre).norm(), kOtherRotation) << tag;
    EXPECT_LT((spheres[1].at(tag).velocity - sphere.velocity).norm(), kOtherRotation) << tag;
  }
}

/// Of the spheres' velocities, read at every `every`-th step.
std::array<double, 2> means_of_both(int every) {
  std::array<double, 2> mean{};
  for (const bool ours : {false, true}) {
    RockScene scene(MPI_COMM_WORLD, "-3 3 -3 3 -3 3", "* 1 1",
                    ours ? "multisphere/muckpile" : "multisphere");
    scene.command("compute v all reduce ave vz");
    scene.command("fix mean all ave/time " + std::to_string(every) + " " +
                  std::to_string(200 / every) + " 200 c_v");
    collide(scene);
    mean[ours] = scene.output("mean", 0);
  }
  return mean;
}

TEST(FixMultisphereMuckpile, AveragesAreThoseOfFixMultisphereHoweverOftenTheyAreTaken) {
  for (const int every : {1, 8, 50}) {
    const auto [theirs, ours] = means_of_both(every);
    EXPECT_LT(theirs, -0.1) << every;
    EXPECT_NEAR(ours, theirs, 0.01 * kOtherRotation) << every;  // of a few dozen blocks
  }
}

/// A block of two spheres has its centre beside the line between them: in a box that grows with the
/// spheres the outermost centres would be outside as blocks turn.
TEST(FixMultisphereMuckpile, KeepsTheOutermostBlocksInABoxThatGrowsWithThem) {
  const auto lmp = silent_engine(MPI_COMM_WORLD);
  run_lines(*lmp,
            {"units si", "atom_style granular", "atom_modify map array sort 0 0", "newton off",
             "boundary m m m", "communicate single cutoff 1.0 vel yes",
             "region box block -2 2 -2 2 -2 2 units box", "create_box 1 box", "neighbor 0.05 bin",
             "neigh_modify delay 0", "pair_style muckpile/block", "pair_coeff * *",
             "fix bodies all multisphere/muckpile", "region rock block -1 1 -1 1 -1 1 units box",
             "create_blocks rock density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 "
             "spheres_per_block 2 sphere_growth 1 seed 2"});
  LAMMPS_NS::FixMultisphere& fix = *engine::find_multisphere(*lmp);
  const int blocks = fix.n_body_all();
  engine::Bodies bodies(fix);
  for (int b = 0; b < bodies.count(); ++b) {
    bodies.velocity(b) = 10.0 * bodies.centre(b);
    bodies.spin(b) = Vec3(3.0, 5.0, -4.0);
    bodies.angular_momentum(b) = bodies.inertia(b).x() * bodies.spin(b);
  }
  run_lines(*lmp, {"timestep 1e-4", "run 10000"});  // to ten times the box
  EXPECT_GT(blocks, 50);
  EXPECT_EQ(fix.n_body_all(), blocks);
}

}  // namespace
}  // namespace muckpile::test
