// SPDX-License-Identifier: GPL-2.0-or-later
// Natural joints: facets found by their plane, and stiffness and strength of their own.
// Scope: cuboids moved by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "args/input_error.h"
#include "bond_scene.h"

namespace muckpile::test {
namespace {

constexpr double kRounding = 1e-9;  // of jumps of 1e-5 m at coordinates of 1 m

JointParameters strong_rock() {
  JointParameters p = rock(0.25);
  p.tension = 3e6;
  p.cohesion = 5e6;
  return p;
}

JointClass weak_joint() {
  JointClass joint;
  joint.tension = 1e6;
  joint.cohesion = 2e6;
  joint.friction_angle = joint.residual_friction_angle = 0.5;
  joint.normal_stiffness = 4e10;
  joint.shear_stiffness = 1e10;
  return joint;
}

/// Three unit cubes along x; the one between the second and third is a natural joint.
NaturalJoints second_facet() { return {{weak_joint()}, {{Vec3(2, 0, 0), Vec3(2, 0, 0), 1}}}; }

BondScene row() {
  return {cuboids(3, 1, 1), strong_rock(), [](const Vec3&) { return Support::free; },
          second_facet()};
}

int facets_of_class(FacetNetwork& network, int joint_class) {
  int count = 0;
  for (const Facet& facet : network.facets()) count += facet.joint_class == joint_class ? 1 : 0;
  return count;
}

int marked(const JointPlane& plane) {
  BondScene scene(cuboids(4, 3, 3), rock(0.25), [](const Vec3&) { return Support::fixed; },
                  {{weak_joint()}, {plane}});
  return facets_of_class(scene.network(), 1);
}

TEST(JointClasses, FacetsAreFoundByTheirPlane) {
  EXPECT_EQ(marked({Vec3(2, 0, 0), Vec3(-3, 0, 0), 1}), 9);               // 3 x 3 facets
  EXPECT_EQ(marked({Vec3(2, 1.5, 1.5), Vec3::UnitX(), 1, 1.2}), 5);       // centre and 4 beside it
  EXPECT_EQ(marked({Vec3(0, 0, 0), Vec3::UnitX(), 1}), 0);                // supports are no joints
  EXPECT_EQ(marked({Vec3(2.01, 0, 0), Vec3::UnitX(), 1}), 0);             // beside the facets
  EXPECT_EQ(marked({Vec3(2, 1.5, 1.5), Vec3(1.0, 0.01, 0.0), 1, 9}), 0);  // tilted
}

TEST(JointClasses, DipAndDipDirectionGiveTheNormal) {
  const double right = M_PI / 2.0;
  EXPECT_LT((normal_of_dip(0.0, 1.0) - Vec3::UnitZ()).norm(), 1e-15);      // flat
  EXPECT_LT((normal_of_dip(right, right) - Vec3::UnitX()).norm(), 1e-15);  // upright, faces east
  // Dips 30 degrees to the north: falls by 1 m over sqrt(3) m of y.
  EXPECT_NEAR(normal_of_dip(M_PI / 6.0, 0.0).dot(Vec3(0.0, std::sqrt(3.0), -1.0)), 0.0, 1e-15);
}

TEST(JointClasses, TheFirstPlaneWins) {
  BondScene scene(cuboids(2, 1, 1), rock(0.25), [](const Vec3&) { return Support::free; },
                  {{weak_joint(), weak_joint()},
                   {{Vec3(1, 0, 0), Vec3::UnitX(), 2}, {Vec3(1, 0, 0), Vec3::UnitX(), 1}}});
  EXPECT_EQ(facets_of_class(scene.network(), 2), 1);
}

TEST(JointClasses, OwnStrengthHoldsAtTheNaturalJointOnly) {
  BondScene scene = row();
  const auto pull = [&](double share) {  // so that both facets carry about the same
    scene.block(1).centre.x() = scene.start(1).x() + share * 1e-5;
    scene.block(2).centre.x() = scene.start(2).x() + share * 4e-5;
    scene.compute(1e-6);
  };
  pull(0.1);
  EXPECT_EQ(scene.network().broken_count(), 0.0);
  const auto traction = [&](std::size_t f) { return scene.network().mean_traction(f).x(); };
  const double to_break = 0.1 * 1e6 / traction(1);
  pull(0.999 * to_break);
  EXPECT_EQ(scene.network().broken_count(), 0.0);
  pull(1.001 * to_break);
  EXPECT_EQ(scene.network().states()[0], FacetState::intact);
  EXPECT_NE(scene.network().states()[1], FacetState::intact);
}

TEST(JointClasses, OwnShearStiffnessIsInSeriesWithTheRock) {
  BondScene scene = row();
  const double slide = 1e-6;
  scene.block(1).centre.y() = scene.start(1).y() + slide;
  scene.block(2).centre.y() = scene.start(2).y() + 2.0 * slide;
  scene.compute();
  const double rock_shear = 40e9;                         // 2G/h [Pa/m]
  const double series = 1.0 / (1.0 / 40e9 + 1.0 / 10e9);  // 8e9 Pa/m
  EXPECT_NEAR(scene.network().mean_traction(0).y() / (rock_shear * slide), 1.0, kRounding);
  EXPECT_NEAR(scene.network().mean_traction(1).y() / (series * slide), 1.0, kRounding);
}

TEST(JointClasses, SofteningReachesEveryClass) {
  BondScene scene = row();
  scene.block(2).centre += Vec3(1e-6, 2e-6, 0.0);
  scene.compute();
  const Vec3 before = scene.network().mean_traction(1);
  scene.network().soften(0.1);
  scene.compute();
  EXPECT_NEAR((scene.network().mean_traction(1) - 0.1 * before).norm() / before.norm(), 0.0,
              kRounding);
}

TEST(JointClasses, ResidualFrictionIsThatOfTheClass) {
  BondScene scene = row();
  const double squeeze = 1e-5, slide = 1e-3;
  scene.block(2).centre += Vec3(-squeeze, slide, 0.0);
  for (int k = 0; k < 2; ++k) scene.compute(1e-6);  // breaks, then slips
  ASSERT_NE(scene.network().states()[1], FacetState::intact);
  // Block 2 has no other facet.
  const Vec3 force = scene.network().force()[2];
  EXPECT_NEAR(std::abs(force.y() / force.x()) / std::tan(0.5), 1.0, kRounding);
}

/// Of the facet between blocks 0 and 1, or that of block 0 to its support, once it is broken, from
/// the force on the block that closes it; per area [Pa/m].
double closed_stiffness(const NaturalJoints& natural, const SupportRule& support) {
  JointParameters p = strong_rock();
  p.tension = 0.0;
  NaturalJoints weak = natural;
  for (JointClass& joint : weak.classes) joint.tension = 0.0;
  const bool supported = support(Vec3::Zero()) != Support::free;
  BondScene scene(cuboids(supported ? 1 : 2, 1, 1), p, support, weak);
  const std::size_t moved = supported ? 0 : 1;
  const double opened = 1e-9, squeeze = 1e-5;  // [m]; it carries nothing where it broke
  scene.block(moved).centre.x() += opened;
  scene.compute(1e-6);
  scene.block(moved).centre.x() -= squeeze;
  scene.compute(1e-6);
  EXPECT_EQ(scene.network().broken_count(), supported ? 0.0 : 1.0);
  return scene.network().force()[moved].x() / squeeze;
}

TEST(JointClasses, ClosedBrokenFacetsAreAsStiffAsRockAndJointInSeries) {
  const auto free = [](const Vec3&) { return Support::free; };
  const JointPlane plane{Vec3(1, 0, 0), Vec3::UnitX(), 1};
  // (lambda + 2G)/h = 60e9 Pa over 1 m, and 4e10 Pa/m of the joint: 60 x 40/(60 + 40) = 24.
  EXPECT_NEAR(closed_stiffness({}, free) / 60e9, 1.0, kRounding);
  EXPECT_NEAR(closed_stiffness({{weak_joint()}, {plane}}, free) / 24e9, 1.0, kRounding);
  // Supports are half a block away.
  for (const Support support : {Support::fixed, Support::mirror}) {
    const auto at_x = [support](const Vec3& at) { return at.x() < 1e-6 ? support : Support::free; };
    EXPECT_NEAR(closed_stiffness({}, at_x) / 120e9, 1.0, kRounding);
  }
}

TEST(JointClasses, UnknownClassAndBadValuesAreRefused) {
  NaturalJoints natural = second_facet();
  natural.planes.front().joint_class = 2;
  const auto make = [&] {
    BondScene scene(
        cuboids(3, 1, 1), strong_rock(), [](const Vec3&) { return Support::free; }, natural);
  };
  EXPECT_THROW(make(), std::out_of_range);
  natural = second_facet();
  natural.classes.front().shear_stiffness = -1.0;
  EXPECT_THROW(make(), InputError);
}

}  // namespace
}  // namespace muckpile::test
