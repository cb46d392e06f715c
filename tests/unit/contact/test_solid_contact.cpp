// SPDX-License-Identifier: GPL-2.0-or-later
// Bodies that collide, slide, stand and part, against conservation and closed forms.
// Scope: a leapfrog in the test moves them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "../geometry/shapes.h"
#include "contact/polyhedra/solid.h"
#include "contact/polyhedra/solid_contact.h"
#include "input_error_of.h"
#include "tumbling_solids.h"

namespace muckpile {
namespace {

using test::TumblingSolids;

constexpr double kDensity = 2700.0;  // [kg/m3]
constexpr double kGravity = 9.81;    // [m/s2]

ContactParameters parameters(double restitution, double friction, double modulus = 1e8) {
  ContactParameters p;
  p.youngs_modulus = modulus;
  p.restitution = restitution;
  p.friction = friction;
  return p;
}

Polyhedron cube(double edge) {
  return test::box(Vec3::Constant(-0.5 * edge), Vec3::Constant(0.5 * edge));
}

Pose at(const Vec3& centre, const Mat3& axes = Mat3::Identity()) { return {centre, axes}; }

/// Upright, with so many sides.
Polyhedron prism(int sides) {
  Polyhedron shape;
  std::vector<int> bottom, top;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / sides;
    for (const double z : {-0.5, 0.5})
      shape.vertices.emplace_back(std::cos(angle), std::sin(angle), z);
    const int next = (k + 1) % sides;
    shape.faces.push_back({2 * k, 2 * next, 2 * next + 1, 2 * k + 1});
    bottom.insert(bottom.begin(), 2 * k);
    top.push_back(2 * k + 1);
  }
  shape.faces.push_back(bottom);
  shape.faces.push_back(top);
  return shape;
}

TEST(Solids, AreRefusedWithMoreCornersOrFacesThanTheyMayHave) {
  EXPECT_NO_THROW(Solid(prism(62), at(Vec3::Zero())));
  const auto refusal = [](int sides) {
    return input_error_of([&] { Solid(prism(sides), at(Vec3::Zero())); });
  };
  EXPECT_NE(refusal(63).find("64 faces at most"), std::string::npos) << refusal(63);
  EXPECT_NE(refusal(129).find("256 corners at most"), std::string::npos) << refusal(129);
}

class Collisions : public testing::TestWithParam<unsigned> {};

// Two turning bodies meet at 5 m/s without friction and damping.
TEST_P(Collisions, ConserveEnergyMomentumAndAngularMomentum) {
  std::mt19937 random(GetParam());
  TumblingSolids world(parameters(1.0, 0.0), 2e-6);
  world.add(test::random_solid(random, Vec3(1.0, 0.8, 1.2), 6), kDensity,
            at(Vec3(-1.0, 0.1, 0.0), test::random_turn(random)), Vec3(2.5, 0, 0), Vec3(1, 3, -2));
  world.add(test::random_solid(random, Vec3(0.7, 0.8, 0.9), 6), kDensity,
            at(Vec3(0.6, -0.1, 0.1), test::random_turn(random)), Vec3(-2.5, 0, 0), Vec3(-2, 1, 2));
  const double energy = world.kinetic();
  const Vec3 momentum = world.momentum(), spin = world.angular_momentum();
  int touched = 0;
  for (int k = 0; k < 200000; ++k) {
    world.step();
    touched += world.touching();
    if (touched > 0 && world.touching() == 0) break;
  }
  for (int k = 0; k < 100000; ++k) world.step();  // long after, they may have met again
  ASSERT_GT(touched, 100);
  ASSERT_EQ(world.touching(), 0);
  std::printf("energy after over before, less 1: %.1e\n", world.kinetic() / energy - 1.0);
  EXPECT_NEAR(world.kinetic() / energy, 1.0, 1e-4);
  EXPECT_LT((world.momentum() - momentum).norm(), 1e-9 * momentum.norm() + 1e-7);
  EXPECT_LT((world.angular_momentum() - spin).norm(), 1e-9 * spin.norm());
}
INSTANTIATE_TEST_SUITE_P(Seeds, Collisions, testing::Range(1u, 7u));

enum class Feature { face, edge, corner };
class RestitutionOfSolids : public testing::TestWithParam<std::tuple<Feature, double>> {};

// A cube meets a face of another one head-on, with its face, its edge or its corner.
TEST_P(RestitutionOfSolids, IsTheAskedShareOfTheSpeedBeforeAnImpact) {
  const auto [feature, restitution] = GetParam();
  const double edge = 0.5;
  Mat3 axes = Mat3::Identity();
  double reach = 0.5 * edge;
  if (feature == Feature::edge) {
    axes = Eigen::AngleAxisd(0.25 * std::numbers::pi, Vec3::UnitY()).toRotationMatrix();
    reach *= std::sqrt(2.0);
  } else if (feature == Feature::corner) {
    axes = Quat::FromTwoVectors(Vec3::Ones(), Vec3::UnitZ()).toRotationMatrix();
    reach *= std::sqrt(3.0);
  }
  TumblingSolids world(parameters(restitution, 0.0), 2e-6);
  world.add_fixed(test::box(Vec3(-2, -2, -2), Vec3(2, 2, 2)), at(Vec3(0, 0, -2)));
  world.add(cube(edge), kDensity, at(Vec3(0, 0, reach + 1e-4), axes), Vec3(0, 0, -1.0));
  bool touched = false;
  for (int k = 0; k < 200000 && !(touched && world.touching() == 0); ++k) {
    world.step();
    touched = touched || world.touching() > 0;
  }
  const double after = world.bodies()[1].state.velocity.z();
  std::printf("restitution asked %.2f, got %.4f\n", restitution, after);
  EXPECT_NEAR(after, restitution, 0.02);
}
INSTANTIATE_TEST_SUITE_P(All, RestitutionOfSolids,
                         testing::Combine(testing::Values(Feature::face, Feature::edge,
                                                          Feature::corner),
                                          testing::Values(0.2, 0.5, 0.9)));

/// A cube put on a slope of this angle.
struct Slide {
  double start;  ///< path in the first half second [m]
  double rate;   ///< mean acceleration in the second half second [m/s2]
};
Slide slide_on_slope(double angle, double friction) {
  TumblingSolids world(parameters(0.2, friction), 5e-5);
  world.gravity = kGravity * Vec3(std::sin(angle), 0, -std::cos(angle));
  world.add_fixed(test::box(Vec3(-10, -10, -2), Vec3(10, 10, 0)), at(Vec3(0, 0, -1)));
  world.add(cube(0.4), kDensity, at(Vec3(0, 0, 0.2)));
  const SolidBody& cube = world.bodies()[1].state;
  for (int k = 0; k < 10000; ++k) world.step();
  const double path = cube.pose.centre.x(), speed = cube.velocity.x();
  for (int k = 0; k < 10000; ++k) world.step();
  return {path, (world.bodies()[1].state.velocity.x() - speed) / 0.5};
}

TEST(Slope, ACubeStaysBelowTheAngleOfFrictionAndSlidesAboveIt) {
  const double friction = 0.6, angle = std::atan(friction);
  const Slide below = slide_on_slope(angle - 0.02, friction);
  EXPECT_LT(below.start, 2e-3);
  EXPECT_NEAR(below.rate, 0.0, 1e-3);
  const double steep = angle + 0.1;
  const double closed_form = kGravity * (std::sin(steep) - friction * std::cos(steep));
  const Slide above = slide_on_slope(steep, friction);
  std::printf("slides with %.4f m/s2, closed form %.4f m/s2\n", above.rate, closed_form);
  EXPECT_NEAR(above.rate, closed_form, 5e-3 * closed_form);
}

constexpr double kEdge = 0.5, kModulus = 1e8;  // of the boxes of a stack [m], [Pa]

/// Ten boxes on a floor, each moved and turned at random by up to this [m], [rad].
TumblingSolids stack_of_ten(double off) {
  TumblingSolids world(parameters(0.2, 0.6, kModulus), 1e-4);
  world.gravity = Vec3(0, 0, -kGravity);
  world.add_fixed(test::box(Vec3(-2, -2, -0.5), Vec3(2, 2, 0.5)), at(Vec3(0, 0, -0.5)));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int k = 0; k < 10; ++k)
    world.add(cube(kEdge), kDensity,
              at(Vec3(off * share(random), off * share(random), kEdge * (k + 0.5)),
                 Eigen::AngleAxisd(off * share(random), Vec3::UnitZ()).toRotationMatrix()));
  return world;
}

