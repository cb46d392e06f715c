// SPDX-License-Identifier: GPL-2.0-or-later
// Explosive per window of time, by hand.
// Scope: charge_window, and what charge_design says of a pattern.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "explosive/charge_design.h"
#include "explosive/charge_window.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

TEST(ChargeWindow, SumsWhatFiresWithinItWhereverItBegins) {
  // 0, 7: 3 kg; 7, 9, 14: 2 + 4 + 8; 9, 14, 16: 4 + 8 + 16 kg.
  const std::array<TimedCharge, 5> charges{
      {{0.016, 16.0}, {0.0, 1.0}, {0.007, 2.0}, {0.014, 8.0}, {0.009, 4.0}}};
  EXPECT_DOUBLE_EQ(largest_within(charges, kVibrationWindow), 28.0);
  EXPECT_DOUBLE_EQ(largest_within({}, kVibrationWindow), 0.0);
}

TEST(ChargeWindow, ChargesAWholeWindowApartAreApart) {
  // 3 x 17 ms and 42 + 17 ms, as sums of delays are rounded.
  const std::array<TimedCharge, 2> charges{{{0.017 + 0.017 + 0.017, 5.0}, {0.042 + 0.017, 6.0}}};
  EXPECT_DOUBLE_EQ(largest_within(charges, kVibrationWindow), 6.0);
}

TEST(ChargeWindow, OfAChargeThatIsNotKnownIsNotKnown) {
  const std::array<TimedCharge, 2> charges{{{0.0, 5.0}, {0.1, std::nan("")}}};
  EXPECT_TRUE(std::isnan(largest_within(charges, kVibrationWindow)));
}

TEST(ChargeWindow, MassIsThatOfTheChargeAndNotOfItsChamber) {
  Deck deck;
  deck.diameter = 0.2;
  deck.from = 3.0;
  deck.to = 8.0;
  EXPECT_DOUBLE_EQ(charge_mass(deck, 800.0), std::numbers::pi * 0.01 * 5.0 * 800.0);
  deck.charge_diameter = 0.1;
  deck.charge_length = 4.0;
  EXPECT_DOUBLE_EQ(charge_mass(deck, 800.0), std::numbers::pi * 0.0025 * 4.0 * 800.0);
}

TEST(ChargeWindow, IsPrintedByChargeDesign) {
  testing::TemporaryFolder folder;
  // Two holes 5 ms apart, one of them with a heavier explosive in half of its length.
  const std::string file = testing::write_text(
      folder.path() / "p.csv",
      "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,"
      "explosive,surface_delay_s\n"
      "a,-3,0,10,-3,0,0,0.1,2,10,,0\nb,-3,4,10,-3,4,0,0.1,2,10,tnt,0.005\n"
      "c,-3,8,10,-3,8,0,0.1,2,10,,0.02\n");
  const ChargeDesign design =
      charge_design(parse_args(charge_design_table(), "charge_design",
                               {"explosive", "anfo", "explosive_density", "800", "crushed_ratio",
                                "3", "hole_table", file}),
                    "charge_design");
  const double volume = std::numbers::pi * 0.0025 * 8.0, tnt = 1630.0;
  EXPECT_NEAR(design.pattern_mass, volume * (1600.0 + tnt), 1e-9);
  EXPECT_NEAR(design.window_mass, volume * (800.0 + tnt), 1e-9);
  EXPECT_NE(design.report.find("at most 152.7 kg within 8 ms"), std::string::npos) << design.report;
}

}  // namespace
}  // namespace muckpile
