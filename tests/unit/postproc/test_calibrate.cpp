// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command calibrate: surfaces and estimates with known answers, its tables, the site file, and
// what is refused. Scope: calibrate/ on sweeps written by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "calibrate/calibrate_report.h"
#include "calibrate/calibration.h"
#include "calibrate/measured.h"
#include "calibrate/site_file.h"
#include "figures/figures.h"
#include "golden_files.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

using namespace testing;

// Places of two constants in all combinations of -1, 0 and 1.
Eigen::MatrixXd nine_places() {
  Eigen::MatrixXd places(9, 2);
  for (int k = 0; k < 9; ++k) places.row(k) << k % 3 - 1, k / 3 - 1;
  return places;
}

ResponseSurface surface_of(SurfaceOrder order, const std::function<double(double, double)>& f) {
  const Eigen::MatrixXd places = nine_places();
  Eigen::VectorXd values(9);
  for (int k = 0; k < 9; ++k) values[k] = f(places(k, 0), places(k, 1));
  return {order, places, values, "test"};
}

TEST(ResponseSurface, GivesAQuadraticBackExactly) {
  const auto f = [](double a, double b) { return 3 + 2 * a - b + 0.5 * a * a + a * b - 2 * b * b; };
  const ResponseSurface surface = surface_of(SurfaceOrder::kQuadratic, f);
  const Eigen::Vector2d place(0.3, -0.7);
  EXPECT_NEAR(surface.at(place), f(0.3, -0.7), 1e-12);
  // 2 + a + b and -1 + a - 4 b
  EXPECT_NEAR((surface.slope(place) - Eigen::Vector2d(1.6, 2.1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(surface.scatter(), 0.0, 1e-12);
  EXPECT_EQ(surface.spare(), 3);
}

// A straight surface through a^2: its mean 2/3 is off by 1/3 in six runs and by -2/3 in three, so
// squares 6/9 + 12/9 = 2 with 9 - 3 runs to spare.
TEST(ResponseSurface, CountsWhatItCannotFollowAsScatter) {
  const ResponseSurface surface =
      surface_of(SurfaceOrder::kLinear, [](double a, double) { return a * a; });
  EXPECT_NEAR(surface.at(Eigen::Vector2d(1.0, 1.0)), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(surface.scatter(), std::sqrt(2.0 / 6.0), 1e-12);
}

TEST(ResponseSurface, NeedsMoreRunsThanTermsAndAllOfThemTold) {
  EXPECT_EQ(terms_of(SurfaceOrder::kQuadratic, 3), 10U);
  EXPECT_THROW(ResponseSurface(SurfaceOrder::kQuadratic, nine_places().topRows(6),
                               Eigen::VectorXd::Zero(6), "test"),
               InputError);
  Eigen::MatrixXd places = nine_places();
  places.col(1) = places.col(0);
  EXPECT_THROW(ResponseSurface(SurfaceOrder::kLinear, places, Eigen::VectorXd::Zero(9), "test"),
               InputError);
}

TEST(LogScale, HasTheEndsOfTheSweepAtOne) {
  const LogScale scale = log_scale({2.0, 0.5, 1.0});
  EXPECT_NEAR(scale.value_at(-1.0), 0.5, 1e-15);
  EXPECT_NEAR(scale.place_of(1.0), 0.0, 1e-15);
  EXPECT_NEAR(scale.place_of(2.0), 1.0, 1e-15);
}

// Slopes of 4 and 5 per place with deviations 0.2 and 0.1 are sharpnesses 20 and 50.
TEST(Calibration, FindsWhatTwoFiguresFix) {
  const std::vector<Target> targets{
      {10.0 + 4.0 * 0.25, 0.2,
       surface_of(SurfaceOrder::kLinear, [](double a, double) { return 10 + 4 * a; })},
      {7.0 - 5.0 * 0.5, 0.1,
       surface_of(SurfaceOrder::kLinear, [](double, double b) { return 7 - 5 * b; })}};
  const Calibration found = calibrate(targets, 2);
  EXPECT_NEAR((found.place - Eigen::Vector2d(0.25, 0.5)).norm(), 0.0, 1e-9);
  EXPECT_EQ(found.resolved(), 2U);
  EXPECT_NEAR(found.directions[0].sharpness, 50.0, 1e-9);
  EXPECT_NEAR(found.directions[1].sharpness, 20.0, 1e-9);
  EXPECT_NEAR(found.covariance(0, 0), 1.0 / 400.0, 1e-12);
  EXPECT_NEAR(found.covariance(1, 1), 1.0 / 2500.0, 1e-12);
  EXPECT_NEAR(found.misfit, 0.0, 1e-12);
}

// Two figures of a + b alone: the sum is fixed, the difference stays 0, with the variance of what
// is evenly likely: 1/3, half of it in each constant.
TEST(Calibration, LeavesWhatNoFigureTellsInTheMiddle) {
  const auto sum = surface_of(SurfaceOrder::kQuadratic, [](double a, double b) { return a + b; });
  const Calibration found = calibrate({{0.6, 0.1, sum}, {0.6, 0.1, sum}}, 2);
  EXPECT_NEAR((found.place - Eigen::Vector2d(0.3, 0.3)).norm(), 0.0, 1e-9);
  EXPECT_EQ(found.resolved(), 1U);
  EXPECT_NEAR(found.directions[0].sharpness, 20.0, 1e-9);  // sqrt(2 figures x 2) / 0.1
  EXPECT_NEAR(found.directions[1].sharpness, 0.0, 1e-9);
  EXPECT_NEAR(found.covariance(0, 0), 0.5 / 400.0 + 0.5 / 3.0, 1e-9);
  EXPECT_NEAR(found.covariance(0, 1), 0.5 / 400.0 - 0.5 / 3.0, 1e-9);
}

TEST(Calibration, AWeakMeasureTellsNothing) {
  const auto slope = surface_of(SurfaceOrder::kLinear, [](double a, double) { return a; });
  EXPECT_EQ(calibrate({{0.9, 0.6, slope}}, 2).resolved(), 0U);  // 1/0.6 < sqrt(3)
  EXPECT_EQ(calibrate({{0.9, 0.5, slope}}, 2).resolved(), 1U);
}

// Beyond the edge: a stays at 1, and b meets a + b = 1.5. What is left at the edge hides the last
// digits of the misfit, so b is found to 1e-8.
TEST(Calibration, StaysWithinTheSweepAndSaysSo) {
  const auto a = surface_of(SurfaceOrder::kLinear, [](double x, double) { return x; });
  const auto b = surface_of(SurfaceOrder::kLinear, [](double x, double y) { return x + y; });
  const Calibration found = calibrate({{3.0, 0.01, a}, {1.5, 0.01, b}}, 2);
  EXPECT_NEAR((found.place - Eigen::Vector2d(1.0, 0.5)).norm(), 0.0, 1e-6);
  EXPECT_TRUE(found.at_edge(0));
  EXPECT_FALSE(found.at_edge(1));
}

// From the middle, where the slope is 0, only another start finds the figure 0.36 of a^2.
TEST(Calibration, FindsItsWayFromAFlatMiddle) {
  const auto square = surface_of(SurfaceOrder::kQuadratic, [](double a, double) { return a * a; });
  const Calibration found = calibrate({{0.36, 0.01, square}}, 2);
  EXPECT_NEAR(std::abs(found.place[0]), 0.6, 1e-6);
}

// Throw is 10 + 4 ln e + ln^2 e - 2 ln f, height 5 - 2 ln e + ln e ln f with e energy_share and f
// friction, exactly.
class CalibrateFiles : public ::testing::Test {
 protected:
  static double thrown(double e, double f) {
    return 10 + 4 * std::log(e) + std::log(e) * std::log(e) - 2 * std::log(f);
  }
  static double height(double e, double f) {
    return 5 - 2 * std::log(e) + std::log(e) * std::log(f);
  }
  void SetUp() override {
    std::string list = "folder,state,energy_share,friction\n";
    for (const char* e : {"0.5", "0.7", "1"})
      for (const char* f : {"0.3", "0.5", "0.8"}) list += add_run(e, f);
    write_text(file("sweep_runs.csv"), list);
    measure("throw_cg_m," + check::text_of(thrown(0.8, 0.45)) + ",0.05\npile_height_m," +
            check::text_of(height(0.8, 0.45)) + ",0.02\n");
  }
  std::string add_run(const std::string& e, const std::string& f) const {
    const std::string run = "run" + e + "-" + f;
    const double share = std::stod(e), rub = std::stod(f);
    write_text(file(run + "/dump/scene.json"), R"({"case": "bench", "knobs": {"energy_share": ")" +
                                                   e + R"(", "friction": )" + f + "}}");
    write_text(file(run + "/summary.json"),
               R"({"case": "bench", "throw_cg_m": )" + check::text_of(thrown(share, rub)) +
                   R"(, "pile_height_m": )" + check::text_of(height(share, rub)) +
                   R"(, "pile_toe_m": null, "block_p50_m": 0.3})");
    return run + ",done," + e + "," + f + "\n";
  }
  void measure(const std::string& rows) const {
    write_text(file("measured.csv"), "figure,value,uncertainty\n" + rows);
  }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return temporary_.path() / name;
  }
  [[nodiscard]] FitOptions options() const {
    return {file("measured.csv"), temporary_.path().string(), "north"};
  }
  void expect_refused(const std::string& part, const FitOptions& words) const {
    try {
      report_calibration(words);
      FAIL() << "accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  void expect_refused(const std::string& part) const { expect_refused(part, options()); }
  TemporaryFolder temporary_;
};

TEST_F(CalibrateFiles, TheConstantsOfTheMeasuredBlastComeOut) {
  const std::vector<std::string> lines = report_calibration(options());
  EXPECT_EQ(lines.front(), "quadratic surfaces");
  const CsvTable table = CsvTable::read(file("calibrate.csv"));
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_NEAR(table.number(0, table.column("estimate")), 0.8, 1e-5);
  EXPECT_NEAR(table.number(1, table.column("estimate")), 0.45, 1e-5);
  EXPECT_NEAR(table.number(0, table.column("told_fraction")), 1.0, 1e-6);
  EXPECT_EQ(table.number(0, table.column("at_edge")), 0.0);
  // Covariance of the logarithms by hand: slopes (4 + 2 ln e, -2) and (-2 + ln f, ln e).
  const double a = (4 + 2 * std::log(0.8)) / 0.05, b = -2 / 0.05, c = (-2 + std::log(0.45)) / 0.02,
               d = std::log(0.8) / 0.02;
  const double p = a * a + c * c, q = a * b + c * d, r = b * b + d * d, det = p * r - q * q;
  const CsvTable covariance = CsvTable::read(file("calibrate_covariance.csv"));
  EXPECT_NEAR(covariance.number(0, 1), r / det, 1e-4 * r / det);
  EXPECT_NEAR(covariance.number(0, 2), -q / det, 1e-4 * std::abs(q / det));
  EXPECT_NEAR(table.number(1, table.column("standard_error_ln")), std::sqrt(p / det), 1e-4);
  EXPECT_GT(std::filesystem::file_size(file("calibrate.png")), 1000U);
}

// Their profiles have the column floor_m, which is no figure of a blast.
TEST_F(CalibrateFiles, RunsOnASurveyedFloorAreFittedByTheirFigures) {
  for (const char* e : {"0.5", "0.7", "1"})
    for (const char* f : {"0.3", "0.5", "0.8"})
      write_text(file("run" + std::string(e) + "-" + f + "/profile.csv"),
                 "x_m,pile_mean_m,floor_m\n0,4,-0.5\n1,3,-0.6\n");
  report_calibration(options());
  const CsvTable table = CsvTable::read(file("calibrate.csv"));
  EXPECT_NEAR(table.number(0, table.column("estimate")), 0.8, 1e-5);
  EXPECT_NEAR(table.number(1, table.column("estimate")), 0.45, 1e-5);
  measure("throw_cg_m,11,0.5\nfloor_m,-0.5,0.1\n");
  expect_refused("no run of the sweep has the figure 'floor_m'");
}

TEST_F(CalibrateFiles, TheTableOfFiguresIsTheGoldenOne) {
  measure("throw_cg_m,11,0.5\n");
  report_calibration(options());
  const std::string table = text_of(file("calibrate_figures.csv"));
  EXPECT_TRUE(table.starts_with(
      "figure,measured,uncertainty,fitted,surface_scatter,off_by_deviations,least_in_sweep,"
      "largest_in_sweep,runs,runs_to_spare\nthrow_cg_m,11,0.5,11,"))
      << table;
  EXPECT_TRUE(table.ends_with(",8.15415,12.4079,9,3\n")) << table;
}

TEST_F(CalibrateFiles, TheOtherTablesAreTheGoldenOnes) {
  report_calibration(options());
  for (const char* name :
       {"calibrate", "calibrate_figures", "calibrate_directions", "calibrate_covariance"})
    expect_golden(file(name + std::string(".csv")), name);
}

// Of throw alone: one direction is told, along the slope (4 + 2 ln e, -2) at the estimate.
TEST_F(CalibrateFiles, WhatCannotBeToldApartIsSaid) {
  measure("throw_cg_m,11,0.05\n");
  const std::vector<std::string> lines = report_calibration(options());
  const CsvTable table = CsvTable::read(file("calibrate_directions.csv"));
  EXPECT_EQ(table.number(0, table.column("resolved")), 1.0);
  EXPECT_EQ(table.number(1, table.column("resolved")), 0.0);
  const double e = CsvTable::read(file("calibrate.csv")).number(0, 1);
  EXPECT_NEAR(table.number(0, table.column("exponent_friction")), -2.0 / (4.0 + 2.0 * std::log(e)),
              1e-4);
  // Along the other one both grow, and throw stays.
  const double up = table.number(1, table.column("factor_energy_share"));
  const double rub = table.number(1, table.column("factor_friction"));
  EXPECT_NEAR((4.0 + 2.0 * std::log(e)) * std::log(up) - 2.0 * std::log(rub), 0.0, 1e-3);
  const std::string all = text_of(file("site_north.in"));
  EXPECT_NE(all.find("# not told by the measures: energy_share times "), std::string::npos) << all;
  EXPECT_NE(all.find("proves nothing; check it on another blast"), std::string::npos) << all;
}

TEST_F(CalibrateFiles, TheSiteFileIsWhatInputsInclude) {
  report_calibration(options());
  const SiteConstants constants = read_site_file(file("site_north.in"));
  ASSERT_EQ(constants.size(), 2U);
  EXPECT_EQ(constants[0].first, "energy_share");
  EXPECT_NEAR(std::stod(constants[0].second), 0.8, 1e-5);
  EXPECT_NE(text_of(file("site_north.in")).find("\nvariable friction index 0.45  # "),
            std::string::npos);
}

TEST_F(CalibrateFiles, MeasuresThatTellNothingLeaveNoSiteFile) {
  report_calibration(options());
  ASSERT_TRUE(std::filesystem::exists(file("site_north.in")));
  measure("throw_cg_m,11,50\n");
  expect_refused("tell no combination of energy_share,friction; there is no site file");
  EXPECT_FALSE(std::filesystem::exists(file("site_north.in")));
  EXPECT_TRUE(std::filesystem::exists(file("calibrate_figures.csv")));
}

TEST_F(CalibrateFiles, FaultyWordsAreRefused) {
  FitOptions words = options();
  words.site = "a/b";
  expect_refused("--site must be a name of letters", words);
  measure("throw_cg,11,1\n");
  expect_refused("no run of the sweep has the figure 'throw_cg'; did you mean 'throw_cg_m'?");
  measure("pile_toe_m,11,1\n");
  expect_refused("no run of the sweep has the figure 'pile_toe_m'");
  measure("throw_cg_m,11,0\n");
  expect_refused("measured.csv:2: uncertainty must be > 0");
  measure("throw_cg_m,11,1\nthrow_cg_m,12,1\n");
  expect_refused("measured.csv:3: figure 'throw_cg_m' is given twice");
  measure("");
  expect_refused("measured.csv: has no row");
  write_text(file("measured.csv"), "figure,value\nthrow_cg_m,11\n");
  expect_refused("measured.csv");
}

TEST_F(CalibrateFiles, SweepsOfOtherThanConstantsAreRefused) {
  write_text(file("sweep_runs.csv"),
             "folder,state,energy_share\n" + std::string("run0.5-0.3,done,0.5\n"));
  expect_refused("'energy_share': must be swept over two values at least, got '0.5'");
  write_text(file("sweep_runs.csv"), "folder,state,friction\nrun0.5-0.3,done,0.3\nx,failed,-1\n");
  expect_refused("'friction': must be swept over positive numbers");
  write_text(file("sweep_runs.csv"),
             "folder,state,friction\nrun0.5-0.3,done,0.3\nrun0.5-0.5,done,0.5\n");
  expect_refused("figure 'throw_cg_m': has a value in 2 runs; a surface of 2 terms needs 3");
}

class CheckFiles : public CalibrateFiles {
 protected:
  [[nodiscard]] CheckOptions words(const std::vector<std::string>& runs) const {
    CheckOptions options;
    options.measured = file("measured.csv");
    for (const std::string& run : runs) options.runs.push_back(file(run).string());
    return options;
  }
  void add_throw(const std::string& run, double thrown, const std::string& knobs) const {
    write_text(file(run + "/dump/scene.json"), R"({"case": "bench", "knobs": {)" + knobs + "}}");
    write_text(file(run + "/summary.json"),
               R"({"case": "bench", "throw_cg_m": )" + check::text_of(thrown) + "}");
  }
};

// Throw of the run e = 1, f = 0.5 is 10 + 2 ln 2 = 11.386, height 5.
TEST_F(CheckFiles, ARunWithinTwoDeviationsAgrees) {
  measure("throw_cg_m,10.5,0.5\npile_height_m,5,0.1\n");
  CheckOptions options = words({"run1-0.5"});
  options.csv = file("check.csv");
  const CheckResult result = check_calibration(options);
  EXPECT_TRUE(result.agrees);
  EXPECT_EQ(text_of(file("check.csv")),
            "figure,measured,uncertainty,runs,run_mean,run_deviation,off_by_deviations\n"
            "throw_cg_m,10.5,0.5,1,11.3863,,1.77259\npile_height_m,5,0.1,1,5,,0\n");
  options.within = 1.5;
  const CheckResult strict = check_calibration(options);
  EXPECT_FALSE(strict.agrees);
  EXPECT_TRUE(strict.lines.front().ends_with("DIFFERS")) << strict.lines.front();
}

// Of 12 and 11 m: mean 11.5, deviation sqrt(1/2) = 0.707107; with 0.5 of the measure 0.866025.
TEST_F(CheckFiles, SeveralRunsBringTheirScatter) {
  measure("throw_cg_m,10.5,0.5\n");
  add_throw("one", 12.0, R"("out": "one", "seed": 1, "delay_seed": 7)");
  add_throw("two", 11.0, R"("out": "two", "seed": 2, "delay_seed": 8)");
  CheckOptions options = words({"one", "two"});
  options.csv = file("check.csv");
  EXPECT_TRUE(check_calibration(options).agrees);
  EXPECT_NE(text_of(file("check.csv")).find("throw_cg_m,10.5,0.5,2,11.5,0.707107,1.1547"),
            std::string::npos)
      << text_of(file("check.csv"));
}

TEST_F(CheckFiles, RunsOfDifferentBlastsAreRefused) {
  measure("throw_cg_m,10.5,0.5\n");
  add_throw("one", 12.0, R"("burden": 1.8, "seed": 1)");
  add_throw("two", 11.0, R"("burden": 2.2, "seed": 2)");
  try {
    (void)check_calibration(words({"one", "two"}));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "calibrate check: runs must be of one blast, with other seeds at most, but " +
                  file("one").string() + " and " + file("two").string() +
                  " differ in: burden 1.8, 2.2");
  }
}

TEST_F(CheckFiles, RunsWithOtherConstantsAreRefused) {
  measure("throw_cg_m,10.5,0.5\n");
  CheckOptions options = words({"run1-0.5"});
  options.site = write_text(file("site.in"), "# a site\nvariable energy_share index 1.0 # told\n");
  EXPECT_TRUE(check_calibration(options).agrees);
  write_text(file("site.in"), "variable energy_share index 0.9\n");
  try {
    (void)check_calibration(options);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("energy_share '1', but"), std::string::npos)
        << error.what();
  }
  write_text(file("site.in"), "variable energy_share equal 0.9\n");
  EXPECT_THROW((void)check_calibration(options), InputError);
  write_text(file("site.in"), "# nothing\n");
  EXPECT_THROW((void)check_calibration(options), InputError);
  measure("pile_toe_m,10.5,0.5\n");
  EXPECT_THROW((void)check_calibration(words({"run1-0.5"})), InputError);
}

}  // namespace
}  // namespace muckpile
