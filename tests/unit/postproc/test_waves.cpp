// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command waves: fit and confidence worked by hand, charges within 8 ms, formulas, files.
// Scope: made-up gauges of a made-up bench.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "input_error_of.h"
#include "io/fired_charges.h"
#include "io/gauges_file.h"
#include "measure/blast_formulas.h"
#include "measure/power_fit.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

TEST(PowerFit, StudentsTIsThatOfTheTables) {
  EXPECT_NEAR(student_two_sided_95(1), 12.706, 5e-4);
  EXPECT_NEAR(student_two_sided_95(2), 4.303, 5e-4);
  EXPECT_NEAR(student_two_sided_95(3), 3.182, 5e-4);
  EXPECT_NEAR(student_two_sided_95(5), 2.571, 5e-4);
  EXPECT_NEAR(student_two_sided_95(10), 2.228, 5e-4);
  EXPECT_NEAR(student_two_sided_95(100), 1.984, 5e-4);
}

// log10 x = 0, 1, 2 and log10 y = 1.0, 0.2, -1.2. Means 1 and 0; Sxx = 2, Sxy = -1.0 - 1.2 = -2.2,
// so n = 1.1, log10 K = 1.1. Residuals -0.1, 0.2, -0.1: their squares sum to 0.06, one degree of
// freedom, s = sqrt(0.06) = 0.244949, t = 12.7062. Syy = 1 + 0.04 + 1.44 = 2.48.
TEST(PowerFit, IsThatWorkedByHand) {
  const auto fit =
      fit_decay_law({{1.0, 10.0}, {10.0, std::pow(10.0, 0.2)}, {100.0, std::pow(10.0, -1.2)}});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->exponent, 1.1, 1e-12);
  EXPECT_NEAR(fit->factor, 12.5893, 1e-4);
  const double reach = 12.7062 * 0.244949 / std::sqrt(2.0);  // t s / sqrt(Sxx) = 2.20078
  EXPECT_NEAR(fit->exponent_range.low, 1.1 - reach, 1e-4);
  EXPECT_NEAR(fit->exponent_range.high, 1.1 + reach, 1e-4);
  const double start = 12.7062 * 0.244949 * std::sqrt(1.0 / 3.0 + 1.0 / 2.0);  // 2.84119
  EXPECT_NEAR(std::log10(fit->factor_range.high), 1.1 + start, 1e-4);
  EXPECT_NEAR(std::log10(fit->factor_range.low), 1.1 - start, 1e-4);
  EXPECT_NEAR(fit->r_squared, 1.0 - 0.06 / 2.48, 1e-12);
  EXPECT_NEAR(fit->at(10.0), 1.0, 1e-12);                               // 10^(1.1 - 1.1)
  const double band = 12.7062 * 0.244949 * std::sqrt(1.0 + 1.0 / 3.0);  // 3.59386 at the mean
  EXPECT_NEAR(std::log10(fit->band(10.0).high), band, 1e-4);
  EXPECT_NEAR(std::log10(fit->band(10.0).low), -band, 1e-4);
}

TEST(PowerFit, NeedsThreePointsAtDifferentPlaces) {
  EXPECT_FALSE(fit_decay_law({{1.0, 2.0}, {2.0, 1.0}}));
  EXPECT_FALSE(fit_decay_law({{2.0, 2.0}, {2.0, 1.0}, {2.0, 3.0}}));
}

TEST(FiredCharges, WithinAWindowAreAddedUp) {
  std::vector<FiredCharge> charges;
  for (const auto& [mass, time] : {std::pair(40.0, 0.017), std::pair(10.0, 0.0),
                                   std::pair(30.0, 0.008), std::pair(20.0, 0.005)})
    charges.push_back({Vec3::Zero(), Vec3::UnitZ(), mass, time});
  EXPECT_DOUBLE_EQ(largest_mass_within(charges, 8e-3),
                   50.0);  // at 5 and 8 ms, not those at 0 and 8
  EXPECT_DOUBLE_EQ(largest_mass_within(charges, 1.0), 100.0);
}

TEST(FiredCharges, DistanceIsThatFromTheNearestAxis) {
  const std::vector<FiredCharge> charges = {{{0, 0, 0}, {0, 0, 2}, 1.0, 0.0},
                                            {{100, 0, 0}, {100, 0, 2}, 1.0, 0.0}};
  EXPECT_DOUBLE_EQ(distance_to_charges({3, 0, 1}, charges), 3.0);
  EXPECT_DOUBLE_EQ(distance_to_charges({3, 0, 6}, charges), 5.0);  // 3, 4, 5 from its upper end
  EXPECT_DOUBLE_EQ(distance_to_charges({100, 2, 1}, charges), 2.0);
}

TEST(FiredCharges, OfAHoleTableHaveItsMassesAndTimes) {
  TemporaryFolder temporary;
  write_bench(temporary.path());
  write_text(temporary.path() / "dump/holes.csv",
             "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,"
             "explosive,in_hole_delay_s\n"
             "a,-5,0,10.5,-5,0,-0.5,0.15,7,11,anfo,0.025\n");
  const auto charges = fired_charges(ResultFolder(temporary.path()));
  ASSERT_EQ(charges.size(), 1U);
  EXPECT_NEAR(charges[0].mass / (0.25 * M_PI * 0.15 * 0.15 * 4.0), 850.0, 60.0);  // ANFO's density
  EXPECT_DOUBLE_EQ(charges[0].firing_time, 0.025);
}

