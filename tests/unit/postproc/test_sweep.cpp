// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command sweep: spread over seeds, power laws, the tables, the picture, and what is refused.
// Scope: sweep/ on lists and summaries written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "draw/panels.h"
#include "golden_files.h"
#include "sweep/power_law.h"
#include "sweep/spread.h"
#include "sweep/sweep_fits.h"
#include "sweep/sweep_plot.h"
#include "sweep/sweep_report.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

using namespace testing;

// 1, 2, 4, 9: mean 4; squares 9 + 4 + 0 + 25 = 38, of 3. P10 at place 0.3: 1.3; P90 at 2.7: 4 + 0.7
// x 5.
TEST(Spread, HasQuantilesBetweenTheValues) {
  const Spread spread = spread_of({9.0, 1.0, 4.0, 2.0});
  EXPECT_EQ(spread.count, 4U);
  EXPECT_DOUBLE_EQ(spread.mean, 4.0);
  EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt(38.0 / 3.0));
  EXPECT_DOUBLE_EQ(spread.least, 1.0);
  EXPECT_DOUBLE_EQ(spread.p10, 1.3);
  EXPECT_DOUBLE_EQ(spread.p50, 3.0);
  EXPECT_DOUBLE_EQ(spread.p90, 7.5);
  EXPECT_DOUBLE_EQ(spread.largest, 9.0);
}

TEST(Spread, OfOneValueHasNoDeviation) {
  const Spread spread = spread_of({5.0});
  EXPECT_DOUBLE_EQ(spread.p10, 5.0);
  EXPECT_DOUBLE_EQ(spread.p90, 5.0);
  EXPECT_TRUE(std::isnan(spread.deviation));
}

TEST(PowerLaw, IsFoundThroughFactorsOfGroups) {
  std::vector<PowerPoint> points;
  for (const double x : {1.0, 2.0, 5.0}) {
    points.push_back({x, 3.0 * std::pow(x, -1.5), 0});
    points.push_back({x, 70.0 * std::pow(x, -1.5), 1});
  }
  const auto law = fit_power_law(points);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, -1.5, 1e-12);
  EXPECT_NEAR(law->error.value(), 0.0, 1e-7);  // the root of what rounding leaves
}

// ln x = 0, 1, 2 and ln y = 0, 1.3, 2: slope 2/2 = 1; off by -0.1, 0.2, -0.1, squares 0.06. One
// point is to spare: error sqrt(0.06 / 1 / 2), residual sqrt(0.06 / 3).
TEST(PowerLaw, HasTheStandardErrorOfASlope) {
  const auto law = fit_power_law(
      {{1.0, 1.0, 0}, {std::exp(1.0), std::exp(1.3), 0}, {std::exp(2.0), std::exp(2.0), 0}});
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 1.0, 1e-12);
  EXPECT_NEAR(law->error.value(), std::sqrt(0.03), 1e-12);
  EXPECT_NEAR(law->residual, std::sqrt(0.02), 1e-12);
}

TEST(PowerLaw, NeedsThreePlacesAndTwoInAGroup) {
  EXPECT_FALSE(fit_power_law({{1.0, 1.0, 0}, {2.0, 2.0, 0}, {2.0, 3.0, 0}}));
  EXPECT_FALSE(fit_power_law({{1.0, 1.0, 0}, {2.0, 2.0, 1}, {3.0, 3.0, 2}}));
}

