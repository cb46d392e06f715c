// SPDX-License-Identifier: GPL-2.0-or-later
// Fines by a law: their sizes, the mass of rock near charges, and tables beside the simulated ones.
// Scope: made-up rock of cubes, against areas of rings.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "args/csv_table.h"
#include "input_error_of.h"
#include "measure/fines_law.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

TEST(FinesLaw, IsARosinRammlerCurveThatEndsAtTheTopSize) {
  const FinesLaw law{3.0, 1e-3, 2.0};
  EXPECT_DOUBLE_EQ(law.passing(1e-3), 0.99);
  EXPECT_NEAR(law.passing(0.5e-3), 1.0 - std::pow(0.01, 0.25), 1e-12);
  EXPECT_DOUBLE_EQ(law.passing(0.0), 0.0);
}

// A charge 4 m long in the middle of a box of cubes; hole of 5 cm in radius, rock crushed to 0.5 m.
class CrushedCubes : public ::testing::Test {
 protected:
  [[nodiscard]] double mass(double zone, const std::vector<char>& moved) const {
    return rock(zone, moved).mass();
  }
  [[nodiscard]] CrushedRock rock(double zone, const std::vector<char>& moved) const {
    return crushed_rock({10.0, 1e-3, 1.0}, {{{{0.1, 0.1, 1.0}, {0.1, 0.1, 5.0}, zone}, 0.05}},
                        blocks_, moved);
  }
  const std::vector<StartBlock> blocks_ = as_start_blocks(cubes_in({-2, -2, 0}, {2, 2, 6}));
  const std::vector<char> all_ = std::vector<char>(blocks_.size(), 1);
  const double whole_ = kDensity * std::numbers::pi * (0.25 - 0.0025) * 4.0;  // [kg]
};

TEST_F(CrushedCubes, WeighWhatTheRingAroundTheHoleWeighs) {
  EXPECT_NEAR(mass(0.05, all_) / whole_, 1.0, 0.01);
  EXPECT_NEAR(rock(0.05, all_).without_blocks, 0.0, 1e-9);
}

TEST_F(CrushedCubes, AreInPartWhatTheCutLeavesOut) {
  const CrushedRock found = rock(0.3, all_);
  EXPECT_NEAR(found.mass() / whole_, 1.0, 0.01);
  EXPECT_NEAR(found.without_blocks / whole_, (0.09 - 0.0025) / (0.25 - 0.0025), 1e-3);
  EXPECT_NEAR(rock(0.8, all_).without_blocks / whole_, 1.0, 1e-3);
}

TEST_F(CrushedCubes, CountWhereRockWasBrokenOut) {
  std::vector<char> upper = all_;
  for (size_t b = 0; b < blocks_.size(); ++b) upper[b] = blocks_[b].centroid.z() > 3.0 ? 1 : 0;
  EXPECT_NEAR(mass(0.3, upper) / whole_, 0.5, 0.01);
  EXPECT_EQ(mass(0.3, std::vector<char>(blocks_.size(), 0)), 0.0);
}

class FinesOfABench : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bench(temporary_.path());
    report_fragments(folder(), {kCube, 0.125}, {});
  }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] nlohmann::ordered_json summary() const {
    return read_json_object(folder().file("summary.json"));
  }
  static FragmentOptions within(double radii) {
    FragmentOptions options;
    options.fines_radius = radii;
    return options;
  }
  TemporaryFolder temporary_;
};

// In front of the hole, from the floor to the top of the charge, half of the ring was thrown: 8 m
// of it. The pile is 840 cubes.
TEST_F(FinesOfABench, AreTabulatedApart) {
  const std::string simulated = text_of(folder().file("sieve.csv"));
  const nlohmann::ordered_json before = summary();
  report_fragments(folder(), {kCube, 0.125}, within(10.0));
  const double fines = 0.5 * kDensity * std::numbers::pi * (0.25 - 0.0025) * 8.0;
  const double share = fines / (840 * kDensity * 0.125);
  const nlohmann::ordered_json keys = summary();
  EXPECT_NEAR(keys["fines_law_mass_kg"].get<double>() / fines, 1.0, 0.01);
  EXPECT_NEAR(keys["fines_law_mass_fraction"].get<double>() / share, 1.0, 0.01);
  const CsvTable table = CsvTable::read(folder().file("fines.csv"));
  const auto at = [&](double size, const char* column) {
    size_t row = 0;
    while (table.number(row, 0) < 0.999 * size) ++row;
    return table.number(row, table.column(column));
  };
  EXPECT_NEAR(at(1e-3, "with_fines_law_passing") / share, 0.99, 0.01);
  EXPECT_EQ(at(1e-3, "simulated_passing"), 0.0);
  EXPECT_NEAR(at(1e-3, "fines_law_passing"), 0.99, 1e-5);
  EXPECT_EQ(table.number(table.rows() - 1, table.column("with_fines_law_passing")), 1.0);
  EXPECT_GT(std::filesystem::file_size(folder().file("fines.png")), 1000U);
  EXPECT_EQ(text_of(folder().file("sieve.csv")), simulated);
  for (const auto& [key, value] : before.items()) EXPECT_EQ(keys[key], value) << key;
}

TEST_F(FinesOfABench, AreTakenAwayWhenTheyAreNotAskedFor) {
  report_fragments(folder(), {kCube, 0.125}, within(10.0));
  report_fragments(folder(), {kCube, 0.125}, {});
  EXPECT_FALSE(std::filesystem::exists(folder().file("fines.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder().file("fines.png")));
  EXPECT_FALSE(summary().contains("fines_law_mass_kg"));
}

TEST_F(FinesOfABench, NeedChargesAndTheirHoles) {
  const auto error = [&] {
    return input_error_of([&] { report_fragments(folder(), {kCube, 0.125}, within(3.0)); });
  };
  write_text(temporary_.path() / "dump" / "scene.json", "{\"case\": \"other\"}\n");
  EXPECT_NE(error().find("fragments: --fines: the run has no charges"), std::string::npos);
  const std::filesystem::path run = temporary_.path() / "dump" / "run.json";
  write_text(run,
             R"({"holes": [{"toe_m": [-5, 0, -1], "collar_m": [-5, 0, 8], "radius_m": 0.15}],)" +
                 text_of(run).substr(1));
  EXPECT_NE(error().find("scene.json has no hole_diameter_m"), std::string::npos) << error();
}

}  // namespace
}  // namespace muckpile
