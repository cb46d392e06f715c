// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/timestep in the engine: the step it takes, the same on any number of ranks, changes
// within a run, contacts.
// Scope: up to some hundred blocks; run with mpirun -np 1, 2 and 4. The bound itself is tested in
// tests/unit/bond.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

enum Timestep {
  margin = 0,
  joint_step = 1,
  spring_step = 2,
  step = 3,
  changes = 4,
  products = 5,
  dashpot_step = 6,
  collision_step = 7,
  joined_spring_step = 8,
  pace = 9
};

const std::string kRock = " youngs_modulus 50e9 poisson_ratio 0.25 density 2600 friction_angle 45 ";
const std::string kUnbreakable = kRock + "cohesion 1e12 tension 1e12";

RockScene engine(MPI_Comm comm) {
  return RockScene(comm, "-6 6 -4 4 -4 4", "* * 1", "multisphere/muckpile");
}

/// Some hundred blocks, graded 3:1 around a short charge.
void graded(RockScene& scene, const std::string& joints) {
  scene.cut("-1 1 -1 1 -0.8 0.8",
            "density 2600 size power 0.5 1 block_min 0.15 block_max 0.5 hole 0 0 -0.3 0 0 0.3 0.1 "
            "spheres_per_block 2 seed 3 sweeps 5");
  scene.command("fix joint all muckpile/joint" + joints);
}

TEST(FixMuckpileTimestep, TakesItsShareOfTheBound) {
  RockScene scene = engine(MPI_COMM_WORLD);
  graded(scene, kUnbreakable);
  scene.command("fix dt all muckpile/timestep fraction 0.5");
  scene.run(0, 1e-9);
  const double bound = scene.output("dt", joint_step), taken = scene.output("dt", step);
  EXPECT_NEAR(bound / scene.output("joint", 8), 1.0, 0.02);  // worked out from another guess
  EXPECT_LE(taken, 0.5 * bound);
  EXPECT_GT(taken, 0.495 * bound);  // cut to three digits
  EXPECT_DOUBLE_EQ(scene.output("dt", margin), bound / taken);
  EXPECT_EQ(scene.output("dt", changes), 1.0);
  EXPECT_GT(scene.output("dt", products), 30.0);

  scene.command("fix_modify dt fraction 0.8 max 1e-7");
  scene.run(0, taken);
  EXPECT_DOUBLE_EQ(scene.output("dt", step), 1e-7);
  scene.command("fix_modify dt max 1");
  scene.command("fix_modify dt cap 1e-7");
  scene.run(0, taken);
  EXPECT_DOUBLE_EQ(scene.output("dt", step), 1e-7);
  scene.command("fix_modify dt cap 1e30");
  scene.run(0, taken);
  EXPECT_NEAR(scene.output("dt", step) / (1.6 * taken), 1.0, 0.03);
}

TEST(FixMuckpileTimestep, RanksTakeTheSameStep) {
  double taken[2] = {}, bound[2] = {};
  for (const bool shared : {false, true}) {
    RockScene scene = engine(shared ? MPI_COMM_WORLD : MPI_COMM_SELF);
    graded(scene, kUnbreakable);
    scene.command("fix dt all muckpile/timestep");
    scene.run(20, 1e-9);
    taken[shared ? 1 : 0] = scene.output("dt", step);
    bound[shared ? 1 : 0] = scene.output("dt", joint_step);
  }
  EXPECT_EQ(taken[0], taken[1]);
  EXPECT_NEAR(bound[1] / bound[0], 1.0, 1e-9);
}

TEST(FixMuckpileTimestep, BoundIsWhereVibrationsGrow) {
  for (const double share : {1.0, 1.04}) {
    RockScene scene = engine(MPI_COMM_WORLD);
    graded(scene, kUnbreakable + " step_check 0 contact_check no");  // unstable on purpose
    scene.command("fix dt all muckpile/timestep breaking none");
    scene.run(0, 1e-9);
    const double dt = share * scene.output("dt", joint_step);
    scene.command("unfix dt");
    scene.set_motion([](int tag, const Vec3&) {
      return Motion{0.01 * Vec3(tag % 3 - 1, tag % 5 - 2, tag % 7 - 3), Vec3(0, 0, tag % 2)};
    });
    const double start = scene.kinetic_energy();
    scene.run(1500, dt);
    const double now = scene.kinetic_energy() + scene.output("joint", 4);
    if (share == 1.0) {
      EXPECT_LT(now, 3.0 * start);
    } else {
      EXPECT_FALSE(now < 100.0 * start);
    }
  }
}

