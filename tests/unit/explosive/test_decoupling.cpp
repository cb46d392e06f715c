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

const DecouplingRule kIsentrope{.air_gap = AirGap::isentrope};

double wall(const ChargeShape& charge, const DecouplingRule& rule = kIsentrope) {
  return wall_pressure(kP0, two_stage(), charge, rule);
}

TEST(Decoupling, AFilledHoleFeelsTheFullPressureWhateverTheRule) {
  for (const Coupling coupling : {Coupling::air, Coupling::water, Coupling::stemming}) {
    DecouplingRule rule;
    rule.coupling = coupling;
    rule.impact_factor = 8.0;
    EXPECT_DOUBLE_EQ(wall(shape(1.0), rule), kP0);
    rule.air_gap = AirGap::power;
    EXPECT_DOUBLE_EQ(wall(shape(1.0), rule), kP0);
  }
}

TEST(Decoupling, AirGapFollowsTheTwoStageIsentrope) {
  EXPECT_NEAR(wall(shape(1.25)), 729.9e6, 0.1e6);  // 2784.375/1.25^6
  EXPECT_NEAR(wall(shape(1.5)), 244.4e6, 0.1e6);   // 2784.375/1.5^6
  // beyond V_k/V0 = 2.405648: 200 (2.405648/4)^1.4 = 98.14 MPa
  EXPECT_NEAR(wall(shape(2.0)), 98.14e6, 0.02e6);
}

TEST(Decoupling, ProductsThatFillAnAirGapWithoutWorkKeepTheirEnergy) {
  // 3.3 GJ/m3 in the emulsion's products: b = 1 - 0.4 x 3.3/2.784375 = 0.525926. In 4 V0 they press
  // 0.4 x 3.3 GPa/(4 - 0.525926) = 379.95 MPa, in 2 V0 0.4 x 3.3/(2 - 0.525926) = 895.48 MPa.
  const ProductExpansion products(CovolumeIsentrope({.initial_pressure = kP0, .energy = 3.3e9}));
  EXPECT_NEAR(wall_pressure(kP0, products, shape(2.0), {}), 379.95e6, 0.01e6);
  EXPECT_NEAR(wall_pressure(kP0, products, shape(1.0, 0.5), {}), 895.48e6, 0.01e6);
  for (const ProductExpansion& law : {products, two_stage()}) {
    for (const ChargeShape& charge : {shape(1.3), shape(2.0), shape(1.0, 0.5), shape(1.5, 0.4)}) {
      const double room = free_volume_ratio(charge, {});
      const ProductExpansion inside = products_in_chamber(law, charge, {});
      EXPECT_NEAR(inside.energy(), law.energy(), 1e-12 * law.energy());
      EXPECT_NEAR(inside.stored_energy(room), law.energy(), 1e-12 * law.energy());
      EXPECT_GT(inside.pressure(room), law.pressure(room));
      EXPECT_LT(inside.pressure(room), law.pressure(1.0));
      EXPECT_DOUBLE_EQ(
          pulse_volume_ratio(wall_pressure(kP0, law, charge, {}) / kP0, law, charge, {}), room);
    }
  }
}

TEST(Decoupling, PowerLawHasTheUsualSixthAndThirdPowers) {
  DecouplingRule rule;
  rule.air_gap = AirGap::power;
  EXPECT_NEAR(wall(shape(2.0), rule), kP0 / 64.0, 1.0);
  EXPECT_NEAR(wall(shape(1.0, 0.5), rule), kP0 / 8.0, 1.0);
  rule.power_exponent = 1.3;  // Bastante's range: kd = 2 gives 2784.375/4^1.3 = 459 MPa
  EXPECT_NEAR(wall(shape(2.0), rule), kP0 / std::pow(4.0, 1.3), 1.0);
}

TEST(Decoupling, WorkCountsFromTheRoomThatIsFilledWithoutAny) {
  DecouplingRule rule = kIsentrope;
  const auto ratio = [&rule](const ChargeShape& charge) {
    return pulse_volume_ratio(wall(charge, rule) / kP0, two_stage(), charge, rule);
  };
  EXPECT_DOUBLE_EQ(ratio(shape(1.0)), 1.0);
  EXPECT_DOUBLE_EQ(ratio(shape(1.5, 0.5)), 4.5);  // 1.5^2 / 0.5
  rule.air_gap = AirGap::power;                   // the sixth power is the isentrope's at 1.5,
  EXPECT_DOUBLE_EQ(ratio(shape(1.5)), 2.25);
  rule.power_exponent = 1.3;  // this one is 970 instead of 244 MPa
  EXPECT_DOUBLE_EQ(ratio(shape(1.5)), 1.0);
  rule = kIsentrope;
  rule.impact_factor = 8.0;
  EXPECT_DOUBLE_EQ(ratio(shape(1.5)), 1.0);
  rule = {};
  rule.coupling = Coupling::water;  // no room
  EXPECT_DOUBLE_EQ(ratio(shape(1.5)), 1.0);
}

TEST(Decoupling, ImpactFactorRaisesTheWaveBehindAnAirGapOnly) {
  DecouplingRule rule = kIsentrope;
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
  DecouplingRule rule = kIsentrope;
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
