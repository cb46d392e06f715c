// SPDX-License-Identifier: GPL-2.0-or-later
// The id of a run: the same for the same run, another for another, in every file, and kept by a run
// that goes on. A run takes its own files away as it starts, and leaves those of others.
// Scope: eight blocks without joints.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr double kStep = 1e-4;  // [s]

struct Settings {
  std::string burden = "3", seed = "4", out = "";
};

void contacts(RockScene& scene) {
  scene.command("pair_style muckpile/block youngs_modulus 1e7");
  scene.command("pair_coeff * *");
}

void outputs(RockScene& scene, const std::string& out) {
  scene.command("fix energy all muckpile/ledger");
  scene.command("fix snapshots all muckpile/dump every 5 directory " + out);
  scene.command("fix progress all muckpile/progress every 4 directory " + out);
}

RockScene fresh(const Settings& is) {
  RockScene scene(MPI_COMM_WORLD, "-4 4 -2 2 -2 2");
  contacts(scene);
  scene.command("variable out index " + is.out);
  scene.command("variable burden index " + is.burden);
  scene.command("variable floor string ${out}/floor.stl");
  scene.cut("-0.5 0.5 -0.5 0.5 -0.5 0.5",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1 seed " +
                is.seed + " hole 0.1 0 -0.3 0.1 0 0.3 0.26 file ${out}/blocks.vtk");
  scene.command("write_scene ${out}/scene.json case bench");
  outputs(scene, is.out);
  return scene;
}

std::string line(const std::filesystem::path& file, int number) {
  std::istringstream in(content(file));
  std::string text;
  for (int k = 0; k < number; ++k) std::getline(in, text);
  return text;
}

std::string after(const std::string& text, const std::string& mark) {
  const std::size_t at = text.find(mark);
  return at == std::string::npos ? "none" : text.substr(at + mark.size());
}

std::string id_in_rock(const ScratchFolder& folder) {
  return after(line(folder / "blocks.vtk", 2), " run=");
}

std::vector<std::string> last_columns(const std::filesystem::path& history) {
  std::istringstream in(content(history));
  std::vector<std::string> words;
  for (std::string text; std::getline(in, text);) words.push_back(text.substr(text.rfind(',') + 1));
  return words;
}

TEST(RunId, StandsInEveryFile) {
  const ScratchFolder folder("run_id_files");
  RockScene scene = fresh({.out = (folder / "").string()});
  scene.run(6, kStep);
  const std::string id = id_in_rock(folder);
  ASSERT_EQ(id.size(), 16u);
  EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(content(folder / "scene.json")).at("run_id"), id);
  for (const char* name : {"blocks_000000000.csv", "blocks_000000005.csv", "blocks_000000006.csv"})
    EXPECT_EQ(after(line(folder / name, 1), " run="), id) << name;
  // Looks at steps 0 and 4, and the end of the run.
  EXPECT_EQ(last_columns(folder / "history.csv"), (std::vector<std::string>{"run_id", id, id, id}));
  const nlohmann::json run = nlohmann::json::parse(content(folder / "run.json"));
  EXPECT_EQ(run.at("run_id"), id);
  EXPECT_EQ(run.at("holes"),
            nlohmann::json::array(
                {{{"toe_m", {0.1, 0, -0.3}}, {"collar_m", {0.1, 0, 0.3}}, {"radius_m", 0.26}}}));
}

TEST(RunId, IsThatOfTheRunAndNotOfItsFolder) {
  const ScratchFolder first("run_id_1"), second("run_id_2"), third("run_id_3"), fourth("run_id_4");
  const auto id_of = [](const ScratchFolder& folder, Settings is) {
    is.out = (folder / "").string();
    (void)fresh(is);
    return id_in_rock(folder);
  };
  const std::string id = id_of(first, {});
  EXPECT_EQ(id_of(second, {}), id);
  EXPECT_NE(id_of(third, {.burden = "3.1"}), id);
  EXPECT_NE(id_of(fourth, {.seed = "5"}), id);
}

TEST(RunId, OwnSnapshotsGoAndStrangersStay) {
  const ScratchFolder folder("run_id_strangers");
  const Settings is{.out = (folder / "").string()};
  {
    RockScene scene = fresh(is);
    scene.run(10, kStep);
  }
  std::ofstream(folder / "blocks_000000777.csv") << "# step=777 time_s=1 run=0123456789abcdef\n";
  std::ofstream(folder / "blocks_000000778.csv") << "# step=778 time_s=1\n";
  MPI_Barrier(MPI_COMM_WORLD);
  RockScene scene = fresh(is);
  EXPECT_TRUE(std::filesystem::exists(folder / "blocks_000000010.csv"));  // until the run starts
  EXPECT_TRUE(std::filesystem::exists(folder / "run.json"));
  MPI_Barrier(MPI_COMM_WORLD);
  scene.command("timestep " + std::to_string(kStep));
  scene.command("run 3");
  EXPECT_FALSE(std::filesystem::exists(folder / "blocks_000000010.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "blocks_000000777.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "blocks_000000778.csv"));
  EXPECT_EQ(last_columns(folder / "history.csv").size(), 3u);  // header, steps 0 and 3
}

