// SPDX-License-Identifier: GPL-2.0-or-later
// The unbroken facet network: continuum tractions, energy gradient, momentum, rotation, pressure,
// softening.
// Scope: a few dozen blocks; poses are set by hand or by leapfrog.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <set>

#include "bond_scene.h"

namespace muckpile::test {
namespace {

Mat3 strain() {
  Mat3 e;
  e << 1.0, 0.3, -0.2, 0.3, -0.5, 0.4, -0.2, 0.4, 0.7;
  return 1e-6 * e;
}

Mat3 stress(const Mat3& e, const JointMaterial& material) {
  return material.lame_lambda() * e.trace() * Mat3::Identity() + 2.0 * material.shear_modulus() * e;
}

/// Blocks that neither touch the surface nor one that does: a block's bulk stress reads the
/// dilatation of its neighbours.
std::set<int> inner_blocks(BondScene& scene) {
  std::set<int> inner, outer;
  for (std::size_t b = 0; b < scene.size(); ++b) inner.insert(static_cast<int>(b));
  for (const BoundaryFace& face : scene.network().faces()) outer.insert(face.block);
  for (const Facet& facet : scene.network().facets()) {
    if (outer.contains(facet.i)) inner.erase(facet.j);
    if (outer.contains(facet.j)) inner.erase(facet.i);
  }
  for (const int b : outer) inner.erase(b);
  return inner;
}

struct PatchError {
  double facet_rms;  ///< of facet tractions over the rms traction
  double mean;       ///< of the stress averaged over the inner blocks
  int facets;
};

PatchError patch_error(BondScene scene) {
  scene.deform(strain());
  const Mat3 exact = stress(strain(), scene.network().material());
  const std::set<int> inner = inner_blocks(scene);
  double wrong = 0.0, size = 0.0;
  int facets = 0;
  Mat3 sum = Mat3::Zero(), expected = Mat3::Zero();
  for (std::size_t f = 0; f < scene.network().facets().size(); ++f) {
    const Facet& facet = scene.network().facets()[f];
    if (!inner.contains(facet.i) || !inner.contains(facet.j)) continue;
    const Vec3 force = scene.facet_force(f), continuum = facet.area * exact * facet.normal;
    wrong += (force - continuum).squaredNorm() / facet.area;
    size += continuum.squaredNorm() / facet.area;
    const Vec3 branch = facet.arm_i - facet.arm_j;  // from centre to centre
    sum += force * branch.transpose();
    expected += continuum * branch.transpose();
    ++facets;
  }
  return {std::sqrt(wrong / size), (sum - expected).norm() / expected.norm(), facets};
}

TEST(FacetNetwork, CarriesTheContinuumTractionOnEveryFacetOfRegularBlocks) {
  for (const double nu : {0.0, 0.25, 0.4}) {
    const PatchError error = patch_error({cuboids(6, 6, 6), rock(nu)});
    EXPECT_EQ(error.facets, 12);  // 2 x 2 x 2 inner blocks
    // Jumps of 1e-6 m are differences of coordinates of some metres: 1e-16 x 4 / 1e-6, some sums.
    EXPECT_LT(error.facet_rms, 1e-8) << nu;
  }
}

TEST(FacetNetwork, CarriesTheContinuumTractionOnVoronoiFacets) {
  const std::vector<Block> blocks = voronoi_blocks(8.0, 11);
  for (const double nu : {0.0, 0.25, 0.4}) {
    const PatchError error = patch_error({blocks, rock(nu)});
    ASSERT_GT(error.facets, 200);
    // A facet is off by the angle between its normal and the line of centres, which 30 sweeps bring
    // to some degrees: measured 0.6, 1.6 and 2.7 %; on average over the blocks 0.1, 0.1 and 0.2 %.
    EXPECT_LT(error.facet_rms, 0.04) << nu;
    EXPECT_LT(error.mean, 0.003) << nu;
  }
}

TEST(FacetNetwork, CarriesTheContinuumTractionOnLeaningFacets) {
  for (const double nu : {0.0, 0.25, 0.45}) {
    const PatchError error = patch_error(leaning_scene(9.0, rock(nu)));
    const PatchError springs = patch_error({leaning_blocks(9.0), rock(nu)});
    ASSERT_GT(error.facets, 200);
    std::cout << nu << ": " << error.facet_rms << " " << error.mean << ", springs "
              << springs.facet_rms << " " << springs.mean << '\n';
    // Three faces a block are hardly enough to make all of its moments right: measured 0.2, 0.5 and
    // 0.8 %, on average 0.05 %; without the terms for leaning faces
    // 10, 7 and 1.5 %, on average as much.
    EXPECT_LT(error.facet_rms, 0.012) << nu;
    EXPECT_LT(error.mean, 0.001) << nu;
    EXPECT_GT(springs.mean, 0.01) << nu << " " << springs.facet_rms;
  }
}

TEST(FacetNetwork, DilatesVoronoiBlocksByTheTraceOfAnyStrain) {
  const std::vector<Block> blocks = voronoi_blocks(5.0, 11, 3);  // three sweeps: far from regular
  BondScene scene(blocks, rock(0.4));
  Mat3 shear = strain();
  shear -= shear.trace() / 3.0 * Mat3::Identity();
  for (const Mat3& e : {strain(), shear}) {
    scene.deform(e);
    scene.network().find_stresses();
    for (const int b : inner_blocks(scene)) {
      // Jumps of 1e-6 m are differences of coordinates of some metres, as above.
      EXPECT_NEAR(scene.network().theta()[static_cast<std::size_t>(b)], e.trace(), 1e-14);
    }
  }
}

TEST(FacetNetwork, SlowsAPlaneWaveInARowOfCubesAsItsDispersionLawSays) {
  // rho w^2 = (4 s^2/h^2) (2G + lambda c^2 + 4 D s^2 c^2), s and c of half the phase kh from block
  // to block: springs of 2G, dilatation over two lengths, and what sharpens it.
  constexpr int kBlocks = 12;
  const auto sides = [](const Vec3&) { return Support::mirror; };
  for (const double nu : {0.0, 0.25, 0.4}) {
    BondScene scene(cuboids(kBlocks, 1, 1), rock(nu), sides);
    const JointMaterial& m = scene.network().material();
    const double sharpening = kSharpening * (2.0 * m.lame_lambda() + m.shear_modulus()) / 6.0;
    for (const int half_waves : {1, 3, 7}) {
      const double k = half_waves * std::numbers::pi / kBlocks;
      const double s2 = std::pow(std::sin(0.5 * k), 2), c2 = 1.0 - s2;
      const double stiffness =
          4.0 * s2 * (2.0 * m.shear_modulus() + m.lame_lambda() * c2 + 4.0 * sharpening * s2 * c2);
      for (std::size_t b = 0; b < scene.size(); ++b) {
        scene.block(b).centre = scene.start(b);
        scene.block(b).centre.x() += 1e-6 * std::sin(k * scene.start(b).x());
      }
      scene.compute();
      for (std::size_t b = 0; b < scene.size(); ++b) {
        const double exact = -stiffness * 1e-6 * std::sin(k * scene.start(b).x());
        EXPECT_NEAR(scene.network().force()[b].x(), exact, 1e-7 * stiffness * 1e-6) << nu;
      }  // jumps of 1e-6 m are differences of coordinates of 10 m
    }
  }
}

TEST(FacetNetwork, ForcesAreTheGradientOfTheEnergyFarFromTheStart) {
  for (const double nu : {0.0, 0.3}) {
    BondScene scene(voronoi_blocks(3.0, 5), rock(nu));
    scene.shake(1e-4, 1e-4, 1);
    scene.move_rigidly({0.6, -0.5, 0.7}, {3, -2, 1});
    const GradientError error = gradient_error(scene, 1e-6);
    // Energy is quadratic: what is left is rounding, 1e-16 E / (step F), with E = F x 1e-4 m x
    // blocks, and the change of the mean normal, of second order in the turn of 1e-4.
    EXPECT_LT(error.force, 1e-7) << nu;
    EXPECT_LT(error.torque, 1e-7) << nu;
  }
}

TEST(FacetNetwork, ForcesOfLeaningFacetsAreTheGradientOfTheEnergy) {
  for (const double shear_stiffness : {std::numeric_limits<double>::infinity(), 2e9}) {  // [Pa/m]
    JointParameters p = rock(0.3);
    p.shear_stiffness = shear_stiffness;
    p.normal_stiffness = 5.0 * shear_stiffness;
    BondScene scene = leaning_scene(3.0, p);
    scene.shake(1e-4, 1e-4, 1);
    scene.move_rigidly({0.6, -0.5, 0.7}, {3, -2, 1});
    const GradientError error = gradient_error(scene, 1e-6);
    EXPECT_LT(error.force, 1e-7) << shear_stiffness;  // as above
    EXPECT_LT(error.torque, 1e-7) << shear_stiffness;
  }
}

TEST(FacetNetwork, ForcesOfPointsThatHaveSlippedAreTheGradientOfTheEnergy) {
  JointParameters p = rock(0.3);
  p.cohesion = 2e5;
  p.friction_angle = p.residual_friction_angle = 0.5;
  BondScene scene(voronoi_blocks(3.0, 5), p);
  scene.deform(-1e-4 * Mat3::Identity());
  scene.shake(5e-5, 5e-5, 1);
  scene.compute();
  int slipping = 0;
  for (const FacetMemory& memory : scene.network().memory()) slipping += memory.slipping.count();
  EXPECT_GT(slipping, 15);
  // Squeezed further, all that slipped stick.
  for (std::size_t b = 0; b < scene.size(); ++b) scene.block(b).centre -= 1e-3 * scene.start(b);
  const JointLosses lost = scene.network().losses();
  scene.move_rigidly({0.6, -0.5, 0.7}, {3, -2, 1});
  const GradientError error = gradient_error(scene, 1e-6);
  EXPECT_EQ(scene.network().losses().friction, lost.friction);
  EXPECT_EQ(scene.network().losses().fracture, lost.fracture);
  EXPECT_LT(error.force, 1e-7);  // as above
  EXPECT_LT(error.torque, 1e-7);
}

TEST(FacetNetwork, ForcesAreTheGradientOfTheEnergyWithLoadedFaces) {
  BondScene scene(voronoi_blocks(3.0, 5), rock(0.3));
  scene.shake(1e-4, 1e-4, 2);
  int number = 0;
  for (BoundaryFace& face : scene.network().faces()) {
    if (++number % 2 != 0) continue;
    face.hole = 0;
    face.pressure = 1e6 * number;
  }
  const GradientError error = gradient_error(scene, 1e-6);
  EXPECT_LT(error.force, 1e-7);
  EXPECT_LT(error.torque, 1e-7);
}

/// Net force, and net moment about the origin, over the sum of their parts.
std::pair<double, double> imbalance(BondScene& scene) {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  double forces = 0.0, moments = 0.0;
  for (std::size_t b = 0; b < scene.size(); ++b) {
    const Vec3 f = scene.network().force()[b], t = scene.network().torque()[b];
    const Vec3 about = scene.block(b).centre.cross(f);
    force += f;
    moment += about + t;
    forces += f.norm();
    moments += about.norm() + t.norm();
  }
  return {force.norm() / forces, moment.norm() / moments};
}

void expect_balanced(BondScene scene) {
  scene.shake(0.2, 0.6, 3);
  scene.move_rigidly({2.0, -1.0, 0.5}, {10, 20, -5});
  for (std::size_t b = 0; b < scene.size(); ++b) {
    scene.block(b).velocity = Vec3(std::sin(1.0 * static_cast<double>(b)), 3, -1);
    scene.block(b).spin = Vec3(1, std::cos(2.0 * static_cast<double>(b)), 5);
  }
  scene.compute(1e-6);
  const auto [force, moment] = imbalance(scene);
  EXPECT_LT(force, 1e-14);  // rounding of some hundred terms that cancel in pairs
  EXPECT_LT(moment, 1e-14);
}

TEST(FacetNetwork, KeepsLinearAndAngularMomentumInAnyPose) {
  JointParameters p = rock(0.3);
  p.normal_stiffness = 8e10;
  p.damping = 0.1;
  expect_balanced({voronoi_blocks(3.0, 5), p});
  expect_balanced(leaning_scene(3.0, p));
}

void expect_at_ease_turned(BondScene scene) {
  scene.move_rigidly(Vec3(1, 2, -2) / 3.0, {5, -3, 2});  // 1 rad
  scene.compute();
  const double modulus = scene.network().material().p_wave_modulus();
  for (std::size_t b = 0; b < scene.size(); ++b) {
    // jumps are rounding of coordinates of 10 m: 2e-15 m on h of 1 m, a dozen facets
    EXPECT_LT(scene.network().force()[b].norm(), 5e-14 * modulus);
    EXPECT_LT(scene.network().torque()[b].norm(), 5e-14 * modulus);
  }
}

TEST(FacetNetwork, FeelsNothingOfARigidRotation) {
  expect_at_ease_turned({voronoi_blocks(3.0, 5), rock(0.3)});
  expect_at_ease_turned(leaning_scene(3.0, rock(0.3)));
}

TEST(FacetNetwork, FeelsNothingOfSlidingAlongAMirrorPlane) {
  BondScene scene(voronoi_blocks(3.0, 5), rock(0.3), [](const Vec3& at) {
    return std::abs(at.x()) > 1.5 - 1e-9 ? Support::mirror : Support::free;
  });
  scene.move_rigidly(Vec3::Zero(), {0.0, 2.0, -1.0});
  scene.compute();
  const double modulus = scene.network().material().p_wave_modulus();
  for (std::size_t b = 0; b < scene.size(); ++b)  // rounding as above
    EXPECT_LT(scene.network().force()[b].norm(), 5e-14 * modulus);
}

TEST(FacetNetwork, UniaxiallyStressedFreeSidedColumnIsAsStiffAsYoungsModulus) {
  // Regular blocks with free sides: theta with the sides condensed out gives E exactly.
  for (const double nu : {0.0, 0.25, 0.4}) {
    BondScene scene(cuboids(6, 1, 1), rock(nu));
    Mat3 stretch = Mat3::Zero();
    stretch(0, 0) = 1e-6;
    scene.deform(stretch);
    const Vec3 force = scene.facet_force(2);  // between blocks 2 and 3, away from the ends
    EXPECT_NEAR(force.x() / (50e9 * 1e-6), 1.0, 1e-8) << nu;  // rounding of jumps, as above
  }
}

TEST(FacetNetwork, PressureGivesPressureTimesAreaAlongTheTurnedNormal) {
  BondScene scene(voronoi_blocks(3.0, 5), rock(0.25));
  scene.move_rigidly({0.3, 0.2, -0.4}, {1, 0, 0});
  scene.compute();
  const std::vector<Vec3> before(scene.network().force().begin(), scene.network().force().end());
  BoundaryFace& face = scene.network().faces()[4];
  face.hole = 0;
  face.pressure = 3e7;
  const auto b = static_cast<std::size_t>(face.block);
  scene.compute();
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < scene.size(); ++k) sum += scene.network().force()[k] - before[k];
  // Neighbours are pulled along by the face's squeeze, but only in pairs.
  const Vec3 expected = -3e7 * face.area * (scene.block(b).rotation * face.normal);
  EXPECT_LT((sum - expected).norm(),
            1e-11 * expected.norm());  // residual of the rotated body, 1e-4 N
}

TEST(FacetNetwork, EqualPressureAllAroundIsCarriedByTheBulkModulus) {
  // Without moving, a block under p on every face takes theta = -3p/(2G) / (1 + 3 lambda/2G) =
  // -p/K.
  BondScene scene(cuboids(1, 1, 1), rock(0.25));
  for (BoundaryFace& face : scene.network().faces()) {
    face.hole = 0;
    face.pressure = 1e7;
  }
  scene.compute();
  const double bulk = 50e9 / (3.0 * (1.0 - 2.0 * 0.25));
  EXPECT_NEAR(scene.network().theta()[0] / (-1e7 / bulk), 1.0, 1e-13);
  EXPECT_LT(scene.network().force()[0].norm(), 1e-6);  // 1e7 N six times over, to rounding
  double swept = 0.0;
  for (const BoundaryFace& face : scene.network().faces())
    swept += scene.network().volume_swept(face);
  EXPECT_NEAR(swept / (1e7 / bulk), 1.0, 1e-13);  // all of the volume given up
  EXPECT_NEAR(scene.network().elastic_energy() / (0.5e14 / bulk), 1.0, 1e-13);  // p^2 V / 2K
}

TEST(FacetNetwork, WorkOfAPressureIsTheEnergyOfABlockThatItThrowsAndSpins) {
  // One free block, pushed off-centre: it flies some metres and turns several times.
  std::vector<Block> blocks = voronoi_blocks(3.0, 5, 0);
  blocks.resize(1);
  for (int& other : blocks[0].neighbour) other = kFreeFace;
  BondScene scene(blocks, rock(0.25));
  BoundaryFace& face = scene.network().faces()[0];
  face.hole = 0;
  scene.compute();
  face.pressure = 1e6;
  scene.compute();
  const double start = scene.energy_account();
  double turned = 0.0;
  for (int k = 0; k < 4000; ++k) {
    scene.step(5e-5);
    turned += 5e-5 * scene.block(0).spin.norm();
  }
  const double kinetic = scene.kinetic_energy();
  ASSERT_GT(turned, 3.0);
  EXPECT_NEAR(scene.energy_account(), start, 5e-6 * kinetic);  // second order in 1.5e-3 rad: 5e-7
}

void expect_softening_scales(BondScene scene) {
  scene.shake(1e-4, 1e-4, 6);
  scene.compute();
  const std::vector<Vec3> before(scene.network().force().begin(), scene.network().force().end());
  const double energy = scene.network().elastic_energy();
  scene.network().soften(0.01);
  scene.compute();
  for (std::size_t b = 0; b < scene.size(); ++b) {
    EXPECT_LT((scene.network().force()[b] - 0.01 * before[b]).norm(), 1e-12 * before[b].norm());
  }
  EXPECT_NEAR(scene.network().elastic_energy() / (0.01 * energy), 1.0, 1e-12);
  EXPECT_NEAR(scene.network().losses().fracture / (0.99 * energy), 1.0, 1e-12);
}

TEST(FacetNetwork, SofteningScalesForcesAndBooksTheEnergyGivenUp) {
  expect_softening_scales({voronoi_blocks(3.0, 5), rock(0.25)});
  expect_softening_scales(leaning_scene(3.0, rock(0.25)));
}

}  // namespace
}  // namespace muckpile::test