const std::string kLoose = kRock + "cohesion 0 tension 0 contact_check no";

/// Blocks that fly apart: their joints break in the first step and retire when they have opened.
void scatter(RockScene& scene) {
  graded(scene, kLoose);
  scene.set_motion([](int, const Vec3& at) { return Motion{2.0 * at, Vec3::Zero()}; });
}

TEST(FixMuckpileTimestep, StepGrowsWithinARunAsJointsRetire) {
  RockScene scene = engine(MPI_COMM_WORLD);
  scatter(scene);
  scene.command("fix dt all muckpile/timestep every 50 joints_every 2 max 1e-4");
  scene.command("variable now equal time");
  const auto start = scene.blocks();
  scene.run(0, 1e-9);
  const double small = scene.output("dt", step);
  scene.run(3000, small);
  EXPECT_LT(small, 5e-5);
  EXPECT_DOUBLE_EQ(scene.output("dt", step), 1e-4);
  EXPECT_GT(scene.output("dt", changes), 2.0);
  // Positions follow the engine's clock: the bodies and the clock know of every change.
  const double time = scene.variable("now");
  EXPECT_GT(time, 500 * 1e-4);
  for (const auto& [tag, block] : scene.blocks()) {
    const Vec3 home = start.at(tag).centre;
    EXPECT_LT((block.centre - home - time * 2.0 * home).norm(), 1e-6 * time) << tag;
  }
}

/// Blocks without joints that fly at each other and touch: springs, dashpots and what a collision
/// needs each hold the step where the others are left out.
TEST(FixMuckpileTimestep, CountsContacts) {
  for (const auto& [words, share, held_by] :
       {std::tuple("fraction 0.1 dashpot_fraction 4", 0.1, spring_step),
        std::tuple("fraction 1 dashpot_fraction 0.2", 0.2, dashpot_step),
        std::tuple("fraction 1 dashpot_fraction 4", 1.0, collision_step)}) {
    RockScene scene = engine(MPI_COMM_WORLD);
    scene.command("pair_style muckpile/block youngs_modulus 1e8 restitution 0.2");
    scene.command("pair_coeff * *");
    scene.cut("-1 1 -1 1 -0.8 0.8",
              "density 2600 size power 0.5 1 block_min 0.15 block_max 0.5 hole 0 0 -0.3 0 0 0.3 "
              "0.1 spheres_per_block 2 seed 3 sweeps 5");
    scene.set_motion([](int, const Vec3& at) { return Motion{-1.0 * at, Vec3::Zero()}; });
    scene.command(std::string("fix dt all muckpile/timestep every 1 ") + words);
    scene.run(200, 1e-9);
    EXPECT_TRUE(std::isinf(scene.output("dt", joint_step)));
    EXPECT_LT(scene.output("dt", dashpot_step), 0.9 * scene.output("dt", spring_step));
    EXPECT_NEAR(scene.output("dt", step) / (share * scene.output("dt", held_by)), 1.0, 0.02)
        << words;
    EXPECT_DOUBLE_EQ(scene.output("dt", margin),
                     scene.output("dt", spring_step) / scene.output("dt", step));
  }
}

/// Contacts act at every second, fourth, ... step as far as they bear it and resolve collisions.
TEST(FixMuckpileTimestep, SetsThePaceOfTheContacts) {
  for (const auto& [most, collision] :
       {std::pair(64, 1e-3), std::pair(8, 1e-3), std::pair(64, 4.1e-5)}) {
    RockScene scene = engine(MPI_COMM_WORLD);
    scene.command("pair_style muckpile/block youngs_modulus 1e6 restitution 0.9");
    scene.command("pair_coeff * *");
    graded(scene, kUnbreakable);
    scene.command("fix dt all muckpile/timestep every 1 max 1e-5 collision " +
                  std::to_string(collision) + " contact_every " + std::to_string(most));
    scene.run(3, 1e-9);
    EXPECT_DOUBLE_EQ(scene.output("dt", step), 1e-5);
    const double longest = std::min(
        {collision, 0.25 * scene.output("dt", spring_step), scene.output("dt", dashpot_step)});
    const double found = scene.output("dt", pace);
    EXPECT_LE(found * 1e-5, longest);
    EXPECT_TRUE(2.0 * found > most || 2.0 * found * 1e-5 > longest) << found;
    EXPECT_EQ(found, most == 8 ? 8.0 : collision < 1e-4 ? 4.0 : 64.0);
  }
}

