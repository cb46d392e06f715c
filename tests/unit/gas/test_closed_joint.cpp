// SPDX-License-Identifier: GPL-2.0-or-later
// How wide a closed joint is for gas: against the joint law that has the same hyperbola.
// Scope: closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "args/input_error.h"
#include "bond/law/barton_bandis.h"
#include "gas/closed_joint.h"

namespace muckpile {
namespace {

ClosedJoint::Parameters fresh() {  // JRC 10, walls of 150 MPa
  return {.residual_aperture = 2e-4,
          .closure_share = 0.45,
          .closure_stiffness = 2.5e10,
          .roughness = 10.0};
}

TEST(ClosedJoint, ClosesOnTheHyperbolaOfTheJointLaw) {
  const ClosedJoint joint(fresh());
  const BartonBandis law{.initial_stiffness = 2.5e10,
                         .closure_limit = 0.9e-4,
                         .roughness = 10.0,
                         .initial_aperture = 2e-4};
  for (const double closure : {1e-6, 1e-5, 4.5e-5, 8e-5, 8.99e-5}) {
    const double stress = law.loading<double>().pressure(closure);
    const JointApertures gas = joint.apertures(stress, 0.0), by_law = law.apertures(closure);
    EXPECT_NEAR(gas.mechanical / by_law.mechanical, 1.0, 1e-12) << closure;
    EXPECT_NEAR(gas.hydraulic / by_law.hydraulic, 1.0, 1e-12) << closure;
    EXPECT_EQ(joint.closed(stress), gas.mechanical) << closure;
  }
}

TEST(ClosedJoint, FreshGraniteByHand) {
  const ClosedJoint joint(fresh());
  EXPECT_DOUBLE_EQ(joint.apertures(0.0, 0.0).mechanical, 2e-4);
  EXPECT_NEAR(joint.apertures(0.0, 0.0).hydraulic, 200.0 * 200.0 / 316.22777 * 1e-6, 1e-11);
  // k V = 2.25 MPa closes half of V = 0.09 mm.
  EXPECT_NEAR(joint.closed(2.25e6), 1.55e-4, 1e-12);
  EXPECT_NEAR(joint.closed(1e12), 1.1e-4, 1e-9);
  EXPECT_NEAR(joint.apertures(1e12, 0.0).hydraulic, 38.26e-6, 1e-8);
  // Open walls: as wide for the flow as for the volume.
  EXPECT_DOUBLE_EQ(joint.apertures(0.0, 1e-3).mechanical, 1.2e-3);
  EXPECT_DOUBLE_EQ(joint.apertures(0.0, 1e-3).hydraulic, 1.2e-3);
}

/// Bandis, Lumsden & Barton (1983), first loading; strengths in MPa, lengths in mm:
/// a = JRC/5 (0.2 UCS/JCS - 0.1), k = -7.15 + 1.75 JRC + 0.02 JCS/a,
/// V = -0.296 - 0.0056 JRC + 2.241 (JCS/a)^-0.245.
TEST(ClosedJoint, FreshJointsOfTheRegressions) {
  for (const double jrc : {5.0, 10.0, 15.0}) {
    for (const double jcs : {100.0, 150.0, 200.0}) {
      const double aperture = 1e3 * barton_bandis_aperture(jrc, jcs, jcs), ratio = jcs / aperture;
      const double limit = -0.296 - 0.0056 * jrc + 2.241 * std::pow(ratio, -0.245);
      const double stiffness = -7.15 + 1.75 * jrc + 0.02 * ratio;
      std::printf("JRC %2.0f, JCS %.0f MPa: E_0 %.2f mm, V/E_0 %.2f, k %.0f MPa/mm\n", jrc, jcs,
                  aperture, limit / aperture, stiffness);
      if (jrc != 10.0 || jcs != 150.0) continue;
      EXPECT_NEAR(1e-3 * aperture / fresh().residual_aperture, 1.0, 1e-9);
      EXPECT_NEAR(limit / aperture, fresh().closure_share, 0.005);
      EXPECT_NEAR(1e9 * stiffness / fresh().closure_stiffness, 1.0, 0.02);
    }
  }
}

TEST(ClosedJoint, WithoutClosureAndRoughnessTheApertureStays) {
  const ClosedJoint joint(ClosedJoint::Parameters{});
  for (const double stress : {0.0, 1e5, 1e9}) {
    EXPECT_EQ(joint.apertures(stress, 0.0).mechanical, 1e-4);
    EXPECT_EQ(joint.apertures(stress, 2e-4).hydraulic, 1e-4 + 2e-4);
  }
}

TEST(ClosedJoint, RefusesWhatIsNoJoint) {
  const auto refused = [](const auto& change) {
    ClosedJoint::Parameters p = fresh();
    change(p);
    EXPECT_THROW(ClosedJoint{p}, InputError);
  };
  refused([](auto& p) { p.residual_aperture = 0.0; });
  refused([](auto& p) { p.closure_share = 1.0; });
  refused([](auto& p) { p.closure_share = -0.1; });
  refused([](auto& p) { p.closure_stiffness = 0.0; });
  refused([](auto& p) { p.roughness = -1.0; });
}

}  // namespace
}  // namespace muckpile
