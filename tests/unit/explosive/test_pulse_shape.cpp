// SPDX-License-Identifier: GPL-2.0-or-later
// Pulse shapes beside Starfield-Pugliese's, which test_blast_load.cpp has.
// Scope: hand-worked values, peaks, bounds, refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "explosive/pulse_shape.h"
#include "input_error_of.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

using Kind = PulseParameters::Kind;
constexpr double kRise = 1e-4;  // [s]

const PulseParameters kTable{
    .kind = Kind::table, .table = {{0, 0}, {5e-5, 0.6}, {7e-5, 0.3}, {kRise, 0.8}, {4e-4, 0.0}}};

std::vector<PulseParameters> all_kinds() {
  return {{.kind = Kind::starfield, .rise_time = kRise},
          {.kind = Kind::duvall, .rise_time = kRise, .ratio = 20.0},
          {.kind = Kind::triangular, .rise_time = kRise, .end_time = 6e-4},
          {.kind = Kind::itasca, .rise_time = kRise, .half_time = 2e-4},
          kTable};
}

TEST(PulseShape, AllKindsHasEachKindThatAUserCanName) {
  const std::vector<PulseParameters> tested = all_kinds();
  for (const auto& [name, kind] : pulse_kinds())
    EXPECT_EQ(std::ranges::count(tested, kind, &PulseParameters::kind), 1) << name;
}

TEST(PulseShape, DuvallOfRatioTwoIsStarfieldPugliese) {
  const DuvallPulse duvall(kRise, 2.0);
  const StarfieldPulse starfield(kRise);
  for (const double t : {0.2 * kRise, kRise, 4.0 * kRise}) {
    EXPECT_NEAR(duvall.shape(t), starfield.shape(t), 1e-14);  // rounding of exponentials
  }
}

TEST(PulseShape, DuvallPeaksAtOneAtTheRiseTimeWhateverTheRatio) {
  for (const double ratio : {1.5, 5.0, 50.0}) {
    const DuvallPulse pulse(kRise, ratio);
    EXPECT_NEAR(pulse.shape(kRise), 1.0, 1e-14) << ratio;
    EXPECT_LT(pulse.shape(0.99 * kRise), 1.0);
    EXPECT_LT(pulse.shape(1.01 * kRise), 1.0);
  }
}

TEST(PulseShape, TriangleIsStraightUpAndDown) {
  const TrianglePulse pulse{kRise, 6e-4};
  EXPECT_DOUBLE_EQ(pulse.shape(0.25 * kRise), 0.25);
  EXPECT_DOUBLE_EQ(pulse.shape(3.5e-4), 0.5);  // halfway from 1e-4 to 6e-4
  EXPECT_EQ(pulse.shape(6e-4), 0.0);
  EXPECT_EQ(pulse.shape(-1.0), 0.0);
}

TEST(PulseShape, ItascaHalvesEveryHalfTime) {
  const ItascaPulse pulse{kRise, 2e-4};
  EXPECT_DOUBLE_EQ(pulse.shape(0.5 * kRise), 0.5);
  EXPECT_DOUBLE_EQ(pulse.shape(kRise + 2e-4), 0.5);
  EXPECT_DOUBLE_EQ(pulse.shape(kRise + 4e-4), 0.25);
}

TEST(PulseShape, EveryKindPeaksAtItsRiseTimeAndItsBoundHolds) {
  for (const PulseParameters& parameters : all_kinds()) {
    const PulseShape pulse(parameters);
    EXPECT_DOUBLE_EQ(pulse.rise_time(), kRise);
    EXPECT_EQ(pulse.ramp(kRise), 1.0);
    EXPECT_EQ(pulse.shape(0.0), 0.0);
    const double peak = pulse.shape(kRise);
    double before = 0.0;
    for (double t = 0.0; t < 8e-4; t += 1e-6) {
      EXPECT_LE(pulse.shape(t), peak + 1e-14);
      EXPECT_GE(pulse.ramp(t), before - 1e-14);  // the gas is switched on, never off
      before = pulse.ramp(t);
      for (double later = t; later < 8e-4; later += 5e-5) {
        ASSERT_LE(pulse.shape(later), pulse.bound(t) + 1e-14);
      }
    }
  }
}

TEST(PulseShape, TableIsStraightBetweenItsRows) {
  const PulseShape pulse(kTable);
  EXPECT_DOUBLE_EQ(pulse.shape(2.5e-5), 0.3);
  EXPECT_DOUBLE_EQ(pulse.shape(2.5e-4), 0.4);
  EXPECT_EQ(pulse.shape(5e-4), 0.0);
  EXPECT_DOUBLE_EQ(pulse.ramp(7e-5), 0.75);  // 0.6 so far, of 0.8
}

TEST(PulseShape, EveryKindEnds) {
  for (const PulseParameters& parameters : all_kinds()) {
    const PulseShape pulse(parameters);
    const double end = pulse.end(0.01);
    EXPECT_LE(pulse.bound(end), 0.01);
    EXPECT_GT(pulse.bound(0.999 * end), 0.01);
  }
}

TEST(PulseShape, EndsWhereAShareOfThePeakIsToCome) {
  // straight down from 1e-4 to 6e-4 s: a tenth is left a tenth of that before the end
  EXPECT_NEAR(PulseShape({.kind = Kind::triangular, .rise_time = kRise, .end_time = 6e-4}).end(0.1),
              5.5e-4, 1e-12);
  // 2^-3 = 1/8 three half times after the peak
  EXPECT_NEAR(PulseShape({.kind = Kind::itasca, .rise_time = kRise, .half_time = 2e-4}).end(0.125),
              7e-4, 1e-12);
  // straight down from 0.8 at 1e-4 to 0 at 4e-4 s
  EXPECT_NEAR(PulseShape(kTable).end(0.2), 3.25e-4, 1e-12);
}

TEST(PulseShape, ReadsATableAndNamesItsFaults) {
  const testing::TemporaryFolder folder;
  const auto table_file = [&](const std::string& text) {
    return testing::write_text(folder.path() / "pulse.csv", text);
  };
  EXPECT_EQ(read_pulse_table(table_file("time_s,share\n0,0\n1e-4,1\n3e-4,0\n")).size(), 3u);
  const auto fault = [&](const std::string& text) {
    const std::string message =
        input_error_of([&] { (void)read_pulse_table(table_file("time_s,share\n" + text)); });
    return message.substr(message.find(".csv") + 4);
  };
  EXPECT_EQ(fault("0,0\n0,1\n1,0\n"), ":3: time_s must grow from 0 s on, got '0'");
  EXPECT_EQ(fault("0,0\n1,-1\n2,0\n"), ":3: share must be >= 0, got '-1'");
  const std::string whole = ": needs two or more rows, a share above 0 and a last share of 0";
  EXPECT_EQ(fault("0,0\n1,1\n"), whole);
  EXPECT_EQ(fault("0,0\n1,0\n"), whole);
}

TEST(PulseShape, RefusesWhatItsKindCannotUse) {
  const auto refused = [](const PulseParameters& parameters) {
    EXPECT_THROW(PulseShape{parameters}, InputError);
  };
  refused({.kind = Kind::duvall, .rise_time = kRise, .ratio = 1.0});
  refused({.kind = Kind::duvall, .rise_time = 0.0});
  refused({.kind = Kind::triangular, .rise_time = kRise, .end_time = kRise});
  refused({.kind = Kind::itasca, .rise_time = kRise, .half_time = 0.0});
}

}  // namespace
}  // namespace muckpile
