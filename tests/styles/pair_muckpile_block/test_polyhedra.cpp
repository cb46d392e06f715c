// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block with shape polyhedra inside LIGGGHTS: energy, stacks, broken joints,
// several ranks, restart.
// Scope: rock cut by create_blocks; run with mpirun -np 1 and more, every check holds on any number
// of ranks.
#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

const std::string kBox = "-3 3 -3 3 -3 3";
const std::string kBlocks =
    "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 5 seed 4";

void contact(RockScene& scene, const std::string& words) {
  scene.command("pair_style muckpile/block shape polyhedra youngs_modulus 1e8 " + words);
  scene.command("pair_coeff * *");
}

/// Blocks of a cube of 2 m without joints fly apart, turn, and are then drawn together.
RockScene crowd(MPI_Comm comm, const std::string& words) {
  RockScene scene(comm, kBox);
  contact(scene, words);
  scene.cut("-1 1 -1 1 -1 1", kBlocks);
  scene.set_motion([](int tag, const Vec3& centre) {
    const double s = std::sin(1.7 * tag), c = std::cos(2.3 * tag);
    return Motion{-2.0 * centre + 0.5 * Vec3(s, c, s * c), Vec3(c, s, -s)};
  });
  return scene;
}

double booked(const RockScene& scene, const std::string& fix) { return scene.output(fix, 0); }

TEST(Polyhedra, EnergyOfACollapsingCrowdIsAccountedFor) {
  RockScene scene = crowd(MPI_COMM_WORLD, "restitution 0.5 friction 0.5");
  scene.command("fix ledger all muckpile/ledger");
  const double start = scene.kinetic_energy();
  double worst = 0.0;
  for (int part = 0; part < 10; ++part) {
    scene.run(400, 5e-5);
    worst = std::max(worst, booked(scene, "ledger"));
  }
  std::printf("kinetic energy %.0f of %.0f J left, balance error %.1e\n", scene.kinetic_energy(),
              start, worst);
  EXPECT_LT(scene.kinetic_energy(), 0.8 * start);
  EXPECT_LT(worst, 0.005);
}

TEST(Polyhedra, RanksShareACollapsingCrowdWithoutChangingIt) {
  const std::string words = "restitution 0.3 friction 0.6";
  RockScene alone = crowd(MPI_COMM_SELF, words), shared = crowd(MPI_COMM_WORLD, words);
  alone.run(300, 5e-5);
  shared.run(300, 5e-5);
  const auto expected = alone.blocks();
  double worst = 0.0, changed = 0.0;
  for (const auto& [tag, block] : shared.blocks()) {
    worst = std::max(worst, (block.velocity - expected.at(tag).velocity).norm());
    worst = std::max(worst, (block.spin - expected.at(tag).spin).norm());
    changed = std::max(changed, (block.velocity + 2.0 * block.centre).norm());
  }
  std::printf("largest difference of velocities %.1e m/s\n", worst);
  EXPECT_GT(changed, 0.6);
  EXPECT_LT(worst, 1e-8);
  EXPECT_EQ(shared.blocks().size(), expected.size());
}

TEST(Polyhedra, ARestartedRunGoesOnAsOneThatDidNotStop) {
  const ScratchFolder folder("polyhedra_restart");
  const std::string file = (folder / "file.restart").string();
  const std::string words = "restitution 0.3 friction 0.6";
  RockScene whole = crowd(MPI_COMM_WORLD, words);
  whole.run(200, 5e-5);
  whole.command("write_restart " + file);
  RockScene again = RockScene::restarted(MPI_COMM_WORLD, file, "* 1 1", "multisphere");
  contact(again, words);
  whole.run(100, 5e-5);
  again.run(100, 5e-5);
  double worst = 0.0;
  const auto expected = whole.blocks();
  for (const auto& [tag, block] : again.blocks())
    worst = std::max(worst, (block.velocity - expected.at(tag).velocity).norm());
  std::printf("largest difference of velocities %.1e m/s\n", worst);
  EXPECT_LT(worst, 1e-5);
  EXPECT_EQ(again.blocks().size(), expected.size());
}

// Weak rock breaks up and is caught by its own contacts; the joints hand over without a jump.
TEST(Polyhedra, JointsThatBreakHandOverWithoutGivingEnergy) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  contact(scene, "restitution 0.3 friction 0.6");
  scene.cut("-1 1 -1 1 -1 1", kBlocks);
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 cohesion "
      "2e4 friction_angle 50 tension 1e4");
  scene.command("fix ledger all muckpile/ledger");
  scene.set_motion([](int tag, const Vec3& centre) {
    return Motion{(centre.x() > 0 ? -1.0 : 1.0) * Vec3(1, 0.5, 0),
                  0.2 * std::sin(tag) * Vec3::UnitZ()};
  });
  scene.run(0, 1e-6);
  const double dt = 0.5 * scene.output("joint", 8);
  double worst = 0.0, last = scene.kinetic_energy();
  for (int part = 0; part < 10; ++part) {
    scene.run(static_cast<int>(1e-2 / dt), dt);
    worst = std::max(worst, booked(scene, "ledger"));
  }
  std::printf("kinetic energy %.0f of %.0f J left, balance error %.1e\n", scene.kinetic_energy(),
              last, worst);
  EXPECT_LT(worst, 0.005);
  EXPECT_LT(scene.kinetic_energy(), last);
  constexpr int kContactDamping = 10;  // entry of the ledger
  EXPECT_GT(scene.output("ledger", kContactDamping), 0.0);
}

}  // namespace
}  // namespace muckpile::test
