// SPDX-License-Identifier: GPL-2.0-or-later
// Plane waves on the viscous boundary.
// Scope: limits and symmetries that the formula must have.
#include <gtest/gtest.h>

#include <cmath>

#include "analytic/viscous_boundary.h"

namespace muckpile {
namespace {

constexpr double kDegree = M_PI / 180.0;

TEST(ViscousBoundary, AbsorbsAllAtNormalIncidence) {
  for (const double nu : {0.0, 0.25, 0.45}) {
    EXPECT_NEAR(viscous_boundary_reflection(WaveType::p, 0.0, nu), 0.0, 1e-28);
    EXPECT_NEAR(viscous_boundary_reflection(WaveType::s, 0.0, nu), 0.0, 1e-28);
  }
}

TEST(ViscousBoundary, ShearAlongTheNormalSpeedByHand) {
  // nu = 0, lambda = 0, cP^2 = 2 cS^2: a P-wave at 45 degrees has slowness 1/(2 cS) along the
  // boundary, so the S-wave leaves at 30 degrees. With cS = 1, u = p exp(i w (t - d.x/c)), traction
  // on the face z = 0 of z > 0 plus dashpots, over i w:
  //   in  d = p = (s, -s), s = 1/sqrt2:  x: -2 s^2/cP + s      = -s + s        = 0
  //                                       z:  2 s^2/cP - cP s   =  s - 1        = s - 1
  //   P   d = p = (s, s):                 x:  2 s^2/cP + s      =  2 s
  //                                       z:  2 s^2/cP + cP s   =  s + 1
  //   S   d = (1/2, r), p = (r, -1/2), r = sqrt(3)/2:  x: r^2 - 1/4 + r = 1/2 + r
  //                                       z: -2 r/2 - cP/2      = -r - s
  const double s = std::sqrt(0.5), r = std::sqrt(0.75), c = std::sqrt(2.0);
  const double determinant = 2.0 * s * (-r - s) - (s + 1.0) * (0.5 + r);
  const double p_back = (0.5 + r) * (s - 1.0) / determinant;
  const double s_back = -2.0 * s * (s - 1.0) / determinant;
  const double expected = (p_back * p_back * c * s + s_back * s_back * r) / (c * s);
  EXPECT_NEAR(viscous_boundary_reflection(WaveType::p, 45.0 * kDegree, 0.0), expected, 1e-12);
}

TEST(ViscousBoundary, TheSameConversionEitherWay) {
  // nu = 1/4: cP = sqrt(3) cS. P at 60 degrees and S at 30 share the slowness, and lose the same.
  const double p = viscous_boundary_reflection(WaveType::p, 60.0 * kDegree, 0.25);
  const double s = viscous_boundary_reflection(WaveType::s, 30.0 * kDegree, 0.25);
  EXPECT_NEAR(p, s, 1e-12);
  EXPECT_GT(p, 0.01);
}

TEST(ViscousBoundary, NeverReturnsMoreThanArrives) {
  for (const double nu : {0.0, 0.25, 0.45}) {
    for (double angle = 1.0; angle < 90.0; angle += 1.0) {
      for (const WaveType type : {WaveType::p, WaveType::s}) {
        const double share = viscous_boundary_reflection(type, angle * kDegree, nu);
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
      }
    }
    EXPECT_GT(viscous_boundary_reflection(WaveType::s, 89.9 * kDegree, nu), 0.95);
  }
}

}  // namespace
}  // namespace muckpile