/// The second half of a kick that stands for many steps would come with the longer step: it waits.
TEST(FixMuckpileTimestep, StepDoesNotGrowWhereContactsHaveJustActedForSeveral) {
  RockScene scene = engine(MPI_COMM_WORLD);
  scene.command("pair_style muckpile/block youngs_modulus 1e6 restitution 0.9");
  scene.command("pair_coeff * *");
  graded(scene, kUnbreakable);
  scene.command("fix dt all muckpile/timestep every 1 collision 1e-3 contact_every 8");
  scene.command("fix_modify dt cap 1e-6");
  scene.run(17, 1e-9);  // acts at steps 9 and 17
  ASSERT_EQ(scene.output("dt", pace), 8.0);
  scene.command("fix_modify dt cap 1e-5");
  scene.command("run 0");
  EXPECT_DOUBLE_EQ(scene.output("dt", step), 1e-6);
  scene.command("run 1");
  EXPECT_DOUBLE_EQ(scene.output("dt", step), 1e-5);
}

/// Blocks that fly at each other and touch, with contacts that act at every eighth step.
RockScene paced_crowd(MPI_Comm comm) {
  RockScene scene = engine(comm);
  scene.command("pair_style muckpile/block youngs_modulus 1e7 restitution 0.2");
  scene.command("pair_coeff * *");
  scene.cut("-1 1 -1 1 -0.8 0.8",
            "density 2600 size power 0.5 1 block_min 0.15 block_max 0.5 hole 0 0 -0.3 0 0 0.3 "
            "0.1 spheres_per_block 2 seed 3 sweeps 5");
  scene.set_motion([](int, const Vec3& at) { return Motion{-2.0 * at, Vec3::Zero()}; });
  return scene;
}

const std::string kPaced = "fix dt all muckpile/timestep every 10 max 2e-5 contact_every 8";

double largest_difference(const RockScene& one, const RockScene& other) {
  const auto expected = one.blocks();
  double worst = 0.0;
  for (const auto& [tag, block] : other.blocks())
    worst = std::max(worst, (block.velocity - expected.at(tag).velocity).norm());
  return worst;
}

/// Contacts act at steps 1, 9, 17, ...: one file is of such a step, the other of one between.
TEST(FixMuckpileTimestep, PaceGoesOnFromARestartFile) {
  for (const int at : {401, 404}) {
    const ScratchFolder folder("timestep_pace_" + std::to_string(at));
    const std::string file = (folder / "file.restart").string();
    RockScene whole = paced_crowd(MPI_COMM_WORLD);
    whole.command(kPaced);
    whole.run(at, 1e-9);
    ASSERT_EQ(whole.output("dt", pace), 8.0);
    whole.command("write_restart " + file);
    RockScene again = RockScene::restarted(MPI_COMM_WORLD, file);
    again.command("pair_style muckpile/block youngs_modulus 1e7 restitution 0.2");
    again.command("pair_coeff * *");
    again.command(kPaced);
    whole.command("run 150");
    again.command("run 150");
    EXPECT_EQ(again.output("dt", pace), 8.0);
    EXPECT_LT(largest_difference(whole, again), 1e-9) << at;  // rounding, of some 2 m/s
  }
}

TEST(FixMuckpileTimestep, RanksKeepOnePace) {
  RockScene alone = paced_crowd(MPI_COMM_SELF), shared = paced_crowd(MPI_COMM_WORLD);
  for (RockScene* scene : {&alone, &shared}) {
    scene->command(kPaced);
    scene->run(300, 1e-9);
    EXPECT_EQ(scene->output("dt", pace), 8.0);
  }
  EXPECT_LT(largest_difference(alone, shared), 1e-8);
  EXPECT_EQ(alone.blocks().size(), shared.blocks().size());
}

