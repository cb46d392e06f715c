// SPDX-License-Identifier: GPL-2.0-or-later
// Rock of two zones in the network: layered rock, energy, breaking, the stable step.
// Scope: cuboids and Voronoi blocks of about 1 m; poses are set by hand or by leapfrog.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "zoned_scene.h"

namespace muckpile::test {
namespace {

/// The state that layers normal to z can all be in: one strain in their planes, one traction.
struct Laminate {
  double xx = 1e-6, yy = -0.4e-6, xy = 0.3e-6;  ///< strain
  Vec3 traction{2e4, -3e4, 5e4};                ///< on planes normal to z [Pa]

  /// Displacement gradient in a rock; the lateral ones are of the continuum.
  [[nodiscard]] Mat3 gradient(const JointMaterial& rock) const {
    Mat3 f = Mat3::Zero();
    f(0, 0) = xx;
    f(1, 1) = yy;
    f(0, 1) = f(1, 0) = xy;
    f(0, 2) = traction.x() / rock.shear_modulus();
    f(1, 2) = traction.y() / rock.shear_modulus();
    f(2, 2) = (traction.z() - rock.lame_lambda() * (xx + yy)) / rock.p_wave_modulus();
    return f;
  }
  [[nodiscard]] Mat3 stress(const JointMaterial& rock) const {
    const Mat3 f = gradient(rock), e = 0.5 * (f + f.transpose());
    return rock.lame_lambda() * e.trace() * Mat3::Identity() + 2.0 * rock.shear_modulus() * e;
  }
};

/// Puts the centres where the laminate has them; blocks turn with the rock, by half of its curl.
void laminate(BondScene& scene, const Laminate& state, const std::vector<JointMaterial>& rocks,
              const std::function<bool(const Vec3&)>& is_soft) {
  for (std::size_t b = 0; b < scene.size(); ++b) {
    const Vec3 x = scene.start(b);
    Vec3 u = Vec3::Zero();
    constexpr double kPart = 0.5;  // of a layer
    for (double z = 0.5 * kPart; z < x.z(); z += kPart)
      u += kPart * state.gradient(rocks[is_soft({0, 0, z}) ? 1 : 0]).col(2);
    const Mat3 here = state.gradient(rocks[is_soft(x) ? 1 : 0]);
    u += here.col(0) * x.x() + here.col(1) * x.y();
    scene.block(b).centre = x + u;
    const Vec3 curl(here(2, 1) - here(1, 2), here(0, 2) - here(2, 0), here(1, 0) - here(0, 1));
    scene.block(b).rotation = turn(0.5 * curl);
  }
}

/// Largest error of a facet between blocks that touch no surface, over the largest traction.
double laminate_error(const std::function<bool(const Vec3&)>& is_soft, double nu, double soft_nu,
                      double size = 1.0) {
  const std::vector<JointMaterial> rocks{JointMaterial(rock(nu)), JointMaterial(soft(soft_nu))};
  BondScene scene = scene_of(in_zones(cuboids(6, 6, 6), is_soft), rock(nu), soft(soft_nu));
  const Laminate whole;
  const Laminate state{size * whole.xx, size * whole.yy, size * whole.xy, size * whole.traction};
  laminate(scene, state, rocks, is_soft);
  double wrong = 0.0, largest = 0.0;
  for (std::size_t f = 0; f < scene.network().facets().size(); ++f) {
    const Facet facet = scene.network().facets()[f];
    const auto inner = [&](int block) {
      const Vec3& x = scene.start(static_cast<std::size_t>(block));
      return (x.array() > 2.0).all() && (x.array() < 4.0).all();
    };
    if (facet.tag_j == kGroundTag || !inner(facet.i) || !inner(facet.j)) continue;
    const Mat3 stress = state.stress(rocks[facet.zone_i]);
    const Vec3 expected =
        facet.area * 0.5 * (stress + state.stress(rocks[facet.zone_j])) * facet.normal;
    wrong = std::max(wrong, (scene.facet_force(f) - expected).norm());
    largest = std::max(largest, expected.norm());
  }
  return wrong / largest;
}

// Shear of the soft rock, 1e-5, turns blocks and mean normals: an error of second order. In the
// planes of a layer the moduli are the arithmetic means, across it the harmonic ones: both follow
// from tractions and strains that are those of the layers.
constexpr double kTurned = 1e-5;

TEST(FacetsOfLayers, CarryTheTractionOfBothRocksWhereTwoLayersMeet) {
  EXPECT_LT(laminate_error(below_3, 0.25, 0.4), kTurned);
  EXPECT_LT(laminate_error(below_3, 0.0, 0.0), kTurned);
  EXPECT_LT(laminate_error(below_3, 0.4, 0.1), kTurned);
  EXPECT_LT(laminate_error(below_3, 0.25, 0.4, 0.1), 0.2 * kTurned);
}

TEST(FacetsOfLayers, CarryItWhereEveryLayerIsOneBlockThick) {
  EXPECT_LT(laminate_error(odd_layer, 0.25, 0.4), kTurned);
}

TEST(FacetsOfTwoRocks, HaveForcesThatAreTheGradientOfTheEnergy) {
  for (const auto& blocks :
       {in_zones(cuboids(3, 3, 3), checkered), in_zones(voronoi_blocks(3.0, 5), lower_part),
        in_zones(voronoi_blocks(3.0, 5), [](const Vec3& x) { return x.x() < 0.2 * x.y(); })}) {
    BondScene scene = scene_of(blocks, rock(0.25), soft());
    ASSERT_GT(scene.network().tables().borders().size(), 3u);
    scene.shake(1e-4, 1e-4, 1);
    scene.move_rigidly({0.6, -0.5, 0.7}, {3, -2, 1});
    const GradientError error = gradient_error(scene, 1e-6);
    EXPECT_LT(error.force, 1e-7);  // rounding, as in test_facet_elasticity
    EXPECT_LT(error.torque, 1e-7);
  }
}

TEST(FacetsOfTwoRocks, HaveThemWhereFacesLeanAndJointsAreCompliant) {
  for (const double stiffness : {std::numeric_limits<double>::infinity(), 2e10}) {  // [Pa/m]
    JointParameters hard = rock(0.25), other = soft();
    hard.normal_stiffness = other.normal_stiffness = stiffness;
    hard.shear_stiffness = other.shear_stiffness = 0.4 * stiffness;
    BondScene scene =
        scene_of(in_zones(leaning_blocks(4.0), [](const Vec3& x) { return x.x() < 0.0; }), hard,
                 other, Leaning::much);
    scene.shake(1e-4, 1e-4, 1);
    const GradientError error = gradient_error(scene, 1e-6);
    EXPECT_LT(error.force, 1e-7) << stiffness;
    EXPECT_LT(error.torque, 1e-7) << stiffness;
  }
}

TEST(FacetsOfTwoRocks, NeverGiveBackMoreThanTheyTook) {
  // The energy is positive in every pose: the relief takes less than the split had too much.
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    BondScene scene = scene_of(in_zones(cuboids(4, 4, 4), checkered), rock(0.0), soft(0.49));
    scene.shake(1e-4, 1e-4, seed);
    scene.compute();
    EXPECT_GT(scene.network().elastic_energy(), 0.0);
  }
}

TEST(FacetsOfTwoRocks, AreKeptWithAllThatTheyNeed) {
  BondScene scene = scene_of(in_zones(voronoi_blocks(4.0, 5), lower_part), rock(0.25), soft());
  scene.shake(1e-4, 1e-4, 1);
  scene.compute();
  const std::vector<Vec3> before(scene.network().force().begin(), scene.network().force().end());
  scene.network().set_facets(scene.network().give_up());
  scene.compute();
  for (std::size_t b = 0; b < scene.size(); ++b)
    EXPECT_EQ(scene.network().force()[b], before[b]) << b;
}

/// Largest drift of the energy account over the greatest kinetic energy.
double drift_of_account(BondScene& scene, int steps) {
  for (std::size_t b = 0; b < scene.size(); ++b) {
    const Vec3& x = scene.start(b);
    scene.block(b).velocity =
        2.0 * Vec3(std::sin(x.x() + 2.0 * x.z()), std::cos(2.0 * x.y()), std::sin(3.0 * x.x()));
  }
  scene.compute();
  const double start = scene.energy_account(), dt = 0.2 * scene.stable_step();
  double worst = 0.0;
  for (int step = 0; step < steps; ++step) {
    scene.step(dt);
    worst = std::max(worst, std::abs(scene.energy_account() - start));
  }
  return worst / start;
}

TEST(FacetsOfTwoRocks, KeepTheEnergyAccountAsTheyBreak) {
  JointParameters hard = rock(0.25), other = soft(0.3);
  hard.tension = 8e6, hard.cohesion = 2e7, hard.friction_angle = hard.residual_friction_angle = 0.6;
  other.tension = 2e6, other.cohesion = 6e6, other.residual_friction_angle = 0.5;
  for (const auto& blocks :
       {in_zones(voronoi_blocks(4.0, 5), lower_part), in_zones(cuboids(4, 4, 4), odd_layer)}) {
    BondScene scene = scene_of(blocks, hard, other);
    EXPECT_LT(drift_of_account(scene, 400), 0.01);
    EXPECT_GT(scene.network().broken_count(), 20.0);
  }
}

TEST(FacetsOfTwoRocks, AreStableUpToTheBound) {
  for (const auto& blocks :
       {in_zones(cuboids(4, 4, 4), checkered), in_zones(voronoi_blocks(4.0, 5), lower_part)}) {
    BondScene scene = scene_of(blocks, rock(0.25), soft());
    scene.shake(1e-5, 1e-5, 1);
    scene.compute();
    const double start = scene.energy_account(), dt = 0.98 * scene.stable_step(Breaking::none);
    for (int step = 0; step < 500; ++step) scene.step(dt);
    EXPECT_LT(scene.kinetic_energy(), 100.0 * start);  // it would grow e-fold in a few steps
  }
}

TEST(Zones, ThatHoldNoBlockChangeNothing) {
  const std::vector<Block> blocks = voronoi_blocks(4.0, 5);
  BondScene plain(blocks, rock(0.25)), zoned = scene_of({blocks, {}}, rock(0.25), soft());
  for (BondScene* scene : {&plain, &zoned}) {
    scene->shake(1e-4, 1e-4, 1);
    scene->compute();
    for (int step = 0; step < 20; ++step) scene->step(1e-5);
  }
  for (std::size_t b = 0; b < plain.size(); ++b)
    EXPECT_EQ(plain.network().force()[b], zoned.network().force()[b]) << b;
}

TEST(Zones, SoftenTogether) {
  BondScene scene = scene_of(in_zones(voronoi_blocks(4.0, 5), lower_part), rock(0.25), soft());
  scene.shake(1e-5, 1e-5, 1);
  scene.compute();
  const double account = scene.energy_account();
  const std::vector<Vec3> before(scene.network().force().begin(), scene.network().force().end());
  scene.network().soften(0.01);
  scene.compute();
  EXPECT_NEAR(scene.energy_account(), account, 1e-9 * account);
  for (std::size_t b = 0; b < scene.size(); ++b)
    EXPECT_LT((scene.network().force()[b] - 0.01 * before[b]).norm(), 1e-9 * before[b].norm()) << b;
}

}  // namespace
}  // namespace muckpile::test
