// SPDX-License-Identifier: GPL-2.0-or-later
// Crushed-zone radii against numbers worked by hand.
// Scope: emulsion 1100 kg/m3, 4500 m/s in rock of 2700 kg/m3, c_p 5000 m/s, nu 0.22, 100 and 8 MPa.
#include <gtest/gtest.h>

#include <cmath>

#include "args/input_error.h"
#include "explosive/crushed_zone.h"

namespace muckpile {
namespace {

CrushedZoneInput emulsion() {
  CrushedZoneInput in;
  in.hole_radius = 0.045;
  in.borehole_pressure = 2.784375e9;
  in.cj_pressure = 5.56875e9;
  in.wall_shock = 8.14984e9;  // 5.56875 x 2/(1 + 4.95/13.5) GPa
  in.youngs_modulus = 59.123e9;
  in.poisson_ratio = 0.22;
  in.ucs = 100e6;
  in.tensile_strength = 8e6;
  return in;
}

double ratio(CrushedZone model, const CrushedZoneInput& in = emulsion()) {
  return crushed_zone_radius(model, in) / in.hole_radius;
}

TEST(CrushedZone, MultipleIsTheRatioTimesTheHole) {
  EXPECT_DOUBLE_EQ(ratio(CrushedZone::multiple), 3.0);
}

TEST(CrushedZone, StrengthEndsWhereThePeakIsWhatTheRockBears) {
  // sigma_cr = 3.15 x 100 = 315 MPa: (2784.375/315)^(2/3) = 8.83929^(2/3) = 4.27509
  CrushedZoneInput in = emulsion();
  in.attenuation_exponent = 1.5;
  EXPECT_NEAR(ratio(CrushedZone::strength, in), 4.27509, 1e-4);
  const double r1 = ratio(CrushedZone::strength, in);
  EXPECT_NEAR(in.borehole_pressure * std::pow(r1, -1.5), 315e6, 1.0);
  in.pressure_share = 0.1;  // 278 MPa
  EXPECT_EQ(crushed_zone_radius(CrushedZone::strength, in), 0.045);
}

/// Esen's fit to measured zones has the same powers where the modulus goes with the strength:
/// 0.657 of pressure and -0.657 of strength, beside 2/3.
TEST(CrushedZone, StrengthAnswersToExplosiveAndRockAsEsen) {
  CrushedZoneInput one = emulsion(), other = emulsion();
  one.attenuation_exponent = other.attenuation_exponent = 1.5;
  other.borehole_pressure *= 2.0;
  const auto answer = [&](CrushedZone model) { return ratio(model, other) / ratio(model, one); };
  EXPECT_NEAR(answer(CrushedZone::strength) / answer(CrushedZone::esen), 1.0, 0.01);
  other = one;
  other.ucs *= 0.5;
  other.youngs_modulus *= 0.5;
  EXPECT_NEAR(answer(CrushedZone::strength) / answer(CrushedZone::esen), 1.0, 0.01);
}

TEST(CrushedZone, EsenIsAPowerOfTheCrushingIndex) {
  // K = 59.123/1.22 = 48.4615 GPa; CZI = 2.784375^3 e27/(48.4615e9 x 1e16) = 44.5432
  // 0.812 x 44.5432^0.219 = 0.812 x e^(0.219 x 3.796460) = 0.812 x 2.296646 = 1.86488
  EXPECT_NEAR(ratio(CrushedZone::esen), 1.86488, 1e-4);
}

TEST(CrushedZone, EsenCrushesNothingBelowAnIndexOf2Point6) {
  CrushedZoneInput in = emulsion();
  in.borehole_pressure *= 0.38;  // CZI 44.5432 x 0.38^3 = 2.444
  EXPECT_DOUBLE_EQ(ratio(CrushedZone::esen, in), 1.0);
}

TEST(CrushedZone, DjordjevicIsTheRootOfPressureOver24TensileStrengths) {
  EXPECT_NEAR(ratio(CrushedZone::djordjevic), 3.80814, 1e-4);  // sqrt(2784.375/192)
}

TEST(CrushedZone, KanchibotlaIsTheRootOfDetonationPressureOverStrength) {
  EXPECT_NEAR(ratio(CrushedZone::kanchibotla), 7.46241, 1e-4);  // sqrt(55.6875)
}

TEST(CrushedZone, DaiFallsWithTheStrainRate) {
  // mu = 0.176, b = 0.213592, B^2 = 1.472806 + 1.045622 - 0.290048 x 0.618438 = 2.339051,
  // B = 1.529396; at 1e3/s: [8149.84 x 1.529396/(1.414214 x 1000)]^(1/2.213592) = 8.81365^0.451755
  EXPECT_NEAR(ratio(CrushedZone::dai), 2.6736, 1e-3);
  CrushedZoneInput in = emulsion();
  in.strain_rate = 1e2;
  EXPECT_NEAR(ratio(CrushedZone::dai, in), 2.6736 * 1.414538, 2e-3);  // 10^((1/3)/2.213592)
}

TEST(CrushedZone, MultipleEndsWhereThePeakIsThatOfAFullHole) {
  // alpha = 2 + 0.22/0.78 = 2.282051; 3 x 0.35^(1/alpha) = 3 x e^(-1.049822/2.282051) = 1.89373
  CrushedZoneInput in = emulsion();
  in.attenuation_exponent = 2.0 + 0.22 / 0.78;
  EXPECT_EQ(crushed_zone_radius(CrushedZone::multiple, in), 0.045 * 3.0);
  in.pressure_share = 0.35;
  EXPECT_NEAR(ratio(CrushedZone::multiple, in), 1.89373, 1e-4);
  in.pressure_share = 0.05;  // 3 x 0.269: not thinner than the hole
  EXPECT_EQ(crushed_zone_radius(CrushedZone::multiple, in), 0.045);
}

TEST(CrushedZone, EachModelHasThePressureOfADecoupledCharge) {
  CrushedZoneInput in = emulsion();
  in.pressure_share = 0.5;
  EXPECT_NEAR(ratio(CrushedZone::esen, in), 1.86488 * 0.634198, 1e-4);  // 0.5^(3 x 0.219)
  EXPECT_NEAR(ratio(CrushedZone::djordjevic, in), 3.80814 * 0.707107, 1e-4);
  EXPECT_NEAR(ratio(CrushedZone::kanchibotla, in), 7.46241 * 0.707107, 1e-4);
  EXPECT_NEAR(ratio(CrushedZone::dai, in), 2.6736 * 0.731153, 1e-3);  // 0.5^(1/2.213592)
}

TEST(CrushedZone, RefusesWhatItsModelCannotUse) {
  const auto refused = [](CrushedZone model, auto change) {
    CrushedZoneInput in = emulsion();
    change(in);
    EXPECT_THROW((void)crushed_zone_radius(model, in), InputError);
  };
  refused(CrushedZone::strength, [](auto& in) { in.ucs = 0.0; });
  refused(CrushedZone::strength, [](auto& in) { in.crushing_factor = 0.0; });
  refused(CrushedZone::multiple, [](auto& in) { in.multiple = 0.5; });
  refused(CrushedZone::multiple, [](auto& in) { in.attenuation_exponent = 0.0; });
  refused(CrushedZone::esen, [](auto& in) { in.pressure_share = 0.0; });
  refused(CrushedZone::esen, [](auto& in) { in.ucs = 0.0; });
  refused(CrushedZone::esen, [](auto& in) { in.youngs_modulus = 0.0; });
  refused(CrushedZone::djordjevic, [](auto& in) { in.tensile_strength = 0.0; });
  refused(CrushedZone::kanchibotla, [](auto& in) { in.ucs = -1.0; });
  refused(CrushedZone::dai, [](auto& in) { in.strain_rate = 1.0; });
  refused(CrushedZone::esen, [](auto& in) { in.poisson_ratio = 0.5; });
  refused(CrushedZone::multiple, [](auto& in) { in.hole_radius = 0.0; });
}

}  // namespace
}  // namespace muckpile
