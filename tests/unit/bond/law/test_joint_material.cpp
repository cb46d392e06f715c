// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic constants, series stiffness and strength of a joint against hand-worked numbers.
// Scope: pure functions, no blocks.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "args/input_error.h"
#include "bond/law/coulomb.h"
#include "bond/law/joint_material.h"
#include "bond_scene.h"

namespace muckpile {
namespace {

using test::rock;

constexpr double kRounding = 1e-14;  // relative; a handful of operations

TEST(JointMaterial, TakesShearModulusAndLambdaFromYoungsModulusAndPoissonRatio) {
  JointParameters p = rock(0.25);
  p.density = 2400.0;
  const JointMaterial material(p);
  EXPECT_NEAR(material.shear_modulus() / 20e9, 1.0, kRounding);   // 50 / (2 x 1.25)
  EXPECT_NEAR(material.lame_lambda() / 20e9, 1.0, kRounding);     // 2 G 0.25 / 0.5
  EXPECT_NEAR(material.p_wave_modulus() / 60e9, 1.0, kRounding);  // lambda + 2 G
  EXPECT_NEAR(material.p_wave_speed() / 5000.0, 1.0, kRounding);  // sqrt(60e9 / 2400)
  EXPECT_NEAR(material.s_wave_speed() / std::sqrt(20e9 / 2400.0), 1.0, kRounding);
}

TEST(JointMaterial, HasNoLambdaWithoutPoissonRatio) {
  const JointMaterial material(rock(0.0));
  EXPECT_EQ(material.lame_lambda(), 0.0);
  EXPECT_NEAR(material.p_wave_modulus() / 50e9, 1.0, kRounding);
}

/// Normal stiffness of the closed broken facet [Pa/m].
double contact_of(const JointMaterial& material, const FacetStiffness& k) {
  return LinearClosure<double>{k.shear, k.normal - k.shear}.contact(
      k.rock_share, 2.0 * material.shear_modulus() / material.p_wave_modulus());
}

TEST(JointMaterial, RigidJointIsTheRockBetweenTheCentres) {
  const FacetStiffness k = JointMaterial(rock(0.25)).facet_stiffness(0.5);
  EXPECT_NEAR(k.normal / 80e9, 1.0, kRounding);  // 2 G / h = 40 / 0.5
  EXPECT_NEAR(k.shear / 80e9, 1.0, kRounding);
  // (lambda + 2 G) / h = 60 / 0.5
  EXPECT_NEAR(contact_of(JointMaterial(rock(0.25)), k) / 120e9, 1.0, kRounding);
  EXPECT_EQ(k.rock_share, 1.0);
}

TEST(JointMaterial, AJointTakesTheEnergyOfTheStrengthsThatItHas) {
  JointParameters p = rock(0.25);
  p.fracture_energy_tension = 100.0;
  p.fracture_energy_shear = 400.0;
  const JointMaterial material(p);
  JointClass joint;
  joint.friction_angle = joint.residual_friction_angle = 0.6;
  const auto energies = [&] {
    const JointParameters of = material.with_joints(joint).parameters();
    return std::vector<double>{of.fracture_energy_tension, of.fracture_energy_shear};
  };
  EXPECT_EQ(energies(), (std::vector<double>{0.0, 0.0}));
  joint.cohesion = 1e5;
  EXPECT_EQ(energies(), (std::vector<double>{0.0, 400.0}));
  joint.tension = 1e4;
  EXPECT_EQ(energies(), (std::vector<double>{100.0, 400.0}));
}

TEST(JointMaterial, JointAndRockActInSeriesInUniaxialStrain) {
  for (const double nu : {0.0, 0.25, 0.4}) {
    for (const double joint : {1e9, 6e10, 1e13}) {
      constexpr double h = 0.7, jump = 1e-4;
      JointParameters p = rock(nu);
      p.normal_stiffness = joint;
      p.shear_stiffness = joint;
      const JointMaterial material(p);
      const FacetStiffness k = material.facet_stiffness(h);
      const double theta = k.rock_share * jump / h;  // of rock that strains along the normal alone
      const double traction = k.normal * jump + k.rock_share * material.lame_lambda() * theta;
      const double series = jump / (h / material.p_wave_modulus() + 1.0 / joint);
      EXPECT_NEAR(traction / series, 1.0, 10 * kRounding) << nu << ' ' << joint;
      const double shear = 1.0 / (h / (2.0 * material.shear_modulus()) + 1.0 / joint);
      EXPECT_NEAR(k.shear / shear, 1.0, kRounding);
      EXPECT_NEAR(contact_of(material, k) * jump / series, 1.0, 10 * kRounding);
    }
  }
}

TEST(JointMaterial, SofteningScalesEveryStiffnessAndNoStrength) {
  JointParameters p = rock(0.3);
  p.normal_stiffness = 7e10;
  p.shear_stiffness = 3e10;
  p.cohesion = 4e6;
  p.tension = 2e6;
  const JointMaterial hard(p), soft = hard.softened(0.01);
  const FacetStiffness a = hard.facet_stiffness(0.4), b = soft.facet_stiffness(0.4);
  EXPECT_NEAR(b.normal / a.normal, 0.01, kRounding);
  EXPECT_NEAR(b.shear / a.shear, 0.01, kRounding);
  EXPECT_NEAR(contact_of(soft, b) / contact_of(hard, a), 0.01, kRounding);
  EXPECT_NEAR(b.rock_share, a.rock_share, kRounding);
  EXPECT_NEAR(soft.lame_lambda() / hard.lame_lambda(), 0.01, kRounding);
  EXPECT_EQ(soft.parameters().cohesion, 4e6);
  EXPECT_EQ(soft.parameters().tension, 2e6);
}

TEST(JointMaterial, DampingIsAShareOfTheImpedance) {
  JointParameters p = rock(0.25);
  p.density = 2400.0;  // impedance 2400 x 5000 = 12 MPa s/m
  p.damping = 0.1;
  p.contact_damping = 0.05;
  EXPECT_NEAR(JointMaterial(p).damping_coefficient() / 1.2e6, 1.0, kRounding);
  EXPECT_NEAR(JointMaterial(p).contact_damping_coefficient() / 0.6e6, 1.0, kRounding);
}

TEST(JointMaterial, RefusesWhatIsOutOfRange) {
  EXPECT_NO_THROW(JointMaterial{rock(0.0)});
  const std::vector<std::function<void(JointParameters&)>> faults = {
      [](JointParameters& p) { p.youngs_modulus = 0.0; },
      [](JointParameters& p) { p.poisson_ratio = 0.5; },
      [](JointParameters& p) { p.poisson_ratio = -0.1; },
      [](JointParameters& p) { p.density = 0.0; },
      [](JointParameters& p) { p.tension = -1.0; },
      [](JointParameters& p) { p.cohesion = -1.0; },
      [](JointParameters& p) { p.friction_angle = 1.5708; },
      [](JointParameters& p) { p.residual_friction_angle = -0.1; },
      [](JointParameters& p) { p.normal_stiffness = 0.0; },
      [](JointParameters& p) { p.shear_stiffness = 0.0; },
      [](JointParameters& p) { p.damping = -0.1; },
      [](JointParameters& p) { p.contact_damping = -0.1; },
      [](JointParameters& p) { p.fracture_energy_tension = -1.0; },
      [](JointParameters& p) { p.fracture_energy_shear = -1.0; },
      [](JointParameters& p) { p.rate_exponent = -0.1; },
      [](JointParameters& p) { p.reference_rate = 0.0; },
      [](JointParameters& p) { p.reference_rate_shear = 0.0; },
      [](JointParameters& p) { p.weakening_speed = -0.1; },
      [](JointParameters& p) { p.weakened_friction_angle = 1.5708; },
      [](JointParameters& p) { p.youngs_modulus = std::numeric_limits<double>::quiet_NaN(); },
  };
  for (std::size_t k = 0; k < faults.size(); ++k) {
    JointParameters p = rock(0.25);
    faults[k](p);
    EXPECT_THROW(JointMaterial{p}, InputError) << k;
  }
}

TEST(CoulombStrength, FollowsMohrCoulombWithTensionCutOff) {
  struct Case {
    double normal, shear;
    bool fails;
  };
  // tension 2, cohesion 4, tan phi 0.5 [MPa]: the cut-off meets the line at shear 3
  for (const Case& c : {Case{1.99, 0.0, false}, Case{2.01, 0.0, true},      // tension alone
                        Case{0.0, 3.99, false}, Case{0.0, 4.01, true},      // cohesion alone
                        Case{-10.0, 8.99, false}, Case{-10.0, 9.01, true},  // 4 + 10 x 0.5
                        Case{-100.0, 53.9, false}, Case{-100.0, 54.1, true}, Case{1.0, 3.49, false},
                        Case{1.0, 3.51, true},  // 4 - 1 x 0.5
                        Case{2.0, 2.99, false}, Case{2.0, 3.01, true}}) {
    EXPECT_EQ((CoulombStrength<double>{2.0, 4.0, 0.5, 0.0}.fails(c.normal, c.shear * c.shear)),
              c.fails)
        << c.normal << ' ' << c.shear;
  }
}

TEST(CoulombStrength, TensionBeyondTheConeLeavesNoShearStrength) {
  // cohesion 1, tan phi 1, tension 5: at normal 3 the line is below zero, the strength is none
  const CoulombStrength<double> strength{5.0, 1.0, 1.0, 0.0};
  EXPECT_FALSE(strength.fails(3.0, 0.0));
  EXPECT_TRUE(strength.fails(3.0, 1e-18));
}

TEST(CoulombStrength, NeverUnderPureCompression) {
  for (double normal = -1e-3; normal > -1e13; normal *= 10.0) {
    for (const double strength : {0.0, 1.0, 1e6}) {
      for (const double friction : {0.0, 0.7, 3.0}) {
        const CoulombStrength<double> joint{strength, strength, friction, 0.0};
        EXPECT_FALSE(joint.fails(normal, 0.0));
        const double shear = -0.999 * friction * normal;
        EXPECT_FALSE(joint.fails(normal, shear * shear));
      }
    }
  }
}

}  // namespace
}  // namespace muckpile
