// SPDX-License-Identifier: GPL-2.0-or-later
// The linear joint law as a value: the stiffness by which groups of facets are worked on is its
// closure in series with the rock; strength and friction at any width.
// Scope: the points of one facet. Strength by hand is in test_joint_material.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bond/law/coulomb.h"
#include "bond/law/joint_in_rock.h"
#include "bond/law/joint_material.h"
#include "bond/law/slip_friction.h"

namespace muckpile::test {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kRock = 4e10, kUniaxial = 6e10, kShear = 3e10;  // [Pa/m]

/// Both forms of one joint of that stiffness [Pa/m].
struct BothForms {
  explicit BothForms(double stiffness)
      : joint(Coulomb{{}, {stiffness}}),
        facet(joint_in_rock(kRock, kShear, kUniaxial, stiffness,
                            std::numeric_limits<double>::infinity())) {}

  [[nodiscard]] LinearPoints linear() const { return {{facet.shear, facet.normal - facet.shear}}; }
  [[nodiscard]] SeriesPoints series() const {
    return {&joint, facet.shear, kRock, kUniaxial, facet.rock_share, {}};
  }
  [[nodiscard]] LinearContact<Lanes> linear_contact(double fade) const {
    return {fade * linear().facet.contact(facet.rock_share, kRock / kUniaxial)};
  }
  [[nodiscard]] SeriesContact series_contact(double fade) const {
    return {&joint, fade, kUniaxial, 0.0};
  }

  JointLawOf<Coulomb> joint;
  FacetStiffness facet;
};

double difference(const Lanes& a, const Lanes& b) {
  double worst = 0.0;
  for (std::size_t k = 0; k < kLanes; ++k)
    worst = std::max(worst, std::abs(a[k] - b[k]) / std::max(std::abs(b[k]), 1e-300));
  return worst;
}
double difference(const LaneVec& a, const LaneVec& b) {
  return std::max({difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)});
}

const Lanes kSteps([](auto lane) { return 1e-5 * (1.0 + lane) - 2.5e-5; });

TEST(Coulomb, TheStiffnessOfBondedPointsIsItsClosureInSeriesWithTheRock) {
  const LaneVec normal(Vec3(0.6, 0.0, 0.8));
  const LaneVec jump = kSteps * LaneVec(Vec3(1.0, 0.7, -0.4)), lost = Lanes(0.3) * jump;
  const LaneVec bulk(Vec3(3e5, -2e5, 4e5));
  double worst = 0.0;
  for (const double stiffness : {1e9, 5e10, 1e13, std::numeric_limits<double>::infinity()}) {
    const BothForms both(stiffness);
    const LinearPoints linear = both.linear();
    const SeriesPoints series = both.series();
    worst = std::max(
        {worst,
         difference(series.traction(normal, jump, bulk), linear.traction(normal, jump, bulk)),
         difference(series.strained(normal, jump), linear.strained(normal, jump)),
         difference(series.strain_lost(normal, jump, lost), linear.strain_lost(normal, jump, lost)),
         difference(series.twice_energy(normal, jump), linear.twice_energy(normal, jump))});
  }
  std::printf("both forms of bonded points: off by %.2g\n", worst);
  EXPECT_LT(worst, 1e-11);  // differences of close numbers
}

TEST(Coulomb, TheStiffnessOfClosedPointsIsItsClosureInSeriesWithTheRock) {
  const Lanes gap = -abs(kSteps), pressed(-3e5);
  double worst = 0.0;
  for (const double stiffness : {1e9, 5e10, 1e13, std::numeric_limits<double>::infinity()}) {
    const BothForms both(stiffness);
    const auto linear = both.linear_contact(0.7);
    const SeriesContact series = both.series_contact(0.7);
    const auto whole = both.linear_contact(1.0);
    const SeriesContact whole_series = both.series_contact(1.0);
    worst =
        std::max({worst, difference(series.traction(gap), linear.traction(gap)),
                  difference(series.twice_energy(gap), linear.twice_energy(gap)),
                  difference(whole_series.gap(pressed), whole.gap(pressed)),
                  difference(whole_series.stiffness_to(-pressed), whole.stiffness_to(-pressed))});
  }
  std::printf("both forms of closed points: off by %.2g\n", worst);
  EXPECT_LT(worst, kRounding);
}

TEST(Coulomb, StoresTheWorkOfItsPressure) {
  // 1e10 Pa/m closed by 3e-5 m: 3e5 Pa, 4.5 J/m2; rock of 6e10 Pa/m gives way by 0.5e-5 m more.
  const Coulomb joint{{}, {1e10}};
  EXPECT_NEAR(joint.stored(3e-5, 0.0), 4.5, kRounding);
  EXPECT_NEAR(joint.jump_at(3e5, kUniaxial, 0.0), 3.5e-5, 1e-17);
  const JointClosure<double> at = joint.close(3.5e-5, kUniaxial, 0.0);
  EXPECT_NEAR(at.closure, 3e-5, 1e-17);
  EXPECT_NEAR(at.pressure, 3e5, 1e-6);
  EXPECT_NEAR(at.rate, 6.0 / 7.0, kRounding);
  EXPECT_NEAR(joint.softened(0.1).close(3.5e-5, 0.1 * kUniaxial, 0.0).pressure, 3e4, 1e-7);
  EXPECT_EQ(joint.taken(3e-5), 0.0);
  EXPECT_FALSE(joint.apertures(0.0));
}

TEST(Coulomb, FourPointsFailAndRubAsOneDoes) {
  const Coulomb joint{{2e6, 4e6, 0.5, 0.3}, {1e10}};
  const JointLawOf<Coulomb> law(joint);
  const Lanes normal = 1e11 * kSteps, shear = 4e6 - 0.4 * normal;
  const LaneMask fails = law.fails(normal, shear * shear, {0.5, 1.5});
  const Lanes friction = law.friction(-normal, 0.0);
  for (std::size_t k = 0; k < kLanes; ++k) {
    const double one = normal[k], squared = shear[k] * shear[k];
    EXPECT_EQ(fails[k], joint.fails(one, squared, {0.5, 1.5})) << k;
    EXPECT_EQ(friction[k], 0.3);
  }
  EXPECT_TRUE(law.grouped());
}

TEST(Coulomb, FrictionIsAskedForAtAnyWidthAndIsNoneAtAMirror) {
  const Coulomb joint{{0.0, 0.0, 0.5, 0.6}, {1e10}};
  const JointLawOf<Coulomb> law(joint);
  const SlipWeakening weakening{0.1, 0.2};
  for (const double grip : {1.0, 0.0}) {
    const SlipFriction<Lanes, const JointLaw&> at_points{law, 0.0, grip, weakening};
    // 1e6 Pa at rest, and at 0.4 m/s: 0.2 + (0.6 - 0.2) 0.1/0.4 = 0.3
    EXPECT_NEAR(at_points.limit(-1e6, 0.0)[0], grip * 0.6e6, 1e-6);
    EXPECT_NEAR(at_points.limit(-1e6, 0.16)[0], grip * 0.3e6, 1e-6);
  }
}

}  // namespace
}  // namespace muckpile::test
