// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/progress: a pile is still although blocks that left the scene fly on, and they are
// counted.
// Scope: eight blocks without gravity or joints, one of which flies away.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr int kFlyer = 1;
constexpr double kSpeed = 10.0, kStep = 1e-3;  // [m/s], [s]
constexpr int kStill = 0, kShare = 2, kGone = 3,
              kInSolid = 4;  // outputs of the fix; 0: its scalar

/// Cubes of 0.5 m in a box of 4 m; the flyer goes along x, away from all others.
void let_one_fly(RockScene& scene, const ScratchFolder& folder, const std::string& words) {
  scene.command("pair_style muckpile/block youngs_modulus 1e7");
  scene.command("pair_coeff * *");
  scene.cut("-0.5 0.5 -0.5 0.5 -0.5 0.5",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1 "
            "seed 4");
  scene.command("region scene block -1.2 1.2 -2 2 -2 2 units box");
  scene.command("fix energy all muckpile/ledger");
  scene.command("fix progress all muckpile/progress every 10 directory " + (folder / "").string() +
                " still_share 0.01 " + words);
  scene.set_motion([](int tag, const Vec3& centre) {
    return Motion{
        tag == kFlyer ? Vec3(centre.x() > 0.0 ? kSpeed : -kSpeed, 0, 0) : Vec3(Vec3::Zero()),
        Vec3::Zero()};
  });
}

TEST(FixMuckpileProgress, BlockThatLeftTheSceneIsCountedAndNoLongerMoves) {
  const ScratchFolder folder("progress_scene");
  RockScene scene(MPI_COMM_WORLD, "-4 4 -2 2 -2 2");
  let_one_fly(scene, folder, "scene scene");
  const double all = static_cast<double>(scene.blocks().size());
  ASSERT_GE(all, 6.0);
  scene.run(50, kStep);  // 0.5 m: still within 1.2 m
  EXPECT_EQ(scene.output("progress", kStill), 0.0);
  EXPECT_EQ(scene.output("progress", kGone), 0.0);
  EXPECT_NEAR(scene.output("progress", kShare), 1.0 / all, 0.3 / all);
  EXPECT_NE(content(folder / "run.json").find("\"blocks_left_scene\": 0"), std::string::npos);
  scene.run(100, kStep);  // 1.5 m
  EXPECT_EQ(scene.output("progress", kStill), 1.0);
  EXPECT_EQ(scene.output("progress", kGone), 1.0);
  EXPECT_EQ(scene.output("progress", kShare), 0.0);
  const std::string run = content(folder / "run.json");
  EXPECT_NE(run.find("\"blocks_left_scene\": 1,"), std::string::npos) << run;
  EXPECT_DOUBLE_EQ(nlohmann::json::parse(run).at("mass_left_scene_kg"),
                   scene.blocks().at(kFlyer).mass);
}

TEST(FixMuckpileProgress, WithoutASceneABlockMovesWhereverItIs) {
  const ScratchFolder folder("progress_all");
  RockScene scene(MPI_COMM_WORLD, "-4 4 -2 2 -2 2");
  let_one_fly(scene, folder, "");
  scene.run(150, kStep);
  EXPECT_EQ(scene.output("progress", kStill), 0.0);
  EXPECT_EQ(scene.output("progress", kGone), 0.0);
}

/// The region is all beyond 0.6 m, and a spot around the centre of a block that stays.
TEST(FixMuckpileProgress, BlockThatComesIntoTheSolidIsCountedAndOneThatBeganThereIsNot) {
  const ScratchFolder folder("progress_solid");
  RockScene scene(MPI_COMM_WORLD, "-4 4 -2 2 -2 2");
  let_one_fly(scene, folder, "solid solid");
  const Vec3 spot = scene.blocks().at(kFlyer + 1).centre;
  std::ostringstream sphere;
  sphere << "region spot sphere " << spot.x() << ' ' << spot.y() << ' ' << spot.z()
         << " 0.01 units box";
  scene.command(sphere.str());
  scene.command("region beyond block -0.6 0.6 INF INF INF INF side out units box");
  scene.command("region solid union 2 spot beyond");
  scene.run(10, kStep);  // 0.1 m
  EXPECT_EQ(scene.output("progress", kInSolid), 0.0);
  EXPECT_NE(content(folder / "run.json").find("\"blocks_in_solid\": 0,"), std::string::npos);
  scene.run(60, kStep);  // 0.7 m
  EXPECT_EQ(scene.output("progress", kInSolid), 1.0);
  EXPECT_NE(content(folder / "run.json").find("\"blocks_in_solid\": 1,"), std::string::npos);
}

/// The engine looks up how often a fix works only when it sets a run up. A run ends with a row.
TEST(FixMuckpileProgress, AnotherIntervalActsInARunThatIsNotSetUp) {
  const ScratchFolder folder("progress_every");
  RockScene scene(MPI_COMM_WORLD, "-4 4 -2 2 -2 2");
  let_one_fly(scene, folder, "");
  scene.command("fix snapshots all muckpile/dump every 1000000 directory " +
                (folder / "").string());
  scene.run(0, kStep);
  scene.command("fix_modify snapshots every 5");
  scene.command("fix_modify progress every 4");
  scene.command("run 9 pre no");
  for (const int step : {0, 5, 9}) {  // every run ends with one
    const std::string name = "blocks_00000000" + std::to_string(step) + ".csv";
    EXPECT_NE(content(folder / name).find("# step=" + std::to_string(step)), std::string::npos);
  }
  std::istringstream history(content(folder / "history.csv"));
  std::string line, steps;
  while (std::getline(history, line)) steps += line.substr(0, line.find(',')) + ' ';
  EXPECT_EQ(steps, "step 0 4 8 9 ");
}

}  // namespace
}  // namespace muckpile::test
