// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command compare: what counts as the same, and what is refused.
// Scope: compare/ on summaries and tables written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "args/input_error.h"
#include "compare/comparison.h"
#include "compare/inputs_apart.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

using namespace testing;

class Compare : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* run : {"a", "b"}) {
      std::filesystem::create_directory(path(run));
      write_text(path(run) / "summary.json",
                 R"({"run_id": "812b0b01e8ba37ac", "case": "bench", "throw_cg_m": 8.0,)"
                 R"( "swell_factor": null, "still": true, "energy_audit_J": {"vented": 100}})");
      write_text(path(run) / "profile.csv", "x_m,pile_mean_m\n0,4\n2,0\n");
    }
  }
  [[nodiscard]] std::filesystem::path path(const std::string& run) const {
    return temporary_.path() / run;
  }
  void change(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = text_of(path("b") / file);
    write_text(path("b") / file, text.replace(text.find(from), from.size(), to));
  }
  [[nodiscard]] std::vector<std::string> differing(const CompareOptions& options = {}) const {
    std::vector<std::string> names;
    for (const auto& row :
         compare_runs(read_run_figures(path("a")), read_run_figures(path("b")), options)) {
      if (!row.same) names.push_back(row.name);
    }
    return names;
  }
  void expect_refused(const std::string& part, const CompareOptions& options = {}) const {
    try {
      (void)differing(options);
      FAIL() << "compared";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  TemporaryFolder temporary_;
};

using Names = std::vector<std::string>;

TEST_F(Compare, TellsInWhichKnobsTheInputsDiffer) {
  EXPECT_EQ(inputs_apart(path("a"), path("b")), Names{});  // no scene
  const auto scene = [&](const char* run, const std::string& knobs) {
    std::filesystem::create_directory(path(run) / "dump");
    write_text(path(run) / "dump" / "scene.json", R"({"case": "bench", "knobs": {)" + knobs + "}}");
  };
  scene("a", R"("out": "a", "bench_height": 10.0, "seed": 1, "rock": "granite", "burden": 2.5)");
  scene("b", R"("out": "b", "bench_height": 8, "seed": "1.0", "rock": "basalt", "sleep": 0)");
  EXPECT_EQ(inputs_apart(path("a"), path("b")), (Names{"bench_height 10, 8", "burden 2.5, none",
                                                       "rock granite, basalt", "sleep none, 0"}));
  EXPECT_EQ(inputs_apart(path("a") / "summary.json", path("b")), Names{});
}

TEST_F(Compare, ARunIsAsItself) { EXPECT_EQ(differing(), Names{}); }

TEST_F(Compare, ANumberMayDifferByTheLargerOfBothTolerances) {
  change("summary.json", "8.0", "8.4");  // by 0.4, a twentieth of 8
  EXPECT_EQ(differing(), Names{"throw_cg_m"});
  EXPECT_EQ(differing({{0.051, 0.0}, {}, {}, {}}), Names{});
  EXPECT_EQ(differing({{0.049, 0.39}, {}, {}, {}}), Names{"throw_cg_m"});
  EXPECT_EQ(differing({{0.0, 0.41}, {}, {}, {}}), Names{});
  EXPECT_EQ(differing({{0.0, 0.0}, {{"throw_cg_m", {0.0, 0.41}}}, {}, {}}), Names{});
  EXPECT_EQ(differing({{0.1, 0.0}, {{"throw_cg_m", {0.01, 0.0}}}, {}, {}}), Names{"throw_cg_m"});
  EXPECT_EQ(differing({{}, {}, {}, {"throw_cg_m"}}), Names{});
}

TEST_F(Compare, NoMeasureIsAsNoMeasureOnly) {
  change("summary.json", "null", "1.3");
  EXPECT_EQ(differing({{10.0, 10.0}, {}, {}, {}}), Names{"swell_factor"});
}

TEST_F(Compare, AMissingKeyDiffers) {
  change("summary.json", "\"still\": true, ", "");
  EXPECT_EQ(differing(), Names{"still"});
}

TEST_F(Compare, InnerKeysHaveTheNamesOfBoth) {
  change("summary.json", "100", "200");
  EXPECT_EQ(differing(), Names{"energy_audit_J.vented"});
}

TEST_F(Compare, HowTheRunWentCountsOnlyWhereItIsAskedFor) {
  change("summary.json", "812b0b01e8ba37ac", "912b0b01e8ba37ac");
  EXPECT_EQ(differing(), Names{});
  EXPECT_EQ(differing({{}, {{"run_id", {}}}, {}, {}}), Names{"run_id"});
}

// The same line on another grid: 4 - 2x at 0, 1, 2; then with the middle 0.3 higher.
TEST_F(Compare, TablesAreCurvesOverTheirFirstColumn) {
  write_text(path("b") / "profile.csv", "x_m,pile_mean_m\n0,4\n1,2\n2,0\n");
  EXPECT_EQ(differing(), Names{});
  write_text(path("b") / "profile.csv", "x_m,pile_mean_m\n0,4\n1,2.3\n2,0\n");
  EXPECT_EQ(differing(), Names{"profile.csv:pile_mean_m"});
  EXPECT_EQ(differing({{0.076, 0.0}, {}, {}, {}}), Names{});  // 0.3 of the largest, 4, is 0.075
  EXPECT_EQ(differing({{}, {{"profile.csv", {0.0, 0.31}}}, {}, {}}), Names{});
  const auto rows = compare_runs(read_run_figures(path("a")), read_run_figures(path("b")), {});
  EXPECT_EQ(rows.back().place, "x_m = 1");
  EXPECT_NEAR(*rows.back().difference, 0.3, 1e-12);
}

TEST_F(Compare, BeyondItsEndsACurveKeepsItsValue) {
  const std::vector<Vec2> curve{{1.0, 5.0}, {2.0, 7.0}};
  EXPECT_DOUBLE_EQ(value_at(curve, 0.0), 5.0);
  EXPECT_DOUBLE_EQ(value_at(curve, 1.25), 5.5);
  EXPECT_DOUBLE_EQ(value_at(curve, 9.0), 7.0);
}

TEST_F(Compare, TolerancesOfACaseAreAbsolute) {
  change("summary.json", "8.0", "8.4");
  const auto expected = temporary_.path() / "expected.json";
  write_text(expected, R"({"case": "bench", "expected": [{"quantity": "throw_cg_m", "value": 7,)"
                       R"( "tolerance": 0.41, "why": "a test"}]})");
  EXPECT_EQ(differing({{}, {}, tolerances_of_case(expected), {}}), Names{});
}

TEST_F(Compare, UnreadableFilesAreRefusedByName) {
  change("summary.json", "}}", "");
  expect_refused("b/summary.json: ");
  write_text(path("b") / "summary.json", R"({"scene": 1})");
  expect_refused("is no summary of muckpile-post: it has no text 'case'");
  std::filesystem::remove(path("b") / "summary.json");
  expect_refused("b/summary.json: cannot be opened");
}

TEST_F(Compare, CutTablesAreRefusedByLine) {
  write_text(path("b") / "profile.csv", "x_m,pile_mean_m\n0,4\n2\n");
  expect_refused("profile.csv:3");
  write_text(path("b") / "profile.csv", "x_m,pile_mean_m\n0,4\n-1,2\n");
  expect_refused("x_m must not fall");
}

TEST_F(Compare, TablesWithoutARowAreAlikeAndDifferFromOthers) {  // as fragments.csv of still rock
  write_text(path("b") / "profile.csv", "x_m,pile_mean_m\n");
  EXPECT_EQ(differing(), Names{"profile.csv:pile_mean_m"});
  write_text(path("a") / "profile.csv", "x_m,pile_mean_m\n");
  EXPECT_EQ(differing(), Names{});
}

TEST_F(Compare, ANameThatNeitherRunHasIsRefused) {
  expect_refused("neither run has 'throw_cg'; did you mean 'throw_cg_m'?",
                 {{}, {{"throw_cg", {}}}, {}, {}});
  EXPECT_THROW((void)parse_tolerance("throw_cg_m"), InputError);
  EXPECT_THROW((void)parse_tolerance("throw_cg_m=-1"), InputError);
  EXPECT_THROW((void)parse_tolerance("throw_cg_m=1,x"), InputError);
  EXPECT_EQ(parse_tolerance("a=0.1,2").second.absolute, 2.0);
}

}  // namespace
}  // namespace muckpile
