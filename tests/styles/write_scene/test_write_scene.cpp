// SPDX-License-Identifier: GPL-2.0-or-later
// write_scene: numbers as numbers however they are spelt, words as words, knobs and program.
// Scope: eight blocks; nothing runs. What it refuses: tests/errors.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr const char* kCut =
    "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1 seed 4";

RockScene rock(const std::string& more = "") {
  RockScene scene(MPI_COMM_WORLD, "-4 4 -2 2 -2 2");
  if (!more.empty()) scene.command(more);
  scene.cut("-0.5 0.5 -0.5 0.5 -0.5 0.5", kCut);
  return scene;
}

nlohmann::json read(const std::filesystem::path& file) {
  return nlohmann::json::parse(content(file));
}

TEST(WriteScene, SpellsNumbersAsJsonDoes) {
  const ScratchFolder folder("scene_numbers");
  RockScene scene = rock();
  const std::string file = (folder / "deeper/scene.json").string();  // the folder is made
  scene.command("variable explosive index emulsion");
  scene.command("variable half equal 0.5*3");
  scene.command("write_scene " + file +
                " case bench height_m 4. holes 04 seed +1 rise_s 1e-3 explosive ${explosive} "
                "width_m ${half} odd nan quoted \"say 'hi'\"");
  const nlohmann::json found = read(file);
  EXPECT_EQ(found.at("case"), "bench");
  EXPECT_EQ(found.at("height_m"), 4.0);
  EXPECT_TRUE(found.at("holes").is_number_integer());
  EXPECT_EQ(found.at("holes"), 4);
  EXPECT_EQ(found.at("seed"), 1);
  EXPECT_EQ(found.at("rise_s"), 1e-3);
  EXPECT_EQ(found.at("explosive"), "emulsion");
  EXPECT_EQ(found.at("width_m"), 1.5);
  EXPECT_EQ(found.at("odd"), "nan");
  EXPECT_EQ(found.at("quoted"), "say 'hi'");
}

/// One variable of each style that the command must tell apart: LIGGGHTS numbers them.
TEST(WriteScene, TellsKnobsAndProgram) {
  const ScratchFolder folder("scene_knobs");
  RockScene scene = rock();
  scene.command("variable burden index +3.0");
  scene.command("variable pick index a b c");
  scene.command("next pick");
  scene.command("variable word string 7");
  scene.command("variable sum equal 1+1");
  scene.command("variable each atom x");
  scene.command("variable turn loop 3");
  const std::string file = (folder / "scene.json").string();
  scene.command("write_scene " + file + " case bench");
  const nlohmann::json found = read(file);
  EXPECT_EQ(found.at("knobs"), nlohmann::json({{"burden", 3.0}, {"pick", "b"}}));
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  EXPECT_EQ(found.at("ranks"), ranks);
  EXPECT_EQ(found.at("version"), MUCKPILE_VERSION);
  EXPECT_NE(found.at("command_line").get<std::string>().find("test_write_scene"),
            std::string::npos);
  const std::string commit = found.at("commit");
  EXPECT_TRUE(commit == "unknown" || commit.find_first_not_of("0123456789abcdef") >= 40u) << commit;
  EXPECT_FALSE(found.at("compiler").get<std::string>().empty());
  for (const char* library : {"LIGGGHTS", "MPI", "Eigen", "voro++"})
    EXPECT_FALSE(found.at("libraries").at(library).get<std::string>().empty()) << library;
  EXPECT_EQ(found.at("run_id").get<std::string>().size(), 16u);

  MPI_Barrier(MPI_COMM_WORLD);  // all have read
  // The first run adds what the script has defined behind the command.
  scene.command("variable late index 5");
  scene.command("run 0");
  EXPECT_EQ(read(file).at("knobs"), nlohmann::json({{"burden", 3.0}, {"pick", "b"}, {"late", 5}}));
  EXPECT_EQ(read(file).at("run_id"), found.at("run_id"));
}

}  // namespace
}  // namespace muckpile::test