// The i-th contact from the top bears i boxes on a whole face: it sinks by i m g / (E* A / c), c
// half an edge. The floor's centre lies twice as deep as a box's: E* A / 2 (1 / c + 1 / (2 c)).
TEST(Stack, SinksByWhatItsWeightPresses) {
  TumblingSolids world = stack_of_ten(0.0);
  for (int k = 0; k < 20000; ++k) world.step();
  const double weight = kDensity * kEdge * kEdge * kEdge * kGravity;
  const double stiffness = 0.5 * kModulus / (1.0 - 0.25 * 0.25) * kEdge * kEdge / (0.5 * kEdge);
  const double sunk = 9.5 * kEdge - world.bodies()[10].state.pose.centre.z();
  const double closed_form = (1 + 2 + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 10 / 0.75) * weight / stiffness;
  std::printf("top sank by %.4e m, closed form %.4e m\n", sunk, closed_form);
  EXPECT_NEAR(sunk, closed_form, 0.01 * closed_form);
  EXPECT_LT(world.kinetic(), 1e-4);
}

// A crooked stack sways, slowly and slightly, and stands.
TEST(Stack, OfTenBoxesThatAreOffByATenthStands) {
  TumblingSolids world = stack_of_ten(0.05);
  double early = 0.0, late = 0.0;
  for (int k = 0; k < 50000; ++k) {
    world.step();
    if (k >= 2000 && k < 10000) early = std::max(early, world.kinetic());
    if (k >= 42000) late = std::max(late, world.kinetic());
  }
  double moved = 0.0;
  for (std::size_t k = 1; k < 11; ++k)
    moved = std::max(moved, world.bodies()[k].state.pose.centre.head<2>().norm());
  std::printf("sways with at most %.2f J after 1 s, %.2f J after 5 s\n", early, late);
  EXPECT_EQ(world.touching(), 10);
  EXPECT_LT(moved, 0.08);
  EXPECT_LT(late, 0.25 * early);
}

