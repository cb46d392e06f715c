// SPDX-License-Identifier: GPL-2.0-or-later
// Sweeps over sampled ranges: the samples, correlations, joint power laws, tables and bands.
// Scope: sweep/ on numbers, lists and summaries written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "golden_files.h"
#include "sweep/correlation.h"
#include "sweep/influence.h"
#include "sweep/influence_plot.h"
#include "sweep/latin_hypercube.h"
#include "sweep/sweep_report.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

using namespace testing;

std::vector<double> column(const std::vector<std::vector<double>>& rows, size_t k) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[k]);
  return values;
}

TEST(LatinHypercube, EachPartOfARangeHoldsOneRun) {
  constexpr size_t kRuns = 20, kQuantities = 4;
  const auto design = latin_hypercube(kRuns, kQuantities, 1);
  ASSERT_EQ(design.size(), kRuns);
  for (size_t k = 0; k < kQuantities; ++k) {
    std::vector<int> counts(kRuns, 0);
    for (const double share : column(design, k)) ++counts.at(static_cast<size_t>(share * kRuns));
    for (const int count : counts) EXPECT_EQ(count, 1);
  }
}

// Twenty independent samples of four quantities, six pairs, have a largest correlation of about
// 0.4; the best of a hundred designs has a third of that.
TEST(LatinHypercube, QuantitiesAreHardlyCorrelated) {
  const auto design = latin_hypercube(20, 4, 1);
  for (size_t a = 0; a < 4; ++a)
    for (size_t b = 0; b < a; ++b)
      EXPECT_LT(std::abs(correlation(column(design, a), column(design, b)).value()), 0.25);
}

TEST(LatinHypercube, IsTheSameForTheSameSeedOnly) {
  EXPECT_EQ(latin_hypercube(5, 2, 3), latin_hypercube(5, 2, 3));
  EXPECT_NE(latin_hypercube(5, 2, 3), latin_hypercube(5, 2, 4));
}

TEST(SampledRange, IsStraightOrLogarithmic) {
  EXPECT_EQ(sampled_value(parse_range("burden=2..4"), 0.25), "2.5");
  EXPECT_EQ(sampled_value(parse_range("grain=log:1e-4..1e-2"), 0.5), "0.001");
}

TEST(SampledRange, RefusesWhatIsNone) {
  for (const char* words : {"burden", "=2..3", "burden=2", "burden=3..2", "burden=2..2",
                            "burden=2..x", "burden=..3", "grain=log:0..1", "burden=2..nan",
                            "burden=2..3..4", "my burden=2..3", "burden =2..3", " burden=2..3"})
    EXPECT_THROW(static_cast<void>(parse_range(words)), InputError) << words;
}

TEST(Correlation, OfRanksIsOneWhereverOneRisesWithTheOther) {
  const std::vector<double> x{1.0, 2.0, 3.0, 4.0}, curved{1.0, 10.0, 100.0, 1e6};
  EXPECT_DOUBLE_EQ(rank_correlation(x, curved).value(), 1.0);
  EXPECT_LT(correlation(x, curved).value(), 0.9);
  EXPECT_FALSE(correlation(x, {5.0, 5.0, 5.0, 5.0}));
}

// 7 and 7 stand at 2 and 3. Ranks 1, 2.5, 2.5, 4 against 1, 2, 3, 4: sums of products about 2.5 are
// 4.5; squares 4.5 and 5.
TEST(Correlation, EqualValuesShareTheirRank) {
  EXPECT_EQ(ranks_of({9.0, 7.0, 1.0, 7.0}), (std::vector<double>{4.0, 2.5, 1.0, 2.5}));
  EXPECT_NEAR(rank_correlation({1.0, 7.0, 7.0, 9.0}, {1.0, 2.0, 3.0, 4.0}).value(),
              4.5 / std::sqrt(4.5 * 5.0), 1e-14);
}

// y = 1, 2, 2 over x = 0, 1, 2: slope 1/2, left over -1/6, 1/3, -1/6, squares 1/6 of 2/3; one run
// to spare: error sqrt(1/6 / 1 / 2).
TEST(LinearLaw, HasTheErrorOfASlope) {
  const auto law = fit_linear({{0.0, 1.0, 2.0}}, {1.0, 2.0, 2.0});
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->slopes[0], 0.5, 1e-14);
  EXPECT_NEAR(law->errors[0], std::sqrt(1.0 / 12.0), 1e-14);
  EXPECT_NEAR(law->explained, 0.75, 1e-14);
}

TEST(LinearLaw, IsNoneWithoutARunToSpareOrWithColumnsThatGoTogether) {
  EXPECT_FALSE(fit_linear({{0.0, 1.0}}, {1.0, 2.0}));
  EXPECT_FALSE(fit_linear({{0.0, 1.0, 2.0, 3.0}, {1.0, 3.0, 5.0, 7.0}}, {1.0, 2.0, 4.0, 3.0}));
  EXPECT_FALSE(fit_linear({{1.0, 1.0, 1.0}}, {1.0, 2.0, 3.0}));
}