bool on_first_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank == 0;
}

std::string steps_of(const std::filesystem::path& history) {
  std::istringstream in(content(history));
  std::string steps, row;
  while (std::getline(in, row)) steps += row.substr(0, row.find(',')) + ' ';
  return steps;
}

TEST(RunId, FixesDefinedAnewGoOnWithTheirFiles) {
  const ScratchFolder folder("run_id_anew");
  const Settings is{.out = (folder / "").string()};
  RockScene scene = fresh(is);
  scene.run(6, kStep);
  for (const char* name : {"energy", "snapshots", "progress"})
    scene.command(std::string("unfix ") + name);
  outputs(scene, is.out);
  scene.run(3, kStep);
  for (const char* name : {"blocks_000000000.csv", "blocks_000000005.csv", "blocks_000000006.csv",
                           "blocks_000000009.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(steps_of(folder / "history.csv"), "step 0 4 6 8 9 ");
}

/// A cut row, or one of another run, ends what is known of the run, and no more.
TEST(RunId, RowsAheadOfADamagedOneStay) {
  for (const char* damaged :
       {"5,0.0005,1e-", "5,1,1,run,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,feed"}) {
    const ScratchFolder folder("run_id_torn");
    const Settings is{.out = (folder / "").string()};
    RockScene scene = fresh(is);
    scene.run(6, kStep);
    const std::string whole = content(folder / "history.csv");
    MPI_Barrier(MPI_COMM_WORLD);
    if (on_first_rank()) {
      const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
      std::ofstream(folder / "history.csv") << whole.substr(0, last) << damaged << '\n'
                                            << whole.substr(last);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    scene.command("unfix progress");
    scene.command("fix progress all muckpile/progress every 4 directory " + is.out);
    scene.run(1, kStep);
    EXPECT_EQ(steps_of(folder / "history.csv"), "step 0 4 7 ") << damaged;
  }
}

/// What a reader has opened stays whole.
TEST(RunId, FilesAreReplacedInOnePiece) {
  const ScratchFolder folder("run_id_replaced");
  RockScene scene = fresh({.out = (folder / "").string()});
  scene.run(1, kStep);
  const std::string old = content(folder / "run.json");
  MPI_Barrier(MPI_COMM_WORLD);
  if (on_first_rank()) std::filesystem::create_hard_link(folder / "run.json", folder / "held.json");
  scene.run(1, kStep);
  EXPECT_EQ(content(folder / "held.json"), old);
  EXPECT_NE(content(folder / "run.json"), old);
  for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

TEST(RunId, RunThatGoesOnKeepsIt) {
  const ScratchFolder folder("run_id_restart");
  const Settings is{.out = (folder / "").string()};
  const std::string file = (folder / "step.restart").string();
  {
    RockScene scene(MPI_COMM_WORLD, "-4 4 -2 2 -2 2", "* 1 1", "multisphere/muckpile");
    contacts(scene);
    scene.cut("-0.5 0.5 -0.5 0.5 -0.5 0.5",
              "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1 "
              "file " +
                  is.out + "/blocks.vtk");
    outputs(scene, is.out);
    scene.run(6, kStep);
    scene.command("write_restart " + file);
    scene.run(6, kStep);
  }
  const std::string id = id_in_rock(folder);
  std::ofstream(folder / "blocks_000000003.csv") << "# step=3 time_s=1 run=0123456789abcdef\n";
  MPI_Barrier(MPI_COMM_WORLD);
  RockScene scene = RockScene::restarted(MPI_COMM_WORLD, file);
  contacts(scene);
  outputs(scene, is.out);
  scene.run(1, kStep);
  EXPECT_FALSE(std::filesystem::exists(folder / "blocks_000000012.csv"));  // taken anew
  EXPECT_TRUE(std::filesystem::exists(folder / "blocks_000000003.csv"));   // of another run
  EXPECT_EQ(after(line(folder / "blocks_000000007.csv", 1), " run="), id);
  // Of the first run up to the file, and the end of this one.
  EXPECT_EQ(steps_of(folder / "history.csv"), "step 0 4 6 7 ");
  EXPECT_EQ(nlohmann::json::parse(content(folder / "run.json")).at("run_id"), id);
}

}  // namespace
}  // namespace muckpile::test
