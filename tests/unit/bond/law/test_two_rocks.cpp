// SPDX-License-Identifier: GPL-2.0-or-later
// What lies between two rocks: the split of the jump, strengths, dashpots, how many laws there are.
// Scope: the laws by themselves, and dashpots of one facet by every path of the passes.
#include <gtest/gtest.h>

#include "args/input_error.h"
#include "bond/law/barton_bandis.h"
#include "bond/law/two_rocks.h"
#include "zoned_scene.h"

namespace muckpile::test {
namespace {

TEST(TwoRocks, AreInSeries) {
  // nu = 0: 2G = lambda + 2G = E. d/E = 0.5/50e9 + 0.25/10e9 = 1e-11 + 2.5e-11 = 3.5e-11 m/Pa.
  JointParameters other = soft(0.0);
  const TwoRocks both = two_rocks(JointMaterial(rock(0.0)), 0.5, JointMaterial(other), 0.25);
  EXPECT_NEAR(both.uniaxial, 1.0 / 3.5e-11, 1e-3);
  EXPECT_NEAR(both.shear, 1.0 / 3.5e-11, 1e-3);
  EXPECT_NEAR(both.normal, 1.0 / 3.5e-11, 1e-3);
  // Strain of the hard side per jump: U/E = 1/(3.5e-11 x 50e9) = 0.571 1/m, times 0.75 m.
  EXPECT_NEAR(both.along[0], 0.75 / 1.75, 1e-12);
  EXPECT_NEAR(both.along[1], 0.75 / 0.35, 1e-12);
  EXPECT_NEAR(both.across[0], 0.75 / 1.75, 1e-12);
  // d_i e_i + d_j e_j is the jump.
  EXPECT_NEAR((0.5 * both.along[0] + 0.25 * both.along[1]) / 0.75, 1.0, 1e-12);
}

TEST(TwoRocks, OfTheSameRockAreThatRock) {
  const JointMaterial one(rock(0.3));
  const TwoRocks both = two_rocks(one, 0.4, one, 0.7);
  const FacetStiffness k = one.facet_stiffness(1.1);
  EXPECT_NEAR(both.normal, k.normal, 1e-5);
  EXPECT_NEAR(both.shear, k.shear, 1e-5);
  for (const double share : {both.along[0], both.along[1], both.across[0], both.across[1]})
    EXPECT_NEAR(share, 1.0, 1e-14);
}

TEST(TwoRocks, AreAsStrongAsTheWeakerOfThem) {
  JointParameters a = rock(0.25), b = soft();
  a.tension = 8e6, b.tension = 2e6;
  a.cohesion = 1e6, b.cohesion = 3e6;
  a.friction_angle = 0.8, b.friction_angle = 0.7;
  a.fracture_energy_tension = 50.0, b.fracture_energy_tension = 20.0;
  a.reference_rate = 1.0, b.reference_rate = 30.0;
  const JointLaws laws(JointMaterial(a), {}, {JointMaterial(b)});
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 0}}) {
    const JointParameters& p = laws.of_law(laws.law_of(0, i, j)).parameters();
    EXPECT_EQ(p.tension, 2e6);
    EXPECT_EQ(p.cohesion, 1e6);
    EXPECT_EQ(p.friction_angle, 0.7);
    EXPECT_EQ(p.fracture_energy_tension, 20.0);
    EXPECT_EQ(p.reference_rate, 30.0);
  }
  EXPECT_EQ(laws.of_law(laws.law_of(0, 1, 1)).parameters().cohesion, 3e6);
}

TEST(TwoRocks, HaveTheJointOfTheirBorderWhereItIsNatural) {
  JointClass open;
  open.friction_angle = 0.5;
  const JointLaws laws(JointMaterial(rock(0.25)), {open}, {JointMaterial(soft())});
  const std::uint8_t law = laws.law_of(1, 0, 1);
  EXPECT_EQ(laws.class_of(law), 1);
  EXPECT_EQ(laws.zone_i(law), 0);
  EXPECT_EQ(laws.zone_j(law), 1);
  EXPECT_EQ(laws.of_law(law).parameters().tension, 0.0);
}

TEST(JointLaws, RefuseMoreZonesThanTheyHaveNumbersFor) {
  const std::vector<JointMaterial> zones(12, JointMaterial(soft()));
  const std::vector<JointClass> classes(1);
  EXPECT_THROW(JointLaws(JointMaterial(rock(0.25)), classes, zones), InputError);
}

/// Dashpots of two rocks: half of the lesser impedance where the shares are 0.5 and 0.7.
struct Damped {
  JointParameters hard = rock(0.25), other = soft();
  double lesser;

  Damped() {
    hard.damping = 0.5, other.damping = 0.7;
    hard.contact_damping = 0.3, other.contact_damping = 0.2;
    // Of the softer and lighter rock: (10e9 x 0.6 / (1.4 x 0.2) x 2200)^(1/2).
    lesser = std::sqrt(10e9 * 0.6 / (1.4 * 0.2) * 2200.0);
  }
};

TEST(TwoRocks, HaveADashpotOfTheLesserImpedanceOnBothSides) {
  const Damped of;
  const JointLaws laws(JointMaterial(of.hard), std::vector<JointClass>(1),
                       {JointMaterial(of.other)});
  for (const std::size_t joint_class : {0u, 1u})
    for (const auto& [i, j] : {std::pair{0, 1}, {1, 0}}) {
      const std::size_t law = laws.law_of(joint_class, i, j);
      EXPECT_NEAR(laws.damping(law) / (0.5 * of.lesser), 1.0, 1e-12);
      EXPECT_NEAR(laws.contact_damping(law) / (0.2 * of.lesser), 1.0, 1e-12);
    }
  EXPECT_NEAR(laws.damping(laws.law_of(0, 1, 1)) / (0.7 * of.lesser), 1.0, 1e-12);
}

TEST(TwoRocks, DampAFacetThatIsWorkedOnAloneAsOneInAGroup) {
  constexpr double kStep = 1e-7, kSpeed = 0.1;  // [s], [m/s]; 1 m2 between them
  const Damped of;
  BartonBandis law{.initial_stiffness = 1e13,
                   .closure_limit = 1e-4,
                   .roughness = 10.0,
                   .wall_strength = 1e8,
                   .residual_angle = 0.5,
                   .largest_angle = 1.2,
                   .tension = 1e12,
                   .initial_aperture = 2e-4};
  const NaturalJoints alone{{barton_bandis_class(law, 1e13)}, {{Vec3(1, 0, 0), Vec3::UnitX(), 1}}};
  for (const bool hard_first : {true, false})
    for (const NaturalJoints& joint : {NaturalJoints{}, alone}) {
      const ZonedBlocks rock =
          in_zones(cuboids(2, 1, 1), [&](const Vec3& x) { return (x.x() < 1.0) != hard_first; });
      BondScene scene(rock.blocks, of.hard, [](const Vec3&) { return Support::free; }, joint,
                      Leaning::little, {{of.other}, rock.of});
      ASSERT_EQ(scene.network().tables().alone_lanes(0), joint.classes.empty() ? 0u : 1u);
      scene.block(1).velocity = Vec3(kSpeed, 0, 0);
      scene.compute(kStep);
      const double expected = 0.5 * of.lesser * kSpeed;  // on 1 m2
      EXPECT_NEAR(scene.network().force()[0].x() / expected, 1.0, 1e-9);
      EXPECT_NEAR(scene.network().losses().damping / (expected * kSpeed * kStep), 1.0, 1e-9);
    }
}

}  // namespace
}  // namespace muckpile::test