// Throw is 24 m over the burden, times 1 at a bench height of 6 m and 1.5 at 9 m, times 1 with seed
// 1 and 1.1 with seed 2.
class SweepFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string list = "# inputs/bench/in.bench\nfolder,state,burden,bench_height,seed\n";
    for (const int burden : {2, 3, 4}) {
      for (const int height : {6, 9}) {
        for (const int seed : {1, 2}) list += add_run(burden, height, seed);
      }
    }
    write_text(file("sweep_runs.csv"), list);
  }
  std::string add_run(int burden, int height, int seed) const {
    const std::string b = std::to_string(burden), h = std::to_string(height),
                      s = std::to_string(seed);
    const std::string run = "burden-" + b + ",bench_height-" + h + ",seed-" + s;
    write_text(file(run + "/dump/scene.json"),
               R"({"case": "bench", "burden_m": )" + b + R"(, "run_id": "aa)" + b + h + s +
                   R"(", "knobs": {"burden": )" + b + R"(.0, "bench_height": ")" + h +
                   R"(", "seed": )" + s + "}}");
    const double thrown = 24.0 / burden * (height == 6 ? 1.0 : 1.5) * (seed == 1 ? 1.0 : 1.1);
    write_text(file(run + "/summary.json"),
               R"({"case": "bench", "run_id": "aa)" + b + h + s + R"(", "throw_cg_m": )" +
                   std::to_string(thrown) + R"(, "pile_height_m": null, "swell_factor": 1.)" + s +
                   R"(, "still": )" + (burden == 4 && height == 9 && seed == 2 ? "false" : "true") +
                   R"(, "fragments_note": "words", "energy_audit_J": {"vented": 5}})");
    return "burden-" + b + ";bench_height-" + h + ";seed-" + s + ",done," + b + "," + h + "," + s +
           "\n";
  }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return temporary_.path() / name;
  }
  void change(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = text_of(file(name));
    ASSERT_NE(text.find(from), std::string::npos);
    write_text(file(name), text.replace(text.find(from), from.size(), to));
  }
  void expect_refused(const std::string& part, const std::vector<std::string>& figures = {}) const {
    try {
      report_sweep(temporary_.path(), figures);
      FAIL() << "accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  TemporaryFolder temporary_;
  const std::string first_ = "burden-2,bench_height-6,seed-1";
};

TEST_F(SweepFiles, EachRunIsARowOfAllItsNumbers) {
  change("sweep_runs.csv", "seed-2,done,4,9,2", "seed-2,failed,4,9,2");
  report_sweep(temporary_.path(), {});
  const std::string table = text_of(file("sweep.csv"));
  EXPECT_EQ(table.substr(0, table.find("\n2,9")),
            "burden,bench_height,seed,state,energy_audit_J.vented,still,swell_factor,throw_cg_m\n"
            "2,6,1,done,5,1,1.1,12\n2,6,2,done,5,1,1.2,13.2");
  EXPECT_TRUE(table.ends_with("\n4,9,2,failed,,,,\n"));
}

TEST_F(SweepFiles, TheTablesAreTheGoldenOnes) {
  report_sweep(temporary_.path(), {});
  for (const char* name : {"sweep", "sweep_mean", "sweep_fit"})
    expect_golden(file(name + std::string(".csv")), std::string("bench_") + name);
}

// Two seeds of 6 m: 12 and 13.2 m; P10 a tenth of the way.
TEST_F(SweepFiles, TheSpreadIsThatOverSeeds) {
  report_sweep(temporary_.path(), {});
  const std::string table = text_of(file("sweep_mean.csv"));
  EXPECT_TRUE(table.starts_with(
      "burden,bench_height,figure,runs,mean,standard_deviation,least,p10,p50,p90,largest\n"));
  EXPECT_NE(table.find("\n2,6,throw_cg_m,2,12.6,0.848528,12,12.12,12.6,13.08,13.2\n"),
            std::string::npos)
      << table;
}

TEST_F(SweepFiles, SeedsAloneAreOneCombination) {
  write_text(file("sweep_runs.csv"),
             "folder,state,seed\nburden-2;bench_height-6;seed-1,done,1\n"
             "burden-2;bench_height-6;seed-2,done,2\n");
  report_sweep(temporary_.path(), {});
  const std::string table = text_of(file("sweep_mean.csv"));
  EXPECT_TRUE(table.starts_with("figure,runs,mean,")) << table;
  EXPECT_NE(table.find("\nthrow_cg_m,2,12.6,"), std::string::npos) << table;
}

TEST_F(SweepFiles, ExponentsAreThoseOfVariablesWithThreeValues) {
  report_sweep(temporary_.path(), {"throw_cg_m"});
  const CsvTable table = CsvTable::read(file("sweep_fit.csv"));
  ASSERT_EQ(table.rows(), 1U);  // the bench height has two
  EXPECT_EQ(table.word(0, 0), "throw_cg_m");
  EXPECT_EQ(table.word(0, 1), "burden");
  EXPECT_NEAR(table.number(0, 2), -1.0, 1e-5);
  // The seeds' ln 1.1 / 2 about their mean is the only scatter; 12 runs, 2 groups. Squared
  // deviations of ln 2, ln 3, ln 4 are 0.242585, each four times.
  const double half = 0.5 * std::log(1.1);
  EXPECT_NEAR(table.number(0, 3), std::sqrt(12.0 * half * half / 9.0 / (4.0 * 0.242585)), 1e-5);
  EXPECT_NEAR(table.number(0, table.column("residual_ln")), half, 1e-5);
  EXPECT_EQ(table.whole(0, table.column("runs")), 12);
  EXPECT_EQ(table.whole(0, table.column("runs_left_out")), 0);
}

TEST_F(SweepFiles, AFitLeavesOutWhatIsNotPositiveAndSaysSo) {
  change(first_ + "/summary.json", "12.000000", "-1");
  write_text(file("sweep_runs.csv"), text_of(file("sweep_runs.csv")) + add_run(-1, 6, 1));
  change("burden--1,bench_height-6,seed-1/summary.json", "-24.000000", "24");
  report_sweep(temporary_.path(), {"throw_cg_m"});
  const CsvTable table = CsvTable::read(file("sweep_fit.csv"));
  EXPECT_EQ(table.whole(0, table.column("runs")), 11);
  EXPECT_EQ(table.whole(0, table.column("runs_left_out")), 2);
  EXPECT_EQ(table.number(0, table.column("from")), 2.0);
}

TEST_F(SweepFiles, WithoutAFitThereIsNoTableOfFits) {
  write_text(file("sweep_fit.csv"), "of an earlier sweep");
  write_text(file("sweep_influence.csv"), "of an earlier sweep over ranges");
  write_text(file("sweep_runs.csv"),
             "folder,state,burden\nburden-2;bench_height-6;seed-1,done,2\n"
             "burden-3;bench_height-6;seed-1,done,3\n");
  report_sweep(temporary_.path(), {});
  EXPECT_FALSE(std::filesystem::exists(file("sweep_fit.csv")));
  EXPECT_FALSE(std::filesystem::exists(file("sweep_influence.csv")));
}

TEST_F(SweepFiles, ThePlotHasACurveForEachValueOfTheSecondVariable) {
  const Sweep sweep = read_sweep(temporary_.path());
  const Panels panels = plot_of_sweep(sweep, {"throw_cg_m"}, fit_sweep(sweep, {"throw_cg_m"}));
  ASSERT_EQ(panels.plots.size(), 1U);
  const CurvePlot& plot = panels.plots.front();
  EXPECT_EQ(plot.x_label, "burden [m]");
  EXPECT_EQ(plot.y_label, "Throw of the mass centre [m]");
  EXPECT_TRUE(plot.title.starts_with("~ burden^(-1 ± ")) << plot.title;
  EXPECT_EQ(panels.warning, "1 STILL MOVING");
  ASSERT_EQ(plot.curves.size(), 2U);
  EXPECT_EQ(plot.curves[1].label, "bench height 9");  // no scene tells its unit
  ASSERT_EQ(plot.curves[1].points.size(), 3U);
  EXPECT_NEAR(plot.curves[1].points[1].y(), 12.6, 1e-5);  // (12 + 13.2) / 2 at a burden of 3 m
  ASSERT_EQ(plot.curves[1].bars.size(), 3U);
  EXPECT_NEAR(plot.curves[1].bars[1].high, 13.2, 1e-5);
  EXPECT_GT(draw_panels(panels).height(), 400);
}

TEST_F(SweepFiles, WordsStandOnAnAxisOfTheirOwn) {
  write_text(file("sweep_runs.csv"),
             "folder,state,rock,seed\nburden-2;bench_height-6;seed-1,done,granite,1\n"
             "burden-3;bench_height-6;seed-1,done,basalt,1\n");
  change("burden-2,bench_height-6,seed-1/dump/scene.json", "\"knobs\": {",
         "\"knobs\": {\"rock\": \"granite\", ");
  change("burden-3,bench_height-6,seed-1/dump/scene.json", "\"knobs\": {",
         "\"knobs\": {\"rock\": \"basalt\", ");
  const Sweep sweep = read_sweep(temporary_.path());
  const CurvePlot plot = plot_of_sweep(sweep, {"throw_cg_m"}, {}).plots.front();
  EXPECT_EQ(plot.x_words, (std::vector<std::string>{"granite", "basalt"}));
  EXPECT_EQ(plot.curves.front().points.back().x(), 2.0);
  EXPECT_TRUE(fit_sweep(sweep, {"throw_cg_m"}).empty());
}

TEST_F(SweepFiles, ThePictureIsDrawn) {
  const auto written = report_sweep(temporary_.path(), {});
  ASSERT_EQ(written.size(), 4U);
  for (const auto& path : written) EXPECT_GT(std::filesystem::file_size(path), 100U) << path;
}

TEST_F(SweepFiles, WhatIsNoSweepIsRefused) {
  change("sweep_runs.csv", ",done,", ",over,");
  expect_refused("sweep_runs.csv:3: state must be one of done, failed,");
  write_text(file("sweep_runs.csv"), "folder,state\na,done\n");
  expect_refused("must have the columns folder, state and one for each swept variable");
  write_text(file("sweep_runs.csv"), "folder,state,burden\na,waiting,2\n");
  expect_refused("holds no run that has ended well");
  std::filesystem::remove(file("sweep_runs.csv"));
  expect_refused("sweep_runs.csv: is not there; './muckpile sweep' writes it");
}

TEST_F(SweepFiles, ResultsOfAnotherRunAreRefused) {
  change(first_ + "/dump/scene.json", "\"burden\": 2.0", "\"burden\": 2.5");
  expect_refused("seed-1/dump/scene.json: is of another run: burden is '2.5', the sweep has '2'");
  change(first_ + "/dump/scene.json", "\"burden\": 2.5", "\"width\": 2");
  expect_refused("burden is 'missing', the sweep has '2'");
  change(first_ + "/dump/scene.json", "knobs", "knots");
  expect_refused("has no object 'knobs'");
  change(first_ + "/dump/scene.json", "knots", "knobs");
  change(first_ + "/dump/scene.json", "\"width\": 2", "\"burden\": 2");
  change(first_ + "/summary.json", "aa261", "bb261");
  expect_refused("seed-1/summary.json: is of another run than");
  change(first_ + "/summary.json", "bb261", "aa261");
  change("burden-4,bench_height-9,seed-2/summary.json", "bench", "crater");
  expect_refused("is of a case 'crater', those before it are of 'bench'");
}

TEST_F(SweepFiles, MissingResultsAreRefusedByName) {
  std::filesystem::remove(file(first_ + "/summary.json"));
  expect_refused(first_ + "/summary.json: cannot be opened");
  std::filesystem::remove(file(first_ + "/dump/scene.json"));
  expect_refused(first_ + "/dump/scene.json: cannot be opened");
}

TEST_F(SweepFiles, AFigureThatNoRunHasIsRefused) {
  expect_refused("no run has the figure 'throw_cg'; did you mean 'throw_cg_m'?", {"throw_cg"});
}

}  // namespace
}  // namespace muckpile
