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

}  // namespace
}  // namespace muckpile
