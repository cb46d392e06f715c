// SPDX-License-Identifier: GPL-2.0-or-later
// Walls of broken joints that crush: pressure, what stays after unloading, energy.
// Scope: two blocks moved by hand, against the closed form, and Voronoi rock that is run together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

#include "args/input_error.h"
#include "bond/law/barton_bandis.h"
#include "bond/law/two_rocks.h"
#include "bond_scene.h"
#include "loose_rock.h"

namespace muckpile::test {
namespace {

/// Two unit cubes side by side along x; block 1 is moved by hand at 1 m/s. Their facet is of 1 m2,
/// so forces [N] are tractions [Pa].
class Squeezed {
 public:
  explicit Squeezed(const JointParameters& p) : scene(cuboids(2, 1, 1), p) { scene.compute(); }
  /// In equal steps; the work is summed.
  void move(const Vec3& path, int steps) {
    const double dt = path.norm() / steps;
    scene.block(1).velocity = path / (steps * dt);
    for (int k = 0; k < steps; ++k) {
      const Vec3 before = scene.network().force()[0];
      scene.block(1).centre += path / steps;
      scene.compute(dt);
      work += 0.5 * (before + scene.network().force()[0]).dot(path / steps);
    }
  }
  [[nodiscard]] double pressure() { return -scene.network().force()[0].x(); }
  [[nodiscard]] const JointLosses& lost() { return scene.network().losses(); }
  /// Work less what is stored and lost [J].
  [[nodiscard]] double missing() {
    return work - scene.network().elastic_energy() - lost().fracture - lost().friction;
  }
  BondScene scene;
  double work = 0.0;  // [J]
};

// nu 0.25: lambda + 2G = 1.2 E = 60 GPa, so a contact between cubes of 1 m carries 50 MPa where it
// is closed by 5/6 mm.
constexpr double kElastic = 50e6 / 60e9;  // [m]

/// Opened by 1 um, which breaks it and is where the contact carries nothing, then closed by 0.5 mm.
Squeezed closed_contact() {
  Squeezed pair(loose_rock(0.25));
  pair.move({1e-6, 0, 0}, 1);
  pair.move({-0.5e-3, 0, 0}, 10);
  return pair;
}

TEST(WallStrength, APressedContactCrushesAndUnloadsAlongItsElasticLine) {
  Squeezed pair = closed_contact();
  EXPECT_NEAR(pair.pressure() / 30e6, 1.0, 1e-9);
  pair.move({-1.5e-3, 0, 0}, 30);  // closed by 2 mm
  EXPECT_NEAR(pair.pressure() / kWalls, 1.0, 1e-12);
  pair.move({0.5 * kElastic, 0, 0}, 10);
  EXPECT_NEAR(pair.pressure() / (0.5 * kWalls), 1.0, 1e-9);
  pair.move({0.49 * kElastic, 0, 0}, 10);
  EXPECT_NEAR(pair.pressure() / (0.01 * kWalls), 1.0, 1e-7);
  pair.move({0.02 * kElastic, 0, 0}, 1);
  EXPECT_EQ(pair.pressure(), 0.0);  // open, though 1.16 mm closer than before
  pair.move({-0.51 * kElastic, 0, 0}, 10);
  EXPECT_NEAR(pair.pressure() / (0.5 * kWalls), 1.0, 1e-9);  // along the same line
}

TEST(WallStrength, CrushingTakesPressureTimesWhatStays) {
  Squeezed pair = closed_contact();
  const double stored = pair.scene.network().elastic_energy();
  EXPECT_NEAR(stored / (0.5 * 30e6 * 0.5e-3), 1.0, 1e-9);
  pair.work =
      stored;  // what comes before, an opening and a closing between two steps, is not exact
  const double before = pair.lost().crushing;
  pair.move({0.5e-3 - kElastic, 0, 0}, 10);  // to the bound: a step across it is a trapezoid
  pair.move({kElastic - 2e-3, 0, 0}, 30);
  const double taken = kWalls * (2e-3 - kElastic);  // [J]: 58 kJ
  EXPECT_NEAR((pair.lost().crushing - before) / taken, 1.0, 1e-9);
  EXPECT_EQ(pair.lost().friction, pair.lost().crushing);
  for (const double path :
       {0.7 * kElastic, -0.3 * kElastic, -0.4 * kElastic, -1e-4, 0.9 * kElastic})
    pair.move({path, 0, 0}, 10);  // up and down, once further: a cycle to rounding
  EXPECT_NEAR((pair.lost().crushing - before) / (taken + kWalls * 1e-4), 1.0, 1e-9);
  EXPECT_LT(std::abs(pair.missing()), 1e-9 * pair.work);
}

TEST(WallStrength, FrictionGrowsNoFurtherThanThePressure) {
  Squeezed pair = closed_contact();
  pair.move({-2.5e-3, 0, 0}, 50);
  pair.move({0, 4e-3, 0}, 100);
  EXPECT_NEAR(pair.scene.network().force()[0].y() / (kWalls * std::tan(0.5)), 1.0, 1e-6);
}

// A point that slips in the dilatations of two cubes with five free faces each closes with
// 2G/h + lambda/(2 h s), s = 1 + 2.5 lambda/(2G) (theory/joints.md): 40 + 20/4.5 GPa/m.
constexpr double kSlipping = 40e9 + 20e9 / 4.5;  // [Pa/m]

/// Of the work: of first order in the step.
double missing_share(int steps) {
  Squeezed pair(loose_rock(0.25));
  pair.move({-5e-4, 0, 0}, steps);
  pair.move({0, 2e-3, 0}, steps);
  EXPECT_TRUE(pair.scene.network().traces()[0].slipping.any());
  pair.move({-2.5e-3, 0, 0}, steps);
  EXPECT_TRUE(pair.scene.network().traces()[0].slipping.any());
  EXPECT_NEAR(pair.pressure() / kWalls, 1.0, 1e-9);
  EXPECT_NEAR(pair.lost().crushing / (kWalls * (3e-3 - kWalls / kSlipping)), 1.0, 1e-2);
  const double crushed = pair.lost().crushing;
  pair.move({5e-4, 0, 0}, steps);
  EXPECT_NEAR(pair.pressure() / (kWalls - 5e-4 * kSlipping), 1.0, 2e-2);
  EXPECT_NEAR(pair.lost().crushing / crushed, 1.0, 5e-3);  // what a step leaves follows
  return std::abs(pair.missing()) / pair.work;
}

TEST(WallStrength, AFacetThatSlipsCrushesInTheDilatationsOfItsBlocks) {
  const double coarse = missing_share(800), fine = missing_share(3200);
  std::cout << "missing: " << coarse << ", " << fine << '\n';
  EXPECT_LT(fine, 1e-4);
  EXPECT_LT(fine, 0.3 * coarse);
}

TEST(WallStrength, AContactThatClosesAndCrushesInOneStepGivesNothingBack) {
  Squeezed pair(loose_rock(0.25, 1e6));  // carried by 17 um
  pair.move({1e-4, 0, 0}, 1);
  pair.move({-0.5e-4, 0, 0}, 1);
  double taken = pair.lost().crushing;
  for (int k = 0; k < 20; ++k) {
    pair.move({k % 2 == 0 ? -3e-4 : 1e-4, 0, 0}, 1);
    EXPECT_GE(pair.lost().crushing, taken) << k;
    taken = pair.lost().crushing;
  }
  // Closed before the first of the ten, open before the others, for which a step is a triangle.
  const double carries = 1e6 / 60e9;  // [m]
  EXPECT_NEAR(taken, 0.5e6 * (5e-5 - carries) + 1e6 * 3e-4 + 9 * 0.5e6 * (3e-4 - carries), 1e-3);
}

/// Voronoi rock, squeezed alike in all directions to three times the strength of its walls inside,
/// of which every facet slips in the first step. Facets with a pressure above 1.5 times the
/// strength have `least` of it when all have crushed once; then the rock bursts apart.
struct Release {
  double crushed, account, least;  // the former two over the energy at the start
};
Release release(double step_share) {
  JointParameters p = loose_rock(0.25);
  p.friction_angle = p.residual_friction_angle = 0.0;  // any shear breaks, and none is left
  BondScene scene(voronoi_blocks(4.0, 3, 10), p);
  const double squeezed = 3.0 * kWalls * (1.0 - 2.0 * p.poisson_ratio) / p.youngs_modulus;
  scene.deform(-squeezed * Mat3::Identity());
  const auto pressures = [&] {
    scene.compute(0.0);  // what the last one changed counts in the sums
    std::vector<double> of;
    for (std::size_t f = 0; f < scene.network().facet_count(); ++f)
      of.push_back(-scene.network().facets()[f].normal.dot(scene.network().mean_traction(f)));
    return of;
  };
  const std::vector<double> before = pressures();
  const double start = scene.network().elastic_energy(), dt = step_share * scene.stable_step();
  Release now{0.0, 0.0, 1e30};
  scene.compute(dt);
  const std::vector<double> after = pressures();
  for (std::size_t f = 0; f < before.size(); ++f)
    if (before[f] > 1.5 * kWalls) now.least = std::min(now.least, after[f] / kWalls);
  for (int k = 0; k < static_cast<int>(20.0 / step_share); ++k) {
    scene.step(dt);
    now.account = std::max(now.account, std::abs(scene.energy_account() / start - 1.0));
  }
  now.crushed = scene.network().losses().crushing / start;
  return now;
}

TEST(WallStrength, RockThatSlipsUnderThreeTimesTheStrengthComesDownToItAndNoFurther) {
  const Release coarse = release(0.2), fine = release(0.05);
  for (const Release& now : {coarse, fine})
    std::cout << "crushed " << now.crushed << ", account " << now.account << ", least " << now.least
              << '\n';
  for (const Release& now : {coarse, fine}) {
    EXPECT_GT(now.crushed, 0.3);
    EXPECT_LT(now.account, 0.02);
    EXPECT_GT(now.least, 0.9);
  }
}

/// Loose Voronoi rock of 4 m runs together at 10 m/s at its surface.
struct Collapse {
  double crushed, account, left;  // over the energy at the start; `left`: kinetic
};
Collapse collapse(double wall_strength) {
  BondScene scene(voronoi_blocks(4.0, 3, 10), loose_rock(0.25, wall_strength));
  Vec3 middle = Vec3::Zero();
  for (std::size_t b = 0; b < scene.size(); ++b)
    middle += scene.start(b) / static_cast<double>(scene.size());
  for (std::size_t b = 0; b < scene.size(); ++b)
    scene.block(b).velocity = -5.0 * (scene.start(b) - middle);
  scene.compute();
  const double start = scene.energy_account(), dt = 0.2 * scene.stable_step();
  double worst = 0.0;
  for (double time = 0.0; time < 2e-3; time += dt) {
    scene.step(dt);
    worst = std::max(worst, std::abs(scene.energy_account() / start - 1.0));
  }
  return {scene.network().losses().crushing / start, worst, scene.kinetic_energy() / start};
}

TEST(WallStrength, TheEnergyOfRockThatRunsTogetherIsAccountedFor) {
  const Collapse hard = collapse(std::numeric_limits<double>::infinity()), soft = collapse(kWalls);
  std::cout << "crushed " << soft.crushed << ", account " << soft.account << " (" << hard.account
            << " without), left " << soft.left << " (" << hard.left << " without)\n";
  EXPECT_EQ(hard.crushed, 0.0);
  EXPECT_GT(soft.crushed, 0.1);
  EXPECT_LT(soft.account, 0.01);
  EXPECT_LT(soft.left, hard.left);
}

TEST(WallStrength, IsTheRocksUnlessAClassHasItsOwnAndTheLesserBetweenTwoRocks) {
  const JointMaterial rock(loose_rock(0.25));
  JointClass joint;
  EXPECT_EQ(rock.with_joints(joint).parameters().wall_strength, kWalls);
  joint.wall_strength = 20e6;
  EXPECT_EQ(rock.with_joints(joint).parameters().wall_strength, 20e6);
  EXPECT_EQ(weaker_of(loose_rock(0.25), loose_rock(0.25, 80e6)).wall_strength, kWalls);
  EXPECT_THROW(JointMaterial{loose_rock(0.25, 0.0)}, InputError);
}

TEST(WallStrength, IsRefusedBesideAnotherLawThanCoulombs) {
  BartonBandis law;
  law.initial_stiffness = 1e10;
  law.closure_limit = 1e-4;
  law.wall_strength = 50e6;
  EXPECT_THROW(JointLaws(JointMaterial(loose_rock(0.25)), {barton_bandis_class(law, 1e10)}),
               InputError);
}

}  // namespace
}  // namespace muckpile::test
