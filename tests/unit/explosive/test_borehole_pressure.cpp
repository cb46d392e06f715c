// SPDX-License-Identifier: GPL-2.0-or-later
// Borehole pressure, isentrope and attenuation against numbers worked by hand.
// Scope: emulsion 1100 kg/m3, 4500 m/s: rho D^2 = 1100 x 4500^2 = 22.275 GPa.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "args/input_error.h"
#include "explosive/attenuation.h"
#include "explosive/borehole_pressure.h"
#include "explosive/two_stage_isentrope.h"

namespace muckpile {
namespace {

constexpr Explosive kEmulsion{1100.0, 4500.0};
constexpr double kGPa = 1e9;
constexpr double kMPa = 1e6;
constexpr double kRounding = 1e-12;  // a few products and one pow

TEST(BoreholePressure, ChapmanJouguetIsAQuarterOfRhoDSquaredAtGammaThree) {
  EXPECT_NEAR(chapman_jouguet_pressure(kEmulsion), 22.275 / 4.0 * kGPa, kRounding * 5.6 * kGPa);
}

TEST(BoreholePressure, ExplosionStateIsAnEighthOfRhoDSquared) {
  EXPECT_NEAR(explosion_state_pressure(kEmulsion), 2.784375 * kGPa, kRounding * 2.8 * kGPa);
}

TEST(BoreholePressure, ExplosionStateByGammaFollowsTheRatioOfTheProducts) {
  // gamma 2.4: 22.275/3.4 = 6.5515; (2.4/3.4)^2.4 = exp(2.4 x -0.348307) = 0.43347; product 2.83986
  EXPECT_NEAR(explosion_state_pressure_by_gamma(kEmulsion, 2.4), 2.83986 * kGPa, 2e-5 * kGPa);
}

TEST(BoreholePressure, FitGivesThePublishedExamples) {
  // 0.115 x 0.8^0.868 x 16 = 0.115 x 0.82392 x 16 = 1.5160 and 0.115 x 1.4^0.868 x 36 = 5.5443;
  // the source prints 1.5 and 5.5 GPa for ANFO and gelatine
  EXPECT_NEAR(explosion_state_pressure_fit({800.0, 4000.0}), 1.5160 * kGPa, 2e-4 * kGPa);
  EXPECT_NEAR(explosion_state_pressure_fit({1400.0, 6000.0}), 5.544 * kGPa, 1e-3 * kGPa);
}

TEST(BoreholePressure, ImpedanceMatchReflectsTheDetonationWave) {
  // 5.56875 x 2 / (1 + 4.95e6 / 13.5e6) = 11.1375 / 1.366667 = 8.14939
  EXPECT_NEAR(impedance_matched_pressure(kEmulsion, 2700.0 * 5000.0), 8.14939 * kGPa, 1e-5 * kGPa);
}

TEST(BoreholePressure, RefusesAnExplosiveWithoutDensity) {
  EXPECT_THROW((void)explosion_state_pressure({0.0, 4500.0}), InputError);
  EXPECT_THROW((void)explosion_state_pressure({1100.0, -1.0}), InputError);
}

TEST(TwoStageIsentrope, MatchesTheEmulsionTable) {
  const TwoStageIsentrope gas({.initial_pressure = 2.784375e9});
  EXPECT_NEAR(gas.switch_ratio(), 2.4056, 1e-4);  // (2784.375/200)^(1/3) = 13.921875^(1/3)
  // gamma 3: 2784.375/1.5625^3 = 2784.375/3.814697; /2.25^3 = 2784.375/11.390625
  EXPECT_NEAR(gas.pressure(1.5625), 729.91 * kMPa, 0.01 * kMPa);
  EXPECT_NEAR(gas.pressure(2.25), 244.444 * kMPa, 0.001 * kMPa);
  // gamma 1.4: 200 (2.4056/4)^1.4, /9, /16; the dossier's table prints 98, 31, 14
  EXPECT_NEAR(gas.pressure(4.0), 98.15 * kMPa, 0.05 * kMPa);
  EXPECT_NEAR(gas.pressure(9.0), 31.54 * kMPa, 0.05 * kMPa);
  EXPECT_NEAR(gas.pressure(16.0), 14.09 * kMPa, 0.05 * kMPa);
}

TEST(TwoStageIsentrope, IsContinuousWhereTheStagesMeet) {
  const TwoStageIsentrope gas({.initial_pressure = 2.784375e9});
  const double v = gas.switch_ratio();
  EXPECT_NEAR(gas.pressure(v * (1.0 - 1e-9)), 200.0 * kMPa,
              1.0);  // slope 3 x 1e-9 x 200 MPa < 1 Pa
  EXPECT_NEAR(gas.pressure(v * (1.0 + 1e-9)), 200.0 * kMPa, 1.0);
}

TEST(TwoStageIsentrope, WeakChargeStartsOnTheSecondStage) {
  const TwoStageIsentrope gas({.initial_pressure = 100e6});
  EXPECT_EQ(gas.switch_ratio(), 1.0);
  EXPECT_EQ(gas.switch_pressure(), 100e6);
  EXPECT_NEAR(gas.pressure(2.0), 100e6 / 2.6390158, 1.0);  // 2^1.4 = 2.6390158
}

TEST(TwoStageIsentrope, NeverExceedsTheExplosionState) {
  const TwoStageIsentrope gas({.initial_pressure = 2.784375e9});
  EXPECT_EQ(gas.pressure(0.5), 2.784375e9);
  EXPECT_EQ(gas.pressure(1.0), 2.784375e9);
}

TEST(TwoStageIsentrope, WorkAndStoredEnergyAreTheIntegralOfThePressure) {
  const TwoStageIsentrope gas({.initial_pressure = 2.784375e9});
  // By hand: 2784.375/2 (1 - 1/5.787085) + 200 x 2.405636/0.4 = 1151.62 + 1202.82 [MJ/m3].
  EXPECT_NEAR(gas.stored_energy(1.0), 2354.44e6, 0.02e6);
  EXPECT_EQ(gas.work_down_to(2.784375e9), 0.0);
  const double end = 60.0;
  double work = 0.0;  // trapezoidal rule in the logarithm of the volume
  constexpr int kParts = 200000;
  const double part = std::log(end) / kParts;
  for (int k = 0; k < kParts; ++k) {
    const double from = std::exp(k * part), to = std::exp((k + 1) * part);
    work += 0.5 * (gas.pressure(from) + gas.pressure(to)) * (to - from);
  }
  const double error = std::abs(gas.work_down_to(gas.pressure(end)) / work - 1.0);
  std::cout << "relative error of the work " << error << '\n';
  EXPECT_LT(error, 1e-7);  // square of the parts' length, 2e-5, over 12, and the kink
}

TEST(EnergySwitchPressure, ProductsHoldTheEnergyThatIsAskedFor) {
  const double vod = 4500.0;
  for (const double density : {700.0, 1100.0, 1400.0}) {
    for (const double share : {0.75, 1.0}) {
      const double energy = share * 3.0e6 * density;
      TwoStageIsentrope::Parameters p{.initial_pressure = density * vod * vod / 8.0};
      p.switch_pressure = energy_switch_pressure(p, energy);
      EXPECT_NEAR(TwoStageIsentrope(p).stored_energy(1.0), energy, 1e-9 * energy);
    }
  }
}

// E0 = 3.3e9 J/m3, P0 = 2.784375e9 Pa: y = (1.185185 - 0.5)/(2.5 - 0.5) = 0.342593,
// p_k = P0 y^1.5 = 2784.375 x 0.200523 MPa.
TEST(EnergySwitchPressure, MatchesTheEmulsionWorkedByHand) {
  EXPECT_NEAR(energy_switch_pressure({.initial_pressure = 2.784375e9}, 3.3e9), 558.33e6, 0.05e6);
}

TEST(EnergySwitchPressure, HalfTheDensityHalvesThePressureAtEveryVolume) {
  TwoStageIsentrope::Parameters dense{.initial_pressure = 2.0e9}, thin{.initial_pressure = 1.0e9};
  dense.switch_pressure = energy_switch_pressure(dense, 2.4e9);
  thin.switch_pressure = energy_switch_pressure(thin, 1.2e9);
  const TwoStageIsentrope a(dense), b(thin);
  for (const double ratio : {1.0, 1.3, 2.0, 5.0, 20.0})
    EXPECT_NEAR(b.pressure(ratio), 0.5 * a.pressure(ratio), 1e-9 * a.pressure(ratio));
}

TEST(TwoStageIsentrope, RefusesPressuresAndExponentsThatAreNotPositive) {
  const auto refused = [](const TwoStageIsentrope::Parameters& p) {
    EXPECT_THROW(TwoStageIsentrope{p}, InputError);
  };
  refused({.initial_pressure = 0.0});
  refused({.initial_pressure = 2e9, .switch_pressure = 0.0});
  refused({.initial_pressure = 2e9, .dense_exponent = 0.0});
  refused({.initial_pressure = 2e9, .dilute_exponent = -1.0});
}

TEST(EnergySwitchPressure, RefusesEnergiesThatThePressureCannotHave) {
  EXPECT_THROW((void)energy_switch_pressure({.initial_pressure = 2e9}, 0.99e9), InputError);
  EXPECT_THROW((void)energy_switch_pressure({.initial_pressure = 2e9}, 5.01e9), InputError);
  EXPECT_NO_THROW((void)energy_switch_pressure({.initial_pressure = 2e9}, 4.99e9));
  EXPECT_THROW((void)energy_switch_pressure({.initial_pressure = 2e9, .dilute_exponent = 3.5}, 2e9),
               InputError);
}

TEST(Attenuation, ExponentInCrushedRock) {
  EXPECT_NEAR(crushed_zone_exponent(0.22), 2.0 + 0.22 / 0.78, kRounding);
  EXPECT_THROW((void)crushed_zone_exponent(0.5), InputError);
  EXPECT_THROW((void)crushed_zone_exponent(-0.1), InputError);
}

TEST(Attenuation, EmulsionAtThreeHoleRadii) {
  // 3^-2.282051 = exp(-2.282051 x 1.098612) = 0.081505; x 2784.375 = 226.94, the dossier's 227 MPa
  const double alpha = crushed_zone_exponent(0.22);
  EXPECT_NEAR(attenuated_pressure(2.784375e9, 0.045, 0.135, alpha), 226.9 * kMPa, 0.1 * kMPa);
  // and its row alpha = 1.49: 543, 3^-1.49 = 0.194574 -> 541.8
  EXPECT_NEAR(attenuated_pressure(2.784375e9, 0.045, 0.135, 1.49), 541.8 * kMPa, 0.2 * kMPa);
}

TEST(Attenuation, RefusesACrushedZoneInsideTheHole) {
  EXPECT_THROW((void)attenuated_pressure(1e9, 0.045, 0.040, 2.0), InputError);
}

}  // namespace
}  // namespace muckpile
