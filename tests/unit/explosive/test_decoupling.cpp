// SPDX-License-Identifier: GPL-2.0-or-later
// Charges that do not fill their hole: wall pressure and room of the products.
// Scope: the emulsion of the other tests, P0 = 2.784375 GPa, two-stage isentrope.
#include <gtest/gtest.h>

#include <cmath>

#include "args/input_error.h"
#include "explosive/decoupling.h"

namespace muckpile {
namespace {

constexpr double kP0 = 2.784375e9;

ProductExpansion two_stage() {
  return ProductExpansion(TwoStageIsentrope({.initial_pressure = kP0}));
}

ChargeShape shape(double decoupling, double filled = 1.0) {
  return {0.045, 0.045 / decoupling, 9.0, 9.0 * filled};
}

double wall(const ChargeShape& charge, const DecouplingRule& rule = {}) {
  return wall_pressure(kP0, two_stage(), charge, rule);
}

TEST(Decoupling, AFilledHoleFeelsTheFullPressureWhateverTheRule) {
  for (const Coupling coupling : {Coupling::air, Coupling::water, Coupling::stemming}) {
    DecouplingRule rule;
    rule.coupling = coupling;
    rule.impact_factor = 8.0;
    EXPECT_DOUBLE_EQ(wall(shape(1.0), rule), kP0);
    rule.power_law = true;
    EXPECT_DOUBLE_EQ(wall(shape(1.0), rule), kP0);
  }
}

TEST(Decoupling, AirGapFollowsTheTwoStageIsentrope) {
  EXPECT_NEAR(wall(shape(1.25)), 729.9e6, 0.1e6);  // 2784.375/1.25^6
  EXPECT_NEAR(wall(shape(1.5)), 244.4e6, 0.1e6);   // 2784.375/1.5^6
  // beyond V_k/V0 = 2.405648: 200 (2.405648/4)^1.4 = 98.14 MPa
  EXPECT_NEAR(wall(shape(2.0)), 98.14e6, 0.02e6);
}

TEST(Decoupling, PowerLawHasTheUsualSixthAndThirdPowers) {
  DecouplingRule rule;
  rule.power_law = true;
  EXPECT_NEAR(wall(shape(2.0), rule), kP0 / 64.0, 1.0);
  EXPECT_NEAR(wall(shape(1.0, 0.5), rule), kP0 / 8.0, 1.0);
  rule.power_exponent = 1.3;  // Bastante's range: kd = 2 gives 2784.375/4^1.3 = 459 MPa
  EXPECT_NEAR(wall(shape(2.0), rule), kP0 / std::pow(4.0, 1.3), 1.0);
}

TEST(Decoupling, WorkCountsFromTheRoomThatIsFilledWithoutAny) {
  DecouplingRule rule;
  const auto ratio = [&rule](const ChargeShape& charge) {
    return pulse_volume_ratio(wall(charge, rule) / kP0, two_stage(), charge, rule);
  };
  EXPECT_DOUBLE_EQ(ratio(shape(1.0)), 1.0);
  EXPECT_DOUBLE_EQ(ratio(shape(1.5, 0.5)), 4.5);  // 1.5^2 / 0.5
  rule.power_law = true;                          // the sixth power is the isentrope's at 1.5,
  EXPECT_DOUBLE_EQ(ratio(shape(1.5)), 2.25);
  rule.power_exponent = 1.3;  // this one is 970 instead of 244 MPa
  EXPECT_DOUBLE_EQ(ratio(shape(1.5)), 1.0);
  rule = {};
  rule.impact_factor = 8.0;
  EXPECT_DOUBLE_EQ(ratio(shape(1.5)), 1.0);
  rule = {};
  rule.coupling = Coupling::water;  // no room
  EXPECT_DOUBLE_EQ(ratio(shape(1.5)), 1.0);
}

TEST(Decoupling, ImpactFactorRaisesTheWaveBehindAnAirGapOnly) {
  DecouplingRule rule;
  rule.impact_factor = 8.0;
  EXPECT_DOUBLE_EQ(wall(shape(2.0), rule), 8.0 * wall(shape(2.0)));
  rule.coupling = Coupling::water;
  DecouplingRule plain;
  plain.coupling = Coupling::water;
  EXPECT_DOUBLE_EQ(wall(shape(2.0), rule), wall(shape(2.0), plain));
}

TEST(Decoupling, WaterCarriesMoreThanAirAndTakesNoRoom) {
  DecouplingRule rule;
  rule.coupling = Coupling::water;
  EXPECT_NEAR(wall(shape(2.0), rule), kP0 * std::pow(2.0, -0.72), 1.0);
  EXPECT_DOUBLE_EQ(free_volume_ratio(shape(2.0), rule), 1.0);
  EXPECT_DOUBLE_EQ(free_volume_ratio(shape(2.0), {}), 4.0);
}

TEST(Decoupling, AnAirDeckTakesRoomAlongTheHole) {
  DecouplingRule rule;
  EXPECT_DOUBLE_EQ(free_volume_ratio(shape(1.0, 0.75), rule), 4.0 / 3.0);
  EXPECT_NEAR(wall(shape(1.0, 0.75)), kP0 * std::pow(0.75, 3.0), 1.0);
  rule.coupling = Coupling::stemming;
  rule.coupling_exponent = 2.0;
  EXPECT_NEAR(wall(shape(2.0, 0.75), rule), kP0 * std::pow(0.75, 3.0) / 4.0, 1.0);
}

TEST(Decoupling, JwlGasStageStartsWhereItPassesTheSwitchPressure) {
  const JwlParameters tnt{.a = 371.2e9,
                          .b = 3.231e9,
                          .r1 = 4.15,
                          .r2 = 0.95,
                          .omega = 0.3,
                          .cj_pressure = 21e9,
                          .density = 1630,
                          .detonation_velocity = 6930};
  const ProductExpansion jwl(JwlGas(tnt, 200e6));
  EXPECT_NEAR(jwl.pressure(jwl.switch_ratio()), 200e6, 1.0);
  EXPECT_GT(jwl.switch_ratio(), 4.0);
  // p(7 V0) = 3.231 e^-6.65 + 1.04785/7^1.3 = 87.7 MPa: below, JWL has not been fitted
  EXPECT_THROW(JwlGas(tnt, 80e6), InputError);
  EXPECT_DOUBLE_EQ(jwl.gamma(), 1.3);
  // 371.2 e^-4.15/4.15 + 3.231 e^-0.95/0.95 + 1.04785/0.3 = 1.41006 + 1.31533 + 3.49283 GPa
  EXPECT_NEAR(jwl.stored_energy(1.0), 6.21822e9, 1e5);
}

TEST(Decoupling, RefusesAChargeThatDoesNotFit) {
  EXPECT_THROW(check_shape(shape(0.9)), InputError);
  EXPECT_THROW(check_shape(shape(1.0, 1.1)), InputError);
  EXPECT_THROW(check_shape(shape(1.0, 0.0)), InputError);
}

}  // namespace
}  // namespace muckpile