TEST(Spin, OnAFaceIsStoppedByFriction) {
  TumblingSolids world(parameters(0.2, 0.5), 5e-5);
  world.gravity = Vec3(0, 0, -kGravity);
  world.add_fixed(test::box(Vec3(-2, -2, -0.5), Vec3(2, 2, 0.5)), at(Vec3(0, 0, -0.5)));
  world.add(cube(0.4), kDensity, at(Vec3(0, 0, 0.2)), Vec3::Zero(), Vec3(0, 0, 2.0));
  for (int k = 0; k < 20000; ++k) world.step();
  EXPECT_LT(world.bodies()[1].state.spin.norm(), 1e-2);
}

// Bodies made overlapped: no force, and no energy as they part.
TEST(StartOverlapped, HasNoForceAndGivesNoEnergy) {
  TumblingSolids world(parameters(1.0, 0.0), 1e-5);
  world.add(cube(1.0), kDensity, at(Vec3::Zero()));
  world.add(cube(1.0), kDensity, at(Vec3(0, 0.1, 0.9)), Vec3(0.3, 0, 0.3));
  const double energy = world.kinetic();
  for (int k = 0; k < 60000; ++k) world.step();
  EXPECT_NEAR(world.kinetic() / energy, 1.0, 1e-6);
}

// What friction and dashpots take is what the bodies lose.
TEST(Books, LossesAreWhatTheBodiesLose) {
  std::mt19937 random(11);
  TumblingSolids world(parameters(0.4, 0.5), 2e-6);
  world.add(test::random_solid(random, Vec3(1.0, 0.8, 1.2), 6), kDensity,
            at(Vec3(-0.9, 0.2, 0.0), test::random_turn(random)), Vec3(2.5, 0, 0), Vec3(1, 3, -2));
  world.add(test::random_solid(random, Vec3(0.9, 0.8, 0.9), 6), kDensity,
            at(Vec3(0.6, -0.1, 0.1), test::random_turn(random)), Vec3(-2.5, 0, 0), Vec3(-2, 1, 2));
  const double before = world.kinetic();
  for (int k = 0; k < 300000; ++k) world.step();
  ASSERT_EQ(world.touching(), 0);
  const double lost = before - world.kinetic();
  ASSERT_GT(lost, 0.05 * before);
  std::printf("lost %.1f J, booked %.1f J\n", lost, world.friction_loss() + world.damping_loss());
  EXPECT_NEAR(world.friction_loss() + world.damping_loss(), lost, 2e-3 * before);
}

}  // namespace
}  // namespace muckpile
