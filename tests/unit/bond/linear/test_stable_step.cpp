// SPDX-License-Identifier: GPL-2.0-or-later
// The bound on the time step: by hand for two cubes, and against the onset of instability.
// Scope: some hundred blocks, leapfrog without the engine.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "bond/linear/stable_step.h"
#include "bond_scene.h"
#include "geometry/cut/tessellation.h"

namespace muckpile::test {
namespace {

constexpr double kExact = 1.0 / (1.0 - kStepDoubt);  // where Lanczos' method finds the eigenvalue

/// Unrelaxed cells around a short charge: sizes 17:1 and facets down to slivers.
std::vector<Block> graded_blocks() {
  TessellationOptions options;
  options.lo = Vec3::Constant(-3.0);
  options.hi = Vec3::Constant(3.0);
  options.holes = {Hole{{0, 0, -1.5}, {0, 0, 1.5}, 0.1}};
  options.size = SizeLaw::power({0.9, 1.0}, {0.1, 3.0});
  options.seed = 3;
  options.sweeps = 5;
  return tessellate(options).blocks;
}

TEST(StableStep, OfTwoCubesByHand) {
  // Two 1 m cubes of mass m on a facet of stiffness k = 2G in shear and normal (nu = 0, h = A = 1).
  // Sliding by w while both roll by p: energy k (w - p)^2 / 2; 1/mass is 2/m of w and 1/(2 m/6) of
  // p: omega^2 = k (2/m + 3/m). Opening 2 k/m, bending k/m and twist 2 k/m are slower.
  const double k = 50e9, m = 2600.0;
  BondScene scene(cuboids(2, 1, 1), rock(0.0));
  scene.compute();
  EXPECT_NEAR(scene.stable_step() * kExact / (2.0 / std::sqrt(5.0 * k / m)), 1.0, 1e-9);

  // nu = 0.45: closed contact has (lambda + 2G)/h = 189.66e9 along the normal, 2G = 34.48e9 across:
  // opening 2 x 189.66 = 379.3e9 against sliding and rolling 5 x 34.48 = 172.4e9.
  const double modulus = 50e9 * 0.55 / (1.45 * 0.1), shear = 50e9 / 1.45;
  BondScene stiff(cuboids(2, 1, 1), rock(0.45));
  stiff.compute();
  EXPECT_NEAR(stiff.stable_step() * kExact / (2.0 / std::sqrt(2.0 * modulus / m)), 1.0, 1e-9);
  EXPECT_NEAR(stiff.stable_step(Breaking::none) * kExact / (2.0 / std::sqrt(5.0 * shear / m)), 1.0,
              1e-9);
}

TEST(StableStep, OfADashpotByHand) {
  // As above with damping d: the dashpot d rho c_P A moves with the spring, c = d sqrt(E rho) at
  // nu = 0. Limit of leapfrog with lagging dashpots: 5 (k dt^2 + 2 c dt) / m = 4.
  JointParameters damped = rock(0.0);
  damped.damping = 0.3;
  BondScene scene(cuboids(2, 1, 1), damped);
  scene.compute();
  const double k = 50e9, m = 2600.0, c = 0.3 * std::sqrt(50e9 * 2600.0);
  const double limit = (std::sqrt(c * c + 0.8 * k * m) - c) / k;
  const double bound = scene.stable_step(Breaking::none);
  EXPECT_LT(bound, limit);
  EXPECT_GT(bound * kExact * 1.005, limit);
}

TEST(StableStep, IsInfiniteWithoutFacets) {
  BondScene scene(cuboids(1, 1, 1), rock(0.25));
  scene.compute();
  EXPECT_TRUE(std::isinf(scene.stable_step()));
  EXPECT_TRUE(std::isinf(
      stable_step(FacetNetwork(JointMaterial(rock(0.25))), {}, Breaking::possible).seconds));
}

/// True if the energy stays bounded over `steps` steps of dt.
bool stable(BondScene scene, double dt, int steps) {
  scene.shake(1e-7, 1e-7, 4);
  scene.compute();
  const double start = scene.energy_account();
  for (int k = 0; k < steps; ++k) {
    scene.step(dt);
    if (k % 50 != 0) continue;
    const double energy = scene.kinetic_energy() + scene.network().elastic_energy();
    if (!(energy < 50.0 * start)) return false;
  }
  return true;
}

/// Instability sets in between the bound and 3.5 % above it: 1/(1 - kStepDoubt) = 1.026, and what
/// it takes to grow a hundredfold within the steps.
void expect_onset_at_bound(BondScene scene) {
  scene.compute();
  const double bound = scene.stable_step(Breaking::none);
  const JointParameters& p = scene.network().material().parameters();
  EXPECT_TRUE(stable(scene, bound, 1500)) << p.poisson_ratio << " " << p.damping;
  EXPECT_FALSE(stable(scene, 1.035 * bound, 1500)) << p.poisson_ratio << " " << p.damping;
}
void expect_onset_at_bound(const std::vector<Block>& blocks, const JointParameters& p) {
  expect_onset_at_bound(BondScene(blocks, p));
}

TEST(StableStep, IsWhereRegularBlocksBecomeUnstable) {
  for (const double nu : {0.0, 0.25, 0.45}) {
    expect_onset_at_bound(cuboids(4, 4, 4), rock(nu));
    expect_onset_at_bound(cuboids(4, 4, 4, {1.0, 1.0, 0.2}), rock(nu));
    expect_onset_at_bound(cuboids(4, 4, 4, {0.3, 0.3, 1.0}), rock(nu));
  }
}

TEST(StableStep, IsWhereVoronoiAndGradedBlocksBecomeUnstable) {
  const std::vector<Block> even = voronoi_blocks(4.0, 5), random = voronoi_blocks(4.0, 5, 0),
                           graded = graded_blocks();
  for (const double nu : {0.0, 0.25, 0.45}) {
    expect_onset_at_bound(even, rock(nu));
    expect_onset_at_bound(random, rock(nu));
  }
  expect_onset_at_bound(graded, rock(0.25));
}

TEST(StableStep, IsWhereLeaningBlocksBecomeUnstable) {
  for (const double nu : {0.0, 0.25, 0.45}) expect_onset_at_bound(leaning_scene(4.0, rock(nu)));
  JointParameters smooth = rock(0.25);
  smooth.shear_stiffness = 1e9;  // [Pa/m]: a fortieth of the rock's
  expect_onset_at_bound(leaning_scene(4.0, smooth));
}

TEST(StableStep, IsWhereDampedBlocksBecomeUnstable) {
  for (const double damping : {0.05, 1.0}) {
    JointParameters p = rock(0.25);
    p.damping = damping;
    expect_onset_at_bound(voronoi_blocks(4.0, 5, 0), p);
  }
}

TEST(StableStep, IsWhereDampedBlocksAtMirrorsBecomeUnstable) {
  const auto three_planes = [](const Vec3& x) {
    return x.minCoeff() < 1e-9 ? Support::mirror : Support::free;
  };
  for (const double damping : {0.05, 1.0}) {
    JointParameters p = rock(0.25);
    p.damping = damping;
    expect_onset_at_bound(BondScene(cuboids(3, 3, 3), p, three_planes));
    expect_onset_at_bound(BondScene(voronoi_blocks(4.0, 5, 0), p, three_planes));
  }
}

void expect_covers_mixtures(BondScene scene) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  scene.compute();
  const double covered = scene.stable_step();
  for (const double share : {0.1, 0.5, 0.9}) {
    FacetLists lists = scene.network().lists();
    for (FacetMemory& m : lists.memory) {
      for (std::size_t p = 0; p < kFacetPoints; ++p) m.broken.set(p, unit(random) < share);
      if (m.broken.any()) m.state = FacetState::cracked;
    }
    BondScene mixed = scene;
    mixed.network().set_facets(std::move(lists));
    mixed.network().find_stresses();
    EXPECT_GE(mixed.stable_step(Breaking::none), 0.997 * covered)
        << scene.network().material().parameters().poisson_ratio << " " << share;
  }
}

TEST(StableStep, WithBreakingPossibleCoversEveryMixture) {
  for (const double nu : {0.0, 0.25, 0.45}) {
    expect_covers_mixtures({voronoi_blocks(4.0, 5, 0), rock(nu)});
    expect_covers_mixtures(leaning_scene(4.0, rock(nu)));
  }
}

}  // namespace
}  // namespace muckpile::test
