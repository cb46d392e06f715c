// SPDX-License-Identifier: GPL-2.0-or-later
// Files of two runs in one folder are refused, with both files and both ids.
// Scope: io/run_id, and the summary of another run.
#include <gtest/gtest.h>

#include "input_error_of.h"
#include "io/result_folder.h"
#include "io/run_id.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr const char* kMine = "0123456789abcdef";
constexpr const char* kOther = "fedcba9876543210";

class RunId : public ::testing::Test {
 protected:
  void SetUp() override { write_bench(folder_.path()); }
  void mark_all() {
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "dump"))
      mark_with_run(entry.path(), kMine);
  }
  std::string file(const std::string& name) { return (folder_.path() / "dump" / name).string(); }
  void expect_refused(const std::string& first, const std::string& second) {
    const std::string text = input_error_of([&] { (void)ResultFolder(folder_.path()); });
    EXPECT_NE(text.find(first + ", but " + second + ": files of two runs lie in one folder; "),
              std::string::npos)
        << text;
  }
  TemporaryFolder folder_;
};

TEST_F(RunId, IsNeededByNoFileIfNoneHasOne) { EXPECT_EQ(run_id_of(folder_.path() / "dump"), ""); }

TEST_F(RunId, IsThatOfAllFiles) {
  mark_all();
  EXPECT_EQ(run_id_of(folder_.path() / "dump"), kMine);
  const ResultFolder folder(folder_.path());
  const auto blocks = folder.blocks();  // with the id in the title of the file
  EXPECT_EQ(blocks.size(), 1472U);
  const Snapshot last = read_snapshot(folder.snapshots().back(), blocks);
  EXPECT_EQ(last.step, 2000);
  EXPECT_DOUBLE_EQ(last.time, 4.5);
}

// What a second, shorter run in the same folder leaves of the first: its later snapshots.
TEST_F(RunId, OfAnOlderRunsSnapshotIsRefused) {
  mark_all();
  std::filesystem::copy_file(file("blocks_000002000.csv"), file("blocks_000009000.csv"));
  std::filesystem::remove(file("blocks_000002000.csv"));
  write_snapshot(file("blocks_000002000.csv"), bench_run().blocks, bench_run().last);
  mark_with_run(file("blocks_000002000.csv"), kOther);
  expect_refused(file("blocks_000002000.csv") + " is of run " + kOther,
                 file("blocks.vtk") + " is of run " + kMine);
}

TEST_F(RunId, MustBeInEveryFileIfItIsInOne) {
  for (const std::string name :
       {"run.json", "history.csv", "blocks_000000000.csv", "blocks_000002000.csv"}) {
    write_bench(folder_.path());
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "dump")) {
      if (entry.path().filename() != name) mark_with_run(entry.path(), kMine);
    }
    expect_refused(file(name) + " has no run id", file("blocks.vtk") + " is of run " + kMine);
  }
  write_bench(folder_.path());
  mark_with_run(file("run.json"), kMine);
  expect_refused(file("blocks.vtk") + " has no run id", file("run.json") + " is of run " + kMine);
}

TEST_F(RunId, OfASceneThatAScriptPrintedIsNotAskedFor) {
  write_bench(folder_.path());
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "dump")) {
    if (entry.path().filename() != "scene.json") mark_with_run(entry.path(), kMine);
  }
  EXPECT_EQ(run_id_of(folder_.path() / "dump"), kMine);
}

TEST_F(RunId, OfALaterRowOfTheHistoryCounts) {
  mark_all();
  std::string text = text_of(file("history.csv"));
  write_text(file("history.csv"), text.replace(text.rfind(kMine), 16, kOther));
  expect_refused(file("history.csv") + ":4 is of run " + kOther,
                 file("blocks.vtk") + " is of run " + kMine);
}

TEST_F(RunId, IsNoneIfTheTitleHasOtherWords) {
  std::string text = text_of(file("blocks.vtk"));
  write_text(file("blocks.vtk"), text.insert(text.find("start"), "run=7 "));
  EXPECT_EQ(run_id_of(folder_.path() / "dump"), "");
}

TEST_F(RunId, KeepsTheSummariesOfTwoRunsApart) {
  mark_all();
  write_text(folder_.path() / "summary.json",
             std::string("{\"run_id\": \"") + kOther + "\", \"throw_cg_m\": 4.0}\n");
  const ResultFolder folder(folder_.path());
  folder.merge_into_summary({{"a_m", 1.0}});
  folder.merge_into_summary({{"b_m", 2.0}}, {"c_m"});
  const auto summary = read_json_object(folder.file("summary.json"));
  EXPECT_FALSE(summary.contains("throw_cg_m"));
  EXPECT_EQ(summary["a_m"], 1.0);
  EXPECT_EQ(summary["run_id"], kMine);
}

}  // namespace
}  // namespace muckpile
