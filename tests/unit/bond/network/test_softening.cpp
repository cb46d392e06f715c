// SPDX-License-Identifier: GPL-2.0-or-later
// Softening by fracture energy and strength that grows with the rate of strain.
// Scope: the laws, two blocks moved by hand, and bars that fly apart.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bond_scene.h"

namespace muckpile::test {
namespace {

constexpr double kTension = 2e6, kToughness = 100.0;  // [Pa], [J/m2]

JointParameters tough_rock() {
  JointParameters p = rock(0.0);
  p.tension = kTension;
  p.cohesion = 4e6;
  p.friction_angle = p.residual_friction_angle = 0.5;
  p.fracture_energy_tension = kToughness;
  p.fracture_energy_shear = 4.0 * kToughness;
  return p;
}

TEST(Cohesion, FallsLinearlyAndTakesTheFractureEnergy) {
  // 2 MPa, 50 GPa/m: first = 40 um; end = 2 x 100 / 2e6 = 100 um.
  const Cohesion c = cohesion_after({kTension, 0, 0}, {4e-5, 0, 0}, 5e10, 5e10, tough_rock());
  ASSERT_TRUE(c.holds());
  EXPECT_NEAR(c.first, 4e-5, 1e-17);
  EXPECT_NEAR(c.end, 1e-4, 1e-17);
  EXPECT_NEAR(c.parting({4e-5, 1, 1}), 4e-5, 1e-17);
  EXPECT_NEAR(c.traction(4e-5, 4e-5), kTension, 1e-6);
  EXPECT_NEAR(c.traction(7e-5, 7e-5), 1e6, 1e-6);    // half way down
  EXPECT_NEAR(c.traction(3.5e-5, 7e-5), 5e5, 1e-6);  // half way back to the origin
  EXPECT_EQ(c.traction(1e-4, 1e-4), 0.0);
  EXPECT_EQ(c.traction(-1e-5, 7e-5), 0.0);
}

TEST(Cohesion, MixesTheFractureEnergiesByTheirShareOfTheTraction) {
  const Cohesion c = cohesion_after({3e6, 4e6, 0}, Vec3::Zero(), 5e12, 5e12, tough_rock());
  // 0.36 x 100 + 0.64 x 400 = 292 J/m2 at 5 MPa
  EXPECT_NEAR(c.end, 2.0 * 292.0 / 5e6, 1e-17);
}

TEST(Cohesion, HoldsNothingIfTheBlocksAreTooLarge) {
  // elastic energy at the strength: 2e6^2 / (2 x 1e10) = 200 J/m2 > 100
  EXPECT_FALSE(cohesion_after({kTension, 0, 0}, Vec3::Zero(), 1e10, 1e10, tough_rock()).holds());
  JointParameters brittle = tough_rock();
  brittle.fracture_energy_tension = 0.0;
  EXPECT_FALSE(cohesion_after({kTension, 0, 0}, Vec3::Zero(), 5e10, 5e10, brittle).holds());
}

TEST(RateFactor, IsAPowerOfTheRateAboveTheReference) {
  EXPECT_EQ(rate_factor(100.0, 1e-6, rock(0.0).rate_exponent), 1.0);  // off by default
  EXPECT_NEAR(rate_factor(1.0, 1e-6, 0.05), std::pow(10.0, 0.3), 1e-12);
  EXPECT_EQ(rate_factor(1e-7, 1e-6, 0.05), 1.0);
}

/// Two unit cubes side by side along x; block 1 is moved by hand at `speed` [m/s].
struct HandTest {
  explicit HandTest(const JointParameters& p) : scene(cuboids(2, 1, 1), p) { scene.compute(); }
  void move(const Vec3& path, double speed, int steps) {
    const double dt = path.norm() / steps / speed;
    for (int k = 0; k < steps; ++k) {
      const Vec3 before = scene.network().force()[0];
      scene.block(1).centre += path / steps;
      scene.block(1).velocity = path / (steps * dt);
      scene.compute(dt);
      const Vec3 now = scene.network().force()[0];
      work += 0.5 * (before + now).dot(path / steps);
      peak = std::max(peak, now.norm());
    }
  }
  [[nodiscard]] double fracture() { return scene.network().losses().fracture; }
  BondScene scene;
  double work = 0.0, peak = 0.0;  // [J], [N]
};

TEST(Softening, PullingApartTakesTheFractureEnergy) {
  HandTest pull(tough_rock());
  pull.move({2e-4, 0, 0}, 1e-3, 4000);
  EXPECT_NEAR(pull.peak / kTension, 1.0, 2e-3);  // steps of 50 nm of 40 um
  EXPECT_NEAR(pull.work / kToughness, 1.0, 2e-3);
  EXPECT_NEAR(pull.fracture() / kToughness, 1.0, 2e-3);
  EXPECT_EQ(pull.scene.network().force()[0].norm(), 0.0);
}

TEST(Softening, PullingABlockOffAMirrorTakesHalfTheFractureEnergy) {  // its image takes the rest
  BondScene scene(cuboids(1, 1, 1, {0.4, 1, 1}), tough_rock(),  // room for a toughness of 50 J/m2
                  [](const Vec3& at) { return at.x() < 1e-6 ? Support::mirror : Support::free; });
  scene.compute();
  constexpr double kPath = 1e-4, kSpeed = 1e-3;  // [m], [m/s]
  constexpr int kSteps = 4000;
  double work = 0.0;
  scene.block(0).velocity = {kSpeed, 0.0, 0.0};
  for (int k = 0; k < kSteps; ++k) {
    const double before = scene.network().force()[0].x();
    scene.block(0).centre.x() += kPath / kSteps;
    scene.compute(kPath / kSteps / kSpeed);
    work -= 0.5 * (before + scene.network().force()[0].x()) * kPath / kSteps;
  }
  EXPECT_NEAR(work / (0.5 * kToughness), 1.0, 2e-3);
  EXPECT_NEAR(scene.network().losses().fracture / work, 1.0, 2e-3);
  EXPECT_EQ(scene.network().force()[0].norm(), 0.0);
}

TEST(Softening, UnloadingGivesBackWhatIsStored) {
  HandTest pull(tough_rock());
  pull.move({7e-5, 0, 0}, 1e-3, 1400);
  const double taken = pull.fracture();
  EXPECT_NEAR(pull.scene.network().elastic_energy(), 0.5 * 1e6 * 7e-5, 0.3);
  pull.move({-6e-5, 0, 0}, 1e-3, 1200);
  EXPECT_NEAR(pull.scene.network().force()[0].x(), 1e6 / 7.0, 2e3);  // on the line to the origin
  pull.move({6e-5, 0, 0}, 1e-3, 1200);
  EXPECT_NEAR(pull.fracture() / taken, 1.0, 1e-9);
  pull.move({1e-4, 0, 0}, 1e-3, 2000);
  EXPECT_NEAR(pull.fracture() / kToughness, 1.0, 2e-3);
  EXPECT_NEAR(pull.work / pull.fracture(), 1.0, 2e-3);
}

TEST(Softening, ShearTakesItsFractureEnergyBesideFriction) {
  HandTest slide(tough_rock());
  slide.move({-1e-4, 0, 0}, 1e-3, 100);  // 5 MPa
  const double squeezed = slide.work;
  slide.move({0, 4e-4, 0}, 1e-3, 8000);
  // Cohesion alone is dropped, residual and peak friction are the same: 4 MPa, 400 J/m2.
  EXPECT_NEAR(slide.fracture() / (4.0 * kToughness), 1.0, 5e-3);
  const JointLosses& lost = slide.scene.network().losses();
  EXPECT_NEAR((slide.scene.network().elastic_energy() + lost.fracture + lost.friction) / slide.work,
              1.0, 2e-3);
  EXPECT_GT(slide.work, squeezed);
  EXPECT_NEAR(slide.scene.network().force()[0].y() / (5e6 * std::tan(0.5)), 1.0, 1e-6);
}

TEST(Softening, FacesThatNoLongerMatchHoldNothing) {
  JointParameters p = tough_rock();
  p.fracture_energy_tension = 1e6;  // would hold up to 2 x 1e6 / 2e6 = 1 m
  HandTest pull(p);
  pull.move({0.1, 0, 0}, 1e-3, 4000);  // a tenth of the radius is sqrt(1/pi)/10 = 0.056 m
  EXPECT_EQ(pull.scene.network().force()[0].norm(), 0.0);
  EXPECT_EQ(pull.scene.network().elastic_energy(), 0.0);
  EXPECT_NEAR(pull.fracture() / pull.work, 1.0, 2e-3);  // all is booked
}

TEST(RateDependence, FastPullingNeedsMoreStress) {
  JointParameters p = rock(0.0);
  p.tension = kTension;
  p.rate_exponent = 0.05;
  p.reference_rate = 1e-6;
  HandTest slow(p), fast(p);
  slow.move({2e-4, 0, 0}, 1e-7, 4000);  // centres 1 m apart: rates in 1/s
  fast.move({2e-4, 0, 0}, 1.0, 4000);
  EXPECT_NEAR(slow.peak / kTension, 1.0, 2e-3);
  EXPECT_NEAR(fast.peak / (kTension * std::pow(10.0, 0.3)), 1.0, 2e-3);
}

TEST(RateDependence, CohesionHasAReferenceRateOfItsOwn) {
  JointParameters p = rock(0.0);
  p.tension = kTension;
  p.cohesion = 1e6;
  p.friction_angle = p.residual_friction_angle = 0.0;
  p.rate_exponent = 1.0 / 3.0;
  p.reference_rate = 1.0;
  p.reference_rate_shear = 8.0;
  HandTest pull(p), slide(p), gently(p);
  pull.move({2e-3, 0, 0}, 64.0, 4000);   // (64/1)^(1/3) = 4 times the tension
  slide.move({0, 2e-3, 0}, 64.0, 4000);  // (64/8)^(1/3) = 2 times the cohesion
  gently.move({0, 2e-3, 0}, 8.0, 4000);
  EXPECT_NEAR(pull.peak / (4.0 * kTension), 1.0, 5e-3);
  EXPECT_NEAR(slide.peak / 2e6, 1.0, 5e-3);
  EXPECT_NEAR(gently.peak / 1e6, 1.0, 5e-3);
}

}  // namespace
}  // namespace muckpile::test