// Throw is 24 m energy^0.5 / burden; the grain does nothing. The pile of run k is k m high up to
// 10 m, in run 5 a metre higher beyond.
class SampledFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::vector<std::vector<std::string>> samples{{"2", "0.9", "1"},
                                                        {"2.5", "0.7", "3"},
                                                        {"3", "1", "2"},
                                                        {"3.5", "0.6", "5"},
                                                        {"4", "0.8", "4"}};
    std::string list =
        "# inputs/bench/in.bench\n# sampled burden=2..4 energy_share=0.6..1 grain=1..5\n"
        "folder,state,burden,energy_share,grain,seed\n";
    for (size_t k = 0; k < samples.size(); ++k) list += add_run(k + 1, samples[k]);
    write_text(file("sweep_runs.csv"), list);
  }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return temporary_.path() / name;
  }
  std::string add_run(size_t number, const std::vector<std::string>& v) const {
    const std::string k = std::to_string(number), run = "run-" + k;
    write_text(file(run + "/dump/scene.json"),
               R"({"case": "bench", "burden_m": )" + v[0] + R"(, "run_id": "a)" + k +
                   R"(", "knobs": {"burden": )" + v[0] + R"(, "energy_share": )" + v[1] +
                   R"(, "grain": )" + v[2] + R"(, "seed": )" + k + "}}");
    const double thrown = 24.0 * std::sqrt(std::stod(v[1])) / std::stod(v[0]);
    write_text(file(run + "/summary.json"), R"({"case": "bench", "run_id": "a)" + k +
                                                R"(", "throw_cg_m": )" + std::to_string(thrown) +
                                                R"(, "still": true})");
    const std::string high = std::to_string(number);
    write_text(file(run + "/profile.csv"), "x_m,pile_mean_m\n0," + high + "\n10," + high + "\n" +
                                               (number == 5 ? "20,6\n" : ""));
    return run + ",done," + v[0] + "," + v[1] + "," + v[2] + "," + k + "\n";
  }
  TemporaryFolder temporary_;
};

TEST_F(SampledFiles, TheVariableThatMattersMostStandsFirstWithItsExponent) {
  report_sweep(temporary_.path(), {"throw_cg_m"});
  const CsvTable table = CsvTable::read(file("sweep_influence.csv"));
  ASSERT_EQ(table.rows(), 3U);  // the seed is none
  EXPECT_EQ(table.word(0, 1), "burden");
  EXPECT_LT(table.number(0, 2), -0.8);
  EXPECT_NEAR(table.number(0, 3), -1.0, 1e-4);
  for (size_t row = 0; row < 3; ++row) {
    const std::string variable(table.word(row, 1));
    const double expected = variable == "burden" ? -1.0 : variable == "grain" ? 0.0 : 0.5;
    EXPECT_NEAR(table.number(row, 3), expected, 1e-4) << variable;
    EXPECT_NEAR(table.number(row, table.column("explained")), 1.0, 1e-6);
    EXPECT_EQ(table.whole(row, table.column("runs")), 5);
  }
}

TEST_F(SampledFiles, TheTableOfInfluencesIsTheGoldenOne) {
  report_sweep(temporary_.path(), {"throw_cg_m"});
  expect_golden(file("sweep_influence.csv"), "bench_sweep_influence");
}

TEST_F(SampledFiles, AllRunsAreOneCombination) {
  report_sweep(temporary_.path(), {});
  const CsvTable table = CsvTable::read(file("sweep_mean.csv"));
  EXPECT_EQ(table.header().front(), "figure");
  EXPECT_EQ(table.whole(0, table.column("runs")), 5);
}

TEST_F(SampledFiles, EachFigureIsDrawnOverWhatItFollowsMost) {
  const Sweep sweep = read_sweep(temporary_.path());
  const Panels panels = plot_of_samples(sweep, influences_of(sweep, {"throw_cg_m"}));
  ASSERT_EQ(panels.plots.size(), 1U);
  EXPECT_EQ(panels.plots.front().x_label, "burden [m]");
  EXPECT_EQ(panels.plots.front().curves.front().points.size(), 5U);
  EXPECT_EQ(panels.plots.front().curves.size(), 4U);  // and P10, P50, P90
}

// Heights 1, 2, 3, 4, 5 up to 10 m: P10 at place 0.4. At 20 m that of run 5 is 6 m.
TEST_F(SampledFiles, TheSurfacesOfAllRunsAreLaidOverEachOther) {
  report_sweep(temporary_.path(), {});
  const CsvTable table = CsvTable::read(file("overlay_profile.csv"));
  ASSERT_EQ(table.rows(), 3U);
  EXPECT_NEAR(table.number(1, table.column("p10")), 1.4, 1e-6);
  EXPECT_NEAR(table.number(1, table.column("p50")), 3.0, 1e-6);
  EXPECT_NEAR(table.number(1, table.column("p90")), 4.6, 1e-6);
  EXPECT_NEAR(table.number(2, table.column("p90")), 4.0 + 0.6 * 2.0, 1e-6);
  EXPECT_TRUE(std::filesystem::exists(file("overlay_profile.png")));
}

TEST_F(SampledFiles, TablesOfListsOfValuesAreNotLeftBeside) {
  write_text(file("sweep_fit.csv"), "of an earlier sweep");
  for (const auto& path : report_sweep(temporary_.path(), {}))
    EXPECT_GT(std::filesystem::file_size(path), 50U) << path;
  EXPECT_FALSE(std::filesystem::exists(file("sweep_fit.csv")));
}

TEST_F(SampledFiles, TwoSurfacesAreNoBand) {
  report_sweep(temporary_.path(), {});
  ASSERT_TRUE(std::filesystem::exists(file("overlay_profile.csv")));
  for (const char* run : {"run-1", "run-2", "run-3"})
    std::filesystem::remove(file(std::string(run) + "/profile.csv"));
  report_sweep(temporary_.path(), {});
  EXPECT_FALSE(std::filesystem::exists(file("overlay_profile.csv")));
}

}  // namespace
}  // namespace muckpile