/// To resolve a collision is a matter of accuracy, not of stability: neither the joints nor a share
/// come on top.
TEST(FixMuckpileTimestep, CollisionsAreResolvedBesideTheJoints) {
  RockScene scene = engine(MPI_COMM_WORLD);
  graded(scene, kUnbreakable);
  scene.command("fix dt all muckpile/timestep fraction 0.5");
  scene.run(0, 1e-9);
  const double taken = scene.output("dt", step);
  for (const double share : {0.97, 1.1}) {
    scene.command("fix_modify dt collision " + std::to_string(1e9 * share * taken) + "e-9");
    scene.run(0, taken);
    EXPECT_NEAR(scene.output("dt", step) / (std::min(share, 1.0) * taken), 1.0, 0.011) << share;
  }
}

/// By Hertz a collision lasts the longer the slower it is, with speed^(-1/5).
TEST(FixMuckpileTimestep, CollisionsFollowTheFastestBlockOnAnyRanks) {
  for (const double speed : {40.0, 20.0, 0.625}) {
    RockScene scene = engine(MPI_COMM_WORLD);
    scene.cut("-1 1 -1 1 -0.8 0.8", "density 2600 size power 0.5 1 block_min 0.3 block_max 0.5");
    scene.set_motion([&](int tag, const Vec3&) {
      return Motion{Vec3(0, tag == 3 ? -speed : 0.5 * speed, 0), Vec3::Zero()};
    });
    scene.command("fix dt all muckpile/timestep collision 1e-5 collision_speed 20");
    scene.run(1, 1e-9);
    EXPECT_NEAR(scene.output("dt", step), 1e-5 * std::pow(20.0 / speed, 0.2), 1.1e-8 * 2) << speed;
    scene.command("fix_modify dt collision_speed 0");
    scene.run(0, 1e-9);
    EXPECT_NEAR(scene.output("dt", step), 1e-5, 1e-12);
  }
}

/// Rubble beside rock: the joints of the rock do not make the contacts of the rubble any stiffer.
TEST(FixMuckpileTimestep, ContactsAddToTheJointsOfTheirOwnBlocksOnly) {
  RockScene scene = engine(MPI_COMM_WORLD);
  scene.command("pair_style muckpile/block youngs_modulus 2e9 restitution 0.9");
  scene.command("pair_coeff * *");
  graded(scene, kRock + "cohesion 0 tension 0");
  scene.command(
      "fix dt all muckpile/timestep fraction 0.5 dashpot_fraction 4 every 5 joints_every 0 max "
      "2e-5");
  const auto lump = [](const Vec3& at) { return at.x() < 0.0; };
  scene.set_motion([&](int, const Vec3& at) {
    return Motion{lump(at) ? Vec3::Zero() : Vec3(2.0 * at), Vec3::Zero()};
  });
  scene.run(4000, 1e-5);
  // What has come loose flies back; the nearest of it meets before it meets the rock.
  scene.set_motion([&](int, const Vec3& at) {
    return Motion{lump(at) ? Vec3::Zero() : Vec3(1.0, -4.0 * at.y(), -4.0 * at.z()), Vec3::Zero()};
  });
  int alone = 0, together = 0;
  for (int round = 0; round < 60; ++round) {
    scene.run(50, scene.output("dt", step));
    const double joints = scene.output("dt", joint_step), all = scene.output("dt", spring_step),
                 joined = scene.output("dt", joined_spring_step);
    ASSERT_TRUE(std::isfinite(joints));
    const double bound =
        std::min(all, 1.0 / std::sqrt(1.0 / (joints * joints) + 1.0 / (joined * joined)));
    EXPECT_NEAR(scene.output("dt", margin) * scene.output("dt", step) / bound, 1.0, 1e-12);
    EXPECT_LE(scene.output("dt", step), 0.5 * bound);
    if (all < joined && std::isfinite(joined)) ++together;
    if (std::isfinite(all) && std::isinf(joined)) ++alone;
  }
  std::printf("%d of 60 looks saw rubble alone in contact, %d rock too\n", alone, together);
  EXPECT_GT(alone + together, 5);
  EXPECT_GT(together, 0);
}