TEST(BlastFormulas, VibrationIsThatOfTheBureauOfMines) {
  // 10 ft/lb^0.5: 234 x 10^-1.62 = 234 x 0.0239883 = 5.61327 in/s = 0.142577 m/s.
  EXPECT_NEAR(bureau_of_mines_ppv(10.0 * 0.3048 / std::sqrt(0.45359237)), 0.142577, 1e-6);
}

// Gauges at 1, 2, 4 and 8 m behind the hole of the bench at x = -5; their speed is
// 3 (R/sqrt(W))^-1.5 at 2 ms, half of it before and after, and larger when the rock flies, later.
class Waves : public ::testing::Test {
 protected:
  static constexpr double kMass = 64.0;  // [kg]
  static double speed(double distance) { return 3.0 * std::pow(distance / 8.0, -1.5); }

  void SetUp() override {
    write_bench(temporary_.path());
    const auto scene = temporary_.path() / "dump/scene.json";
    std::string text = text_of(scene);
    write_text(scene, text.insert(1, "\"charge_mass_kg\": 64.0, "));
    write_gauges("");
  }
  static int block(int gauge) { return 6 + gauge; }
  void write_gauges(const std::string& more) {
    std::ostringstream out;
    out.precision(12);
    out << "step,time_s,gauge,block,x_m,y_m,z_m,ux_m,uy_m,uz_m,vx_m_s,vy_m_s,vz_m_s,sxx_Pa,syy_Pa,"
           "szz_Pa,sxy_Pa,syz_Pa,szx_Pa,pressure_Pa,run_id\n";
    const double shares[] = {0.0, 0.5, 1.0, 0.5, 20.0};
    for (int k = 0; k < 5; ++k) {
      for (int g = 1; g <= 4; ++g) {
        const double distance = std::pow(2.0, g - 1);
        out << 10 * k << ',' << (k < 4 ? 1e-3 * k : 0.5) << ',' << g << ',' << block(g) << ','
            << -5.0 - distance << ",0,4,0,0,0," << 0.6 * shares[k] * speed(distance) << ",0,"
            << 0.8 * shares[k] * speed(distance) << ",0,0,0,0,0,0," << 1e6 * shares[k] << ",\n";
      }
    }
    write_text(temporary_.path() / "dump/gauges.csv", out.str() + more);
  }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] nlohmann::ordered_json summary() const {
    return read_json_object(folder().file("summary.json"));
  }
  TemporaryFolder temporary_;
};

TEST_F(Waves, FindTheLawOfTheirGauges) {
  report_waves(folder());
  const auto keys = summary();
  EXPECT_NEAR(keys["ppv_fit_K_m_s"], 3.0, 1e-9);
  EXPECT_NEAR(keys["ppv_fit_n"], 1.5, 1e-9);
  EXPECT_NEAR(keys["ppv_fit_n_low"], 1.5, 1e-6);
  EXPECT_NEAR(keys["ppv_fit_r_squared"], 1.0, 1e-9);
  EXPECT_EQ(keys["largest_charge_within_8_ms_kg"], kMass);
  EXPECT_EQ(keys["gauges"], 4);
  EXPECT_NEAR(keys["ppv_largest_m_s"], speed(1.0), 1e-9);
  for (const char* file : {"waves.png", "ppv.png", "waves.csv"})
    EXPECT_GT(std::filesystem::file_size(folder().file(file)), 200U) << file;
}

TEST_F(Waves, TablesTellEachGauge) {
  report_waves(folder());
  const CsvTable table = CsvTable::read(folder().file("ppv.csv"));
  ASSERT_EQ(table.rows(), 4U);
  const auto of = [&](size_t row, const char* name) {
    return table.number(row, table.column(name));
  };
  EXPECT_NEAR(of(2, "distance_m"), 4.0, 1e-5);
  EXPECT_NEAR(of(2, "scaled_distance_m_kg05"), 0.5, 1e-5);
  EXPECT_NEAR(of(2, "ppv_m_s"), speed(4.0), 1e-4);
  EXPECT_NEAR(of(2, "ppv_time_s"), 2e-3, 1e-9);
  EXPECT_NEAR(of(2, "arrival_s"), 1e-3, 1e-9);
  EXPECT_NEAR(of(2, "largest_pressure_Pa"), 1e6, 1.0);
  EXPECT_NEAR(of(2, "fit_m_s"), speed(4.0), 1e-4);
  EXPECT_EQ(CsvTable::read(folder().file("waves.csv")).rows(), 16U);  // without the flight
}

