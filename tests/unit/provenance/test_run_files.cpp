// SPDX-License-Identifier: GPL-2.0-or-later
// Marks of a run in lines, and steps in names of snapshots, against texts written here.
#include <gtest/gtest.h>

#include "provenance/fingerprint.h"
#include "provenance/run_files.h"

namespace muckpile {
namespace {

TEST(RunFiles, AMarkIsFoundAmongTheWordsOfALine) {
  const std::string id = Fingerprint().text();
  EXPECT_EQ(run_mark("0123456789abcdef"), "run=0123456789abcdef");
  EXPECT_EQ(run_id_in("# step=7 time_s=1 " + run_mark(id)), id);
  EXPECT_EQ(run_id_in(run_mark(id) + "\r"), id);
  EXPECT_EQ(run_id_in("run=7 " + run_mark(id) + " more words"), id);
}

TEST(RunFiles, OtherWordsAreNoMark) {
  EXPECT_EQ(run_id_in(""), "");
  EXPECT_EQ(run_id_in("   "), "");
  EXPECT_EQ(run_id_in("rerun=0123456789abcdef"), "");
  EXPECT_EQ(run_id_in("run=0123456789abcde run=0123456789abcdef0 run=0123456789ABCDEF"), "");
}

TEST(RunFiles, TheStepInANameComesBack) {
  EXPECT_EQ(snapshot_name(1000), "blocks_000001000.csv");
  for (const long long step : {0LL, 7LL, 999999999LL, 12345678901LL}) {
    EXPECT_EQ(snapshot_step(snapshot_name(step)), step);
    const std::string packed = snapshot_name(step, SnapshotForm::packed);
    EXPECT_EQ(snapshot_step(packed), step);
    EXPECT_EQ(snapshot_form(packed), SnapshotForm::packed);
  }
  EXPECT_EQ(snapshot_step("blocks_5.csv"), 5);
}

TEST(RunFiles, OtherNamesHaveNoStep) {
  for (const char* name :
       {"blocks_.csv", "blocks_mine.csv", "blocks_-5.csv", "blocks_5.csv.part", "blocks_5x.csv",
        "blocks_5.5.csv", "my_blocks_5.csv", "blocks.vtk", "blocks_.bin"}) {
    EXPECT_EQ(snapshot_step(name), -1) << name;
  }
}

}  // namespace
}  // namespace muckpile
