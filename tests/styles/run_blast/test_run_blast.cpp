// SPDX-License-Identifier: GPL-2.0-or-later
// run_blast on LIGGGHTS: the fixes that it makes, those of the script that it uses, and going on
// from a restart file.
// Scope: a cube of rock with one charge, for 40 ms; each change of phase is in test_blast_run.cpp.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

// Outputs of fix muckpile/blast and fix muckpile/joint.
constexpr int kWork = 4, kWaveWork = 7, kSoftened = 10;
constexpr const char* kBox = "-10 10 -10 10 -10 10";

/// All but the blocks.
void define_blast(RockScene& scene, const std::string& more = "") {
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 55e9 poisson_ratio 0.25 density 2700 cohesion "
      "4e6 friction_angle 50 tension 2e6");
  scene.command(
      "fix load all muckpile/blast explosive emulsion hole_diameter 0.05 poisson_ratio 0.25 "
      "vent_time 3e-3 vent_decay 1e-3" +
      more);
}

RockScene rock(MPI_Comm comm = MPI_COMM_WORLD, const std::string& more = "") {
  RockScene scene(comm, kBox, "* 1 1", "multisphere/muckpile");
  scene.command("pair_style muckpile/block youngs_modulus 2.5e7 restitution 0.5 friction 0.7");
  scene.command("pair_coeff * *");
  scene.command("region held block -2 2 -2 2 -2 -0.749 units box");
  scene.cut("-0.75 0.75 -0.75 0.75 -0.75 0.75",
            "density 2700 size uniform 0.4 block_min 0.4 block_max 0.4 hole 0 0 -0.3 0 0 0.3 0.2 "
            "support fixed held spheres_per_block 2 seed 1");
  define_blast(scene, more);
  return scene;
}

std::string words(const ScratchFolder& folder, const std::string& time_end = "0.04") {
  return "run_blast directory " + (folder / "").string() +
         " block_min 0.4 spheres_per_block 2 time_end " + time_end;
}

TEST(RunBlast, MakesTheFixesThatTheScriptLacks) {
  const ScratchFolder folder("run_blast_makes");
  RockScene scene = rock();
  scene.command(words(folder));
  EXPECT_GT(scene.output("load", kWork), 1e4);
  EXPECT_NEAR(scene.output("joint", kSoftened), 2e-4, 1e-9);
  const double balance_error = scene.output("energy", 0);
  EXPECT_LT(balance_error, 0.02);
  EXPECT_GT(scene.output("dt", 3), 0.0);        // the present step
  EXPECT_GE(scene.output("sleep", 1), 0.0);     // blocks at rest
  EXPECT_EQ(scene.output("progress", 0), 0.0);  // blocks fly
  const std::string history = content(folder / "history.csv");
  EXPECT_NE(history.find(",wave_and_gas,"), std::string::npos);
  EXPECT_NE(history.find(",throw,"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "blocks_000000000.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "run.json"));
}

TEST(RunBlast, LeavesToTheScriptWhatIsItsOwn) {
  const ScratchFolder folder("run_blast_leaves"), own("run_blast_own");
  RockScene scene = rock();
  scene.command("fix energies all muckpile/ledger");
  scene.command("fix looks all muckpile/progress every 50 directory " + (own / "").string());
  scene.command(words(folder) + " sleep 0 throw_name flight");
  const std::string history = content(own / "history.csv");
  EXPECT_NE(history.find(",flight,"), std::string::npos);
  EXPECT_NE(history.find("\n50,"), std::string::npos);  // still a row at every fiftieth step
  EXPECT_FALSE(std::filesystem::exists(folder / "history.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "blocks_000000000.csv"));
}

/// Ranks add up in another order; what breaks late may differ.
TEST(RunBlast, DoesTheSameOnAnyNumberOfRanks) {
  const ScratchFolder folder("run_blast_ranks");
  RockScene all = rock();
  all.command(words(folder, "0.01"));
  RockScene one = rock(MPI_COMM_SELF);
  one.command("run_blast directory " + folder.own("alone").string() +
              " block_min 0.4 spheres_per_block 2 time_end 0.01");
  EXPECT_NEAR(all.output("load", kWork) / one.output("load", kWork), 1.0, 1e-3);
}

/// A wave takes 81 us across a block, twice the rise: the pulse of 0.4 ms takes steps of 16 us in
/// place of 8. With that many in the rise the work of the wave depends on when it begins in a step,
/// by -7.0 to +1.4 %; the mean of four such times, a quarter of a step apart, is 2.5 % less.
TEST(RunBlast, StepsThePulseByTheTimeOfAWaveAcrossItsBlocks) {
  const ScratchFolder folder("run_blast_crossing");
  double steps = 0.0, work = 0.0, steps_of_rise = 0.0, work_of_rise = 0.0;
  const auto blast = [&](const std::string& delay, const std::string& share, double& of_steps,
                         double& of_work) {
    RockScene scene = rock(MPI_COMM_WORLD, " rise_time 4e-5 hole 1 delay " + delay);
    scene.command(words(folder) + " end wave wave_end 1e-3 crossing_share " + share);
    scene.command("variable steps equal step");
    of_steps += scene.variable("steps");
    of_work += scene.output("load", kWaveWork);
  };
  for (const char* delay : {"0", "4e-6", "8e-6", "12e-6"}) {
    blast(delay, "0.2", steps, work);
    blast(delay, "0", steps_of_rise, work_of_rise);
  }
  EXPECT_LT(steps, 0.75 * steps_of_rise);
  EXPECT_NEAR(work / work_of_rise, 1.0, 0.04);
}

TEST(RunBlast, GoesOnFromARestartFileOfTheThrow) {
  const ScratchFolder folder("run_blast_goes_on");
  const std::string file = (folder / "file.restart").string();
  double work = 0.0;
  {
    RockScene first = rock();
    first.command(words(folder, "0.02"));
    work = first.output("load", kWork);
    first.command("write_restart " + file);
  }
  RockScene second = RockScene::restarted(MPI_COMM_WORLD, file);
  second.command("pair_style muckpile/block youngs_modulus 2.5e7 restitution 0.5 friction 0.7");
  second.command("pair_coeff * *");
  define_blast(second);
  second.command(words(folder));
  EXPECT_EQ(second.output("load", kWork), work);  // the charge is over
  EXPECT_NEAR(second.output("joint", kSoftened), 2e-4, 1e-9);
  const std::string history = content(folder / "history.csv");
  EXPECT_NE(history.find(",wave_and_gas,"), std::string::npos);  // of the first run
  second.command("variable now equal time");
  EXPECT_GT(second.variable("now"), 0.039);
}

}  // namespace
}  // namespace muckpile::test