// [-3 1 0; 1 -1 0; 0 0 1] MPa, tension positive: -2 -+ sqrt(1 + 1) and 1. So compressions of
// 2 + sqrt(2), 2 - sqrt(2) and -1, whose mean is the pressure of 1 MPa; half of it before.
TEST_F(Waves, StressesArePrincipalOnes) {
  std::ostringstream out;
  out << "step,time_s,gauge,block,x_m,y_m,z_m,ux_m,uy_m,uz_m,vx_m_s,vy_m_s,vz_m_s,sxx_Pa,syy_Pa,"
         "szz_Pa,sxy_Pa,syz_Pa,szx_Pa,pressure_Pa,run_id\n";
  for (const double share : {0.0, 0.5, 1.0})
    out << 10 * share << ',' << 1e-3 * share << ",1,7,-6,0,4,0,0,0," << share << ",0,0,"
        << -3e6 * share << ',' << -1e6 * share << ',' << 1e6 * share << ',' << 1e6 * share
        << ",0,0," << 1e6 * share << ",\n";
  write_text(temporary_.path() / "dump/gauges.csv", out.str());
  report_waves(folder());
  const CsvTable waves = CsvTable::read(folder().file("waves.csv"));
  const double principal[] = {2e6 + std::sqrt(2.0) * 1e6, 2e6 - std::sqrt(2.0) * 1e6, -1e6};
  for (size_t k = 0; k < 3; ++k) {
    const size_t column = waves.column(std::string{'s', static_cast<char>('1' + k)} + "_Pa");
    EXPECT_EQ(waves.number(0, column), 0.0);
    EXPECT_NEAR(waves.number(1, column) / (0.5 * principal[k]), 1.0, 1e-5);
    EXPECT_NEAR(waves.number(2, column) / principal[k], 1.0, 1e-5);
  }
  const CsvTable peaks = CsvTable::read(folder().file("ppv.csv"));
  EXPECT_NEAR(peaks.number(0, peaks.column("largest_compression_Pa")) / principal[0], 1.0, 1e-5);
  EXPECT_NEAR(peaks.number(0, peaks.column("largest_tension_Pa")), 1e6, 10.0);
}

// Two gauges at 8 m in one block: the fit has four points as before, with t of two degrees of
// freedom. The same gauge in a block of its own would be a fifth.
TEST_F(Waves, GaugesOfOneBlockAreOnePoint) {
  std::ostringstream more;
  more.precision(12);
  for (const double share : {0.0, 1.0})
    more << "20," << 2e-3 * share << ",5,10,-13,0,4.5,0,0,0," << share * speed(8.0)
         << ",0,0,0,0,0,0,0,0,0,\n";
  write_gauges(more.str());
  report_waves(folder());
  EXPECT_EQ(summary()["gauges"], 5);
  EXPECT_EQ(summary()["ppv_fit_blocks"], 4);
  EXPECT_NEAR(summary()["ppv_fit_n"], 1.5, 1e-9);
}

TEST_F(Waves, GoOnForAsLongAsAsked) {
  report_waves(folder(), {"gauges.csv", 1.0});
  EXPECT_NEAR(summary()["ppv_largest_m_s"], 20.0 * speed(1.0), 1e-6);
}

TEST_F(Waves, WithoutASampleInTimeLeaveNoFigures) {
  report_waves(folder());
  EXPECT_THROW(report_waves(folder(), {"gauges.csv", -1.0}), NotMeasurable);
  for (const char* file : {"waves.png", "ppv.png", "waves.csv", "ppv.csv"})
    EXPECT_FALSE(std::filesystem::exists(folder().file(file))) << file;
  EXPECT_FALSE(summary().contains("ppv_fit_n"));
  EXPECT_TRUE(summary().contains("waves_refused"));
  report_waves(folder());
  EXPECT_FALSE(summary().contains("waves_refused"));
}

TEST_F(Waves, RunWithoutGaugesOrMassIsNotMeasured) {
  EXPECT_THROW(report_waves(folder(), {"other.csv", {}}), NotMeasurable);
  write_text(temporary_.path() / "dump/scene.json", "{\"case\": \"heap\"}");
  EXPECT_THROW(report_waves(folder()), NotMeasurable);
}

TEST_F(Waves, FaultyFilesAreRefusedByLine) {
  const auto refused = [&](const std::string& row) {
    write_gauges(row);
    return input_error_of([&] { report_waves(folder()); });
  };
  const std::string rest = ",0,0,0,0,0,0,0,0,0,0,0,0,0,\n";
  EXPECT_NE(
      refused("50,0.6,4,10,-99,0,4" + rest).find("gauges.csv:22: gauge 4 is at another place"),
      std::string::npos);
  EXPECT_NE(refused("50,0.4,4,10,-13,0,4" + rest).find("gauge 4 goes back in time"),
            std::string::npos);
  EXPECT_NE(refused("50,0.6,4,10,-13,0").find("gauges.csv"), std::string::npos);  // cut off
}

TEST_F(Waves, OfAnotherRunAreRefused) {
  const std::string other = "fedcba9876543210";
  write_gauges("50,0.6,4,10,-13,0,4,0,0,0,0,0,0,0,0,0,0,0,0,0," + other + "\n");
  EXPECT_NE(input_error_of([&] { report_waves(folder()); }).find(other), std::string::npos);
}

}  // namespace
}  // namespace muckpile
