// SPDX-License-Identifier: GPL-2.0-or-later
// Joints with a law of their own in the facet network: closure in series with the rock, energy,
// hysteresis, strength and friction, what a facet remembers, stable step, gas.
// Scope: cubes with natural joints between them, moved by hand or by leapfrog. What every law must
// do runs for each of joint_laws(); figures that are known in closed form are Barton and Bandis'.
// Decohesion is in test_decohesion.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "bond/law/coulomb.h"
#include "bond/law/joint_in_rock.h"
#include "bond/law/joint_law_table.h"
#include "joint_laws.h"

namespace muckpile::test {
namespace {

// Those of test_decohesion.cpp, too.
INSTANTIATE_TEST_SUITE_P(Laws, EachJointLaw, testing::ValuesIn(joint_laws()), name_of_law);

TEST(JointLaw, EveryLawThatAUserCanNameIsTested) {
  const std::vector<LawOfJoints> tested = joint_laws();
  const auto name_of = [](const LawOfJoints& law) { return std::string(law.name); };
  for (const JointLawEntry& entry : joint_law_entries())
    EXPECT_EQ(std::ranges::count(tested, entry.name, name_of), 1) << entry.name;
}

/// Does not break.
BartonBandis strong() {
  BartonBandis joint = law();
  joint.tension = 1e30;
  return joint;
}

TEST(JointLaw, RockAndJointCloseInSeries) {
  BondScene scene =
      cubes(2, 1, 0.0,
            barton_bandis_class(strong(), 2e10));  // nu 0: no dilatation, (lambda + 2G)/h = 5e10 Pa
  double worst = 0.0;
  for (const double w : {-1e-5, 1e-6, 2e-5, 8e-5, 1.5e-4, 4e-4}) {
    scene.block(1).centre.x() = scene.start(1).x() - w;
    scene.compute();
    const double pressure = scene.network().force()[1].x();
    const double closure = w - pressure / 5e10;
    const double formula = 1e10 * closure / (1.0 - std::max(closure, 0.0) / 1e-4);
    worst = std::max(worst, std::abs(pressure / formula - 1.0));
  }
  std::printf("closure in the network: worst error of the pressure %.2g\n", worst);
  EXPECT_LT(worst, 1e-9);
}

/// The numbers of the class are those of another law: facets alone and in groups heed the law's.
TEST(JointLaw, AGroupedLawHasItsOwnStrength) {
  for (const int wide : {1, 6}) {  // facets between two layers of cubes: 1, 36
    JointClass joint = coulomb_joint({.tension = 1e6});
    joint.law = law_everywhere(Coulomb{{3e6, 1e30, 0.6, 0.5}, {5e10}});
    BondScene scene = cubes(2, wide, rock(0.0), joint);
    for (const double pull : {2.9e6, 3.1e6}) {
      for (std::size_t b = 0; b < scene.size(); ++b)
        if (scene.start(b).x() > 1.0)  // rock and joint in series, 5e10 Pa/m each
          scene.block(b).centre.x() = scene.start(b).x() + pull / 2.5e10;
      scene.compute(1e-6);
      EXPECT_EQ(scene.network().broken_count(), pull > 3e6 ? wide * wide : 0)
          << wide << ' ' << pull;
    }
  }
}

/// Coulomb's law without the word that its facets go in groups.
struct OneByOne : CoulombStrength<double>, ProportionalClosure {
  [[nodiscard]] std::optional<JointApertures> apertures(double /*closure*/) const { return {}; }
  [[nodiscard]] OneByOne softened(double factor) const {
    OneByOne soft = *this;
    soft.stiffness *= factor;
    return soft;
  }
};

TEST(JointLaw, FacetsWorkedOnOneByOneDoAsGroupsDo) {
  JointClass joint = coulomb_joint({.tension = 2e5, .cohesion = 4e5});
  const Coulomb law = coulomb_of(JointMaterial(rock(0.25)).with_joints(joint));
  BondScene grouped = cubes(4, 3, 0.25, joint);
  joint.law = law_everywhere(OneByOne{law, law});
  BondScene alone = cubes(4, 3, 0.25, joint);
  ASSERT_FALSE(law_of(joint)->grouped());
  double worst = 0.0, largest = 0.0;
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {  // breaks points, slides and opens broken ones
    for (BondScene* scene : {&grouped, &alone}) {
      scene->shake(1e-5, 1e-5, seed);
      scene->compute(1e-6);
    }
    EXPECT_EQ(alone.network().broken_count(), grouped.network().broken_count()) << seed;
    for (std::size_t b = 0; b < grouped.size(); ++b) {
      const Vec3 force = grouped.network().force()[b];
      worst = std::max(worst, (alone.network().force()[b] - force).norm());
      largest = std::max(largest, force.norm());
    }
  }
  const double broken = grouped.network().broken_count();
  std::printf("one by one and in groups: %g broken facets, forces of up to %.3g N off by %.2g\n",
              broken, largest, worst / largest);
  EXPECT_GT(broken, 0.0);
  EXPECT_LT(broken, static_cast<double>(grouped.network().facet_count()));
  EXPECT_LT(worst, 1e-9 * largest);
  EXPECT_GT(grouped.network().losses().friction, 0.0);
  EXPECT_NEAR(alone.network().losses().friction, grouped.network().losses().friction,
              1e-6 * grouped.network().losses().friction);
}

double energy(BondScene& scene) {
  scene.compute();
  return scene.network().elastic_energy();
}

/// Largest difference of a force or torque and the slope of the energy, over the largest one.
double gradient_error(BondScene& scene) {
  constexpr double kStep = 2e-8;  // [m], [rad]: the closure is curved over 1e-5 m
  scene.compute();
  const std::vector<Vec3> force(scene.network().force().begin(), scene.network().force().end());
  const std::vector<Vec3> torque(scene.network().torque().begin(), scene.network().torque().end());
  double worst = 0.0, largest = 0.0;
  for (std::size_t b = 0; b < scene.size(); ++b) {
    const BlockState home = scene.block(b);
    for (int k = 0; k < 3; ++k) {
      const auto slope = [&](const auto& move) {
        move(kStep);
        const double up = energy(scene);
        scene.block(b) = home;
        move(-kStep);
        const double down = energy(scene);
        scene.block(b) = home;
        return -(up - down) / (2.0 * kStep);
      };
      const double f = slope([&](double by) { scene.block(b).centre[k] += by; });
      const double t = slope(
          [&](double by) { scene.block(b).rotation = turn(by * Vec3::Unit(k)) * home.rotation; });
      worst = std::max({worst, std::abs(f - force[b][k]), std::abs(t - torque[b][k])});
    }
    largest = std::max({largest, force[b].norm(), torque[b].norm()});
  }
  return worst / largest;
}

TEST_P(EachJointLaw, ForcesAreTheGradientOfTheEnergy) {
  BondScene scene = cubes(3, 2, 0.25, joint({}));
  scene.shake(2e-5, 2e-5, 1);
  for (std::size_t b = 0; b < scene.size(); ++b)
    if (scene.start(b).x() > 1.0) scene.block(b).centre.x() -= 5e-5;
  scene.move_rigidly({0.6, -0.5, 0.7}, {3, -2, 1});
  const double error = gradient_error(scene);
  std::printf("forces and torques against the energy's slope: %.2g\n", error);
  EXPECT_LT(error, 1e-5);
}

TEST_P(EachJointLaw, ForcesOfLeaningFacetsAreTheGradientOfTheEnergy) {
  BondScene scene(
      leaning_blocks(3.0), rock(0.25), [](const Vec3&) { return Support::free; }, {{joint({})}, {}},
      Leaning::much);
  FacetLists lists = scene.network().give_up();
  for (Facet& facet : lists.facets) facet.joint_class = 1;
  scene.network().set_facets(std::move(lists));
  scene.shake(2e-5, 2e-5, 1);
  const double error = gradient_error(scene);
  std::printf("leaning facets: forces and torques against the energy's slope: %.2g\n", error);
  EXPECT_LT(error, 1e-5);
}

TEST_P(EachJointLaw, CyclesTakeWhatIsBooked) {
  const JointClass closing = joint({.keeps_closure = true});
  BondScene scene = cubes(2, 1, 0.25, closing);
  scene.compute();
  scene.block(0).velocity = Vec3(0.4, 0, 0);
  scene.block(1).velocity = Vec3(-0.4, 0, 0);
  const double start = scene.energy_account(), dt = 0.02 * scene.stable_step();
  double worst = 0.0;
  for (int n = 0; n < 4000; ++n) {
    scene.step(dt);
    worst = std::max(worst, std::abs(scene.energy_account() / start - 1.0));
  }
  const double taken = scene.network().losses().friction;
  std::printf("cycles: %.3g of the energy taken by closure, account off by %.2g\n", taken / start,
              worst);
  EXPECT_LT(worst, 1e-3);  // leapfrog, of second order in the step
  if (law_of(closing)->taken(Lanes(1e-4))[0] == 0.0) {
    EXPECT_EQ(taken, 0.0);
    return;
  }
  EXPECT_GT(taken, 0.05 * start);
  // What was taken is that of the largest closure, the same at all points.
  const double closure = scene.network().memory(0).extra.get().joint[0].closure;
  EXPECT_NEAR(taken / law_of(closing)->taken(closure)[0], 1.0, 1e-6);
}

/// Two cubes pressed together by w, one then slid in steps.
void slide(BondScene& scene, double w, double from, double to, double step) {
  for (double y = from; y < to; y += step) {
    scene.block(1).centre = scene.start(1) + Vec3(-w, y, 0.0);
    scene.compute(1e-6);
  }
}

TEST(JointLaw, FailsAtItsStrengthAndThenHasItsFriction) {
  for (const double peak_slip : {0.0, 1e-4}) {
    BartonBandis joint = law();
    joint.peak_slip = peak_slip;
    BondScene scene = cubes(2, 1, 0.0, barton_bandis_class(joint, 2e10));
    double peak = 0.0, pressure = 0.0;
    for (double y = 0.0; scene.network().broken_count() == 0.0 && y < 1e-3; y += 1e-7) {
      slide(scene, 5e-5, y, y + 0.5e-7, 1e-7);
      const Vec3 force = scene.network().force()[1];
      if (scene.network().broken_count() != 0.0) break;
      pressure = force.x();
      peak = std::max(peak, std::abs(force.y()));
    }
    const double strength = pressure * joint.tan_angle(pressure, 10.0);
    std::printf("peak shear over the strength: %.6f\n", peak / strength);
    EXPECT_NEAR(peak / strength, 1.0, 5e-3);  // a step of the slide is 0.2 % of it
    slide(scene, 5e-5, 1e-3, 1.2e-3, 1e-6);
    const Vec3 force = scene.network().force()[1];
    const double slip = scene.network().memory(0).extra.get().joint[0].slip;
    EXPECT_NEAR(std::abs(force.y()) / force.x() / joint.friction(force.x(), slip), 1.0, 1e-2);
    if (peak_slip == 0.0) {
      EXPECT_NEAR(std::abs(force.y()) / force.x(), std::tan(30.0 * kDegree), 1e-6);
    } else {
      EXPECT_GT(slip, 5e-4);
    }
  }
}

TEST(JointLaw, AClosedBrokenJointKeepsItsClosure) {
  BondScene scene = cubes(2, 1, 0.0, barton_bandis_class(law(), 2e10));
  scene.block(1).centre.x() += 1e-9;  // no tension: breaks
  scene.compute(1e-6);
  ASSERT_EQ(scene.network().broken_count(), 1.0);
  for (const double w : {1e-5, 8e-5, 3e-4}) {
    scene.block(1).centre.x() = scene.start(1).x() - w;
    scene.compute(1e-6);
    EXPECT_NEAR(scene.network().force()[1].x() / law().close(w, 5e10, 0.0).pressure, 1.0, 2e-4);
  }
  scene.block(1).centre.x() = scene.start(1).x() + 1e-5;
  scene.compute(1e-6);
  EXPECT_EQ(scene.network().force()[1].x(), 0.0);
}

TEST_P(EachJointLaw, ASlidingBreakingHeapKeepsItsEnergyAccount) {
  BondScene scene =
      cubes(2, 2, 0.2, joint({.tension = 0.0, .cohesion = 0.0, .keeps_closure = true}));
  scene.compute();
  for (std::size_t b = 0; b < scene.size(); ++b)
    scene.block(b).velocity =
        scene.start(b).x() > 1.0 ? Vec3(-0.3, 0.2, 0.1) : Vec3(0.3, -0.2, -0.1);
  const double start = scene.energy_account(), dt = 0.02 * scene.stable_step();
  double worst = 0.0;
  for (int n = 0; n < 4000; ++n) {
    scene.step(dt);
    worst = std::max(worst, std::abs(scene.energy_account() / start - 1.0));
  }
  std::printf("breaking: account off by %.2g, friction %.3g, fracture %.3g of it\n", worst,
              scene.network().losses().friction / start, scene.network().losses().fracture / start);
  EXPECT_GT(scene.network().broken_count(), 0.0);
  EXPECT_LT(worst, 1e-2);
}

TEST_P(EachJointLaw, WhatAFacetRemembersGivesTheSameForces) {
  const JointClass closing = joint({.keeps_closure = true});
  BondScene scene = cubes(2, 1, 0.25, closing), other = cubes(2, 1, 0.25, closing);
  for (const double w : {1.5e-4, 1e-4}) {
    scene.block(1).centre.x() = scene.start(1).x() - w;
    scene.compute();
  }
  other.network().set_facets(scene.network().lists());
  other.block(1) = scene.block(1);
  other.compute();
  EXPECT_EQ(scene.network().force()[1], other.network().force()[1]);
  if (!law_of(closing)->grouped()) {
    EXPECT_GT(scene.network().memory(0).extra.get().joint[0].closure, 0.0);
  }
}

TEST(JointLaw, TheStableStepHoldsForAWaveThatClosesTheJoint) {
  const auto bound = [](double w) {
    BondScene scene = cubes(2, 1, 0.0, barton_bandis_class(strong(), 2e10));
    scene.block(1).centre.x() -= w;
    scene.compute();
    return scene.stable_step(Breaking::none);
  };
  // Two cubes of 2600 kg on springs k in the three directions and turns; along x omega^2 = 2 k/m.
  // Shear: 5e10 and 2e10 in series, 1.43e10 Pa/m. Along x a closed joint has nearly the rock's
  // 5e10; one without pressure has 0.83e10 now, but closes within a wave's rise.
  const double closed = 2.0 / std::sqrt(2.0 * 5e10 / 2600.0);
  EXPECT_NEAR(bound(5e-3) / closed, 1.0, 0.03);
  for (const double w : {-1e-5, 0.0, 5e-5}) EXPECT_NEAR(bound(w) / bound(5e-3), 1.0, 1e-9);
}

TEST(JointLaw, StiffestOfAllClosures) {
  // Rock of 1e10 Pa/m in uniaxial strain; the tangent is that of the energy G/h r^2 + W.
  for (const double share : {0.1, 0.3, 0.5, 0.8, 1.0}) {
    SeriesPoints closure{};
    closure.uniaxial = 1e10;
    closure.rock = share * 1e10;
    double largest = 0.0;
    for (double x = 1e-3; x < 1e5; x *= 1.01)
      largest = std::max(largest, 1e10 * x * (share * x + 1.0) / ((1.0 + x) * (1.0 + x)));
    EXPECT_NEAR(largest / closure.stiffest().stiffness, 1.0, 1e-4) << share;
  }
}

TEST(JointLaw, GasFindsLessAsTheJointCloses) {
  BondScene scene = cubes(2, 1, 0.0, barton_bandis_class(law(), 2e10));
  scene.network().keep_gas_in_joints();
  scene.block(1).centre.x() += 1e-9;
  scene.compute(1e-6);
  const LaneSet all{0, 1};
  const auto aperture = [&](double w) {
    scene.block(1).centre.x() = scene.start(1).x() - w;
    scene.compute(1e-6);
    OpenJoints open;
    scene.network().open_joints({&all, 1}, open);
    return open.by_law.at(0).apertures;
  };
  double before = aperture(0.0).hydraulic;
  EXPECT_NEAR(before / law().apertures(0.0).hydraulic, 1.0, 1e-4);
  for (const double w : {2e-5, 5e-5, 1e-4, 3e-4}) {
    const double closure = law().close(w, 5e10, 0.0).closure, now = aperture(w).hydraulic;
    std::printf("jump %.0f um: hydraulic aperture %.2f um\n", w * 1e6, now * 1e6);
    EXPECT_NEAR(now / law().apertures(closure).hydraulic, 1.0, 1e-3);
    EXPECT_NEAR(aperture(w).mechanical / (2e-4 - closure), 1.0, 1e-3);
    EXPECT_LT(now, before);
    before = now;
  }
  EXPECT_GT(aperture(-1e-3).hydraulic, 1e-3);  // wide open
  // Open faces part by the jump: the volume grows by what the pressure works on.
  const double apart = aperture(-2e-3).mechanical - aperture(-1e-3).mechanical;
  EXPECT_NEAR(apart / 1e-3, 1.0, 1e-9);
}

TEST_P(EachJointLaw, SofteningTakesItToTheSameShare) {
  BondScene scene = cubes(2, 1, 0.25, joint({}));
  scene.block(1).centre.x() -= 8e-5;
  scene.compute();
  const double before = scene.network().force()[1].x();
  scene.network().soften(0.1);
  scene.compute();
  EXPECT_NEAR(scene.network().force()[1].x() / before, 0.1, 1e-9);
}

}  // namespace
}  // namespace muckpile::test