/// A look at the joints is dear: a run that goes on where the last one ended needs none, one after
/// softening does.
TEST(FixMuckpileTimestep, LooksAtJointsAgainWhenTheyHaveChanged) {
  RockScene scene = engine(MPI_COMM_WORLD);
  graded(scene, kUnbreakable);
  scene.command("fix dt all muckpile/timestep");
  scene.run(0, 1e-9);
  const double looked = scene.output("dt", products), before = scene.output("dt", step);
  scene.run(0, before);
  EXPECT_EQ(scene.output("dt", products), looked);
  scene.command("fix_modify joint soften 0.01");
  scene.run(0, before);
  EXPECT_GT(scene.output("dt", products), looked);
  EXPECT_NEAR(scene.output("dt", step) / (10.0 * before), 1.0, 0.02);
}

const std::string kLooks =
    "fix dt all muckpile/timestep every 20 joints_every 4 collision 4e-5 "
    "collision_speed 1 max 1e-4";

/// So fast that the step which resolves a collision shrinks from look to look.
void fall(RockScene& scene) { scene.command("fix pull all gravity 3e4 vector 0 0 -1"); }

/// Every step of the run, "step length" in a line each, to a file.
void tell_steps(RockScene& scene, const std::string& file) {
  scene.command("variable number equal step");
  scene.command("variable length equal dt");
  scene.command("fix told all print 1 \"${number} ${length}\" file " + file + " screen no");
}

/// Lines of the steps between `first` and `last`.
std::string steps(const std::string& file, int first, int last) {
  const std::string all = content(file);
  const auto line = [&](int step) { return all.find('\n' + std::to_string(step) + ' '); };
  return all.substr(line(first + 1), line(last) - line(first + 1));
}

/// Lengths of those steps.
std::vector<double> lengths(const std::string& lines) {
  std::istringstream in(lines);
  std::vector<double> found;
  for (double step = 0.0, length = 0.0; in >> step >> length;) found.push_back(length);
  return found;
}

/// Rock that comes apart and falls ever faster, without contacts. One restart file is written
/// within a run, between two looks, and one between two runs. From the latter it goes on to the
/// last bit. From the other one it goes on with the same step until the next look. Velocities have
/// been half a step apart at its start, which may then show in the last digit of the bound, and how
/// that is rounded is the processor's own.
TEST(FixMuckpileTimestep, RunThatGoesOnTakesTheSameStepsOnItsRanks) {
  const ScratchFolder folder("timestep_restart");
  const std::string whole = (folder / "whole").string();
  {
    RockScene scene = engine(MPI_COMM_WORLD);
    scatter(scene);
    fall(scene);
    scene.command(kLooks);
    scene.command("fix_modify dt cap 1");  // no setting: the file does not know it
    tell_steps(scene, whole);
    scene.command("restart 310 " + (folder / "at.*").string());
    scene.run(410, 1e-9);
    scene.command("restart 0");
    scene.command("write_restart " + (folder / "at.410").string());
    scene.command("run 390");
  }
  for (const auto& [from, to] : {std::pair(310, 410), std::pair(410, 800)}) {
    const std::string part = (folder / ("part" + std::to_string(from))).string();
    const std::string file = (folder / ("at." + std::to_string(from))).string();
    RockScene scene = RockScene::restarted(MPI_COMM_WORLD, file);
    scene.command("fix joint all muckpile/joint" + kLoose);
    fall(scene);
    scene.command(kLooks);
    tell_steps(scene, part);
    scene.command("run " + std::to_string(to - from));
    const std::string taken = steps(part, from, to);
    const std::string expected = steps(whole, from, to);
    if (from == 410) {
      EXPECT_EQ(taken, expected);
    }
    const std::vector<double> its = lengths(taken), whole_its = lengths(expected);
    ASSERT_EQ(whole_its.size(), static_cast<size_t>(to - from - 1));
    ASSERT_EQ(its.size(), whole_its.size());
    constexpr size_t kToNextLook = 9;  // from step 310 to the look at 320
    for (size_t k = 0; k < kToNextLook; ++k) ASSERT_EQ(its[k], whole_its[k]) << "step " << k;
    for (size_t k = 0; k < its.size(); ++k)
      ASSERT_NEAR(its[k] / whole_its[k], 1.0, 0.01) << "step " << k << " behind " << from;
  }
}

}  // namespace
}  // namespace muckpile::test
