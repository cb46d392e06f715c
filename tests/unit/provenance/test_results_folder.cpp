// SPDX-License-Identifier: GPL-2.0-or-later
// Folders of results: which path lies in one, and numbers of a scene.
// Scope: a temporary folder.
#include <gtest/gtest.h>

#include <filesystem>

#include "provenance/results_folder.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

TEST(ResultsFolder, HoldsItselfAndWhatIsInIt) {
  const testing::TemporaryFolder folder;
  const std::string here = folder.path().string();
  std::filesystem::create_directories(folder.path() / "dump");
  std::filesystem::create_symlink(folder.path() / "dump", folder.path() / "link");
  for (const char* inside : {"", "/", "/dump", "/dump/..", "/none/at/all", "/link"})
    EXPECT_TRUE(lies_in(here + inside, here)) << inside;
  EXPECT_TRUE(lies_in(here + "/link", here + "/dump/"));
  EXPECT_FALSE(lies_in(here + "2", here));
  EXPECT_FALSE(lies_in(here, here + "/dump"));
  EXPECT_TRUE(lies_in("results/a", "./results"));
}

TEST(ResultsFolder, GivesNumbersOfItsScene) {
  const testing::TemporaryFolder folder;
  const std::string here = folder.path().string();
  EXPECT_FALSE(scene_number(here, "spacing_m"));
  testing::write_text(folder.path() / "dump" / "scene.json",
                      "{\n  \"case\": \"bench\",\n  \"half_spacing_m\": 1,\n  \"spacing_m\": "
                      "2.25,\n  \"depth_m\": -1e-1\n}\n");
  EXPECT_EQ(scene_number(here, "spacing_m"), 2.25);
  EXPECT_EQ(scene_number(here + "/dump", "depth_m"), -0.1);
  EXPECT_FALSE(scene_number(here, "case"));
  EXPECT_FALSE(scene_number(here, "holes"));
}

TEST(ResultsFolder, GivesTheRunOfItsScene) {
  const testing::TemporaryFolder folder;
  const std::string here = folder.path().string();
  EXPECT_FALSE(scene_run_id(here));
  const auto of = [&](const std::string& text) {
    testing::write_text(folder.path() / "dump" / "scene.json", text);
    return scene_run_id(here).value_or("no file");
  };
  EXPECT_EQ(of("{\n  \"case\": \"bench\",\n  \"run_id\": \"0123456789abcdef\"\n}\n"),
            "0123456789abcdef");
  EXPECT_EQ(of("{\n  \"run_id\": \"0123456789abcde\"\n}\n"), "");
  EXPECT_EQ(of("{\n  \"run_id\": 7\n}\n"), "");
  EXPECT_EQ(of("{\n  \"case\": \"bench\"\n}\n"), "");
}

TEST(ResultsFolder, FilesHoldBytesAcrossPieces) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder.path() / "a.restart").string(), id = "0123456789abcdef";
  const std::size_t piece = 1 << 20;  // that is read at once
  for (const std::size_t at :
       {std::size_t{0}, piece - id.size(), piece - 3, piece, 2 * piece - 1}) {
    testing::write_text(file, std::string(at, '7') + id + "end");
    EXPECT_TRUE(file_holds(file, id)) << at;
    EXPECT_FALSE(file_holds(file, id + 'x')) << at;
  }
  EXPECT_FALSE(file_holds(file + ".none", id));
}

}  // namespace
}  // namespace muckpile
