// SPDX-License-Identifier: GPL-2.0-or-later
// Flow along one rough crack against numbers worked by hand and its limits.
// Scope: the flow law alone.
#include <gtest/gtest.h>

#include <cmath>

#include "args/input_error.h"
#include "explosive/gas_vent.h"
#include "gas/crack_flow.h"

namespace muckpile {
namespace {

constexpr GasPoint kGas{200e6, 456.0};  // emulsion where the gas stage starts

/// Into gas at a lower pressure on the same isentrope.
double flux(const CrackFlow& flow, double downstream_pressure, double aperture, double length) {
  return flow.flux(flow.head(kGas), flow.head({downstream_pressure, 0.0}),
                   flow.passage(aperture, length));
}

TEST(CrackFlow, FrictionIsThatOfARoughWall) {
  const CrackFlow flow({.gamma = 1.4, .roughness = 1e-4});
  EXPECT_NEAR(flow.friction_factor(1e-4), 0.143, 1e-15);
  EXPECT_NEAR(flow.friction_factor(8e-4), 0.0715, 1e-15);  // (1/8)^(1/3) = 1/2
}

TEST(CrackFlow, SmallDropIsDarcyWeisbach) {
  // rho v = sqrt(2 rho dp/(1 + f L/(2w))): sqrt(2 x 456 x 2e5/(1 + 0.143 x 0.25/2e-4))
  // = sqrt(1.824e8/179.75) = 1007.34 kg/(m2 s); the drop of 0.1 % changes rho by 0.04 % on average
  const CrackFlow flow({.gamma = 1.4, .roughness = 1e-4});
  EXPECT_NEAR(flux(flow, 200e6 - 2e5, 1e-4, 0.25), 1007.34, 0.5);
}

TEST(CrackFlow, LargeDropFollowsTheIsentrope) {
  // into nothing: sqrt(2 x 1.4/2.4 x 200e6 x 456/179.75) = sqrt(5.91933e8) = 24329.7 kg/(m2 s)
  const CrackFlow flow({.gamma = 1.4, .roughness = 1e-4});
  EXPECT_NEAR(flux(flow, 0.0, 1e-4, 0.25), 24329.7, 0.5);
  // to half the pressure: 1 - 0.5^(2.4/1.4) = 0.695233, its root 0.833806
  EXPECT_NEAR(flux(flow, 100e6, 1e-4, 0.25), 24329.7 * 0.833806, 0.5);
}

TEST(CrackFlow, WideCrackIsChoked) {
  const CrackFlow flow({.gamma = 1.4, .roughness = 1e-4});
  const double choked = choked_flux(kGas.pressure, kGas.density, 1.4);
  EXPECT_DOUBLE_EQ(flux(flow, 0.0, 1.0, 0.25), choked);
  EXPECT_DOUBLE_EQ(flux(flow, 50e6, 1.0, 0.25), choked);
  EXPECT_LT(flux(flow, 190e6, 1.0, 0.25), choked);
  EXPECT_LT(flux(flow, 0.0, 1e-3, 0.25), choked);
}

TEST(CrackFlow, NothingFlowsUphill) {
  const CrackFlow flow({});
  EXPECT_EQ(flux(flow, 200e6, 1e-3, 0.25), 0.0);
  EXPECT_EQ(flux(flow, 300e6, 1e-3, 0.25), 0.0);
}

TEST(CrackFlow, PassageIsThatOfTheFrictionFactor) {
  const CrackFlow flow({.gamma = 1.4, .roughness = 1e-4});
  for (double aperture = 1e-6; aperture < 1.0; aperture *= 3.7) {
    const double resistance = 1.0 + flow.friction_factor(aperture) * 0.3 / (2.0 * aperture);
    EXPECT_NEAR(flow.passage(aperture, 0.3) * std::sqrt(resistance), 1.0, 1e-14) << aperture;
  }
}

TEST(CrackFlow, RefusesWhatIsNoGas) {
  EXPECT_THROW(CrackFlow({.gamma = 1.0}), InputError);
  EXPECT_THROW(CrackFlow({.gamma = 1.4, .roughness = -1e-4}), InputError);
}

}  // namespace
}  // namespace muckpile
