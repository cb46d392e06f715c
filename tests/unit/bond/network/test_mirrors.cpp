// SPDX-License-Identifier: GPL-2.0-or-later
// Joints at mirrors: half of a scene at a symmetry plane moves as half of the whole scene, with all
// that its dashpots take.
// Scope: rows and small heaps of cubes, without the engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "bond/network/facet_points.h"
#include "bond_scene.h"

namespace muckpile::test {
namespace {

JointParameters damped_rock(double tension) {
  JointParameters p = rock(0.25);
  p.tension = tension;
  p.cohesion = 2.0 * tension;
  p.friction_angle = p.residual_friction_angle = 0.5;
  p.damping = 0.05;
  p.contact_damping = 0.1;
  return p;
}

Support mirror_at_the_start(const Vec3& x) {
  return x.x() < 1e-9 ? Support::mirror : Support::free;
}

struct Extent {
  int columns;  // of cubes on one side of the mirror, along x
  int rows, layers;
};

/// Cubes of 1 m on both sides of a plane across x, and those of one side with a mirror in its
/// place.
class HalfAndWhole {
 public:
  HalfAndWhole(const Extent& extent, const JointParameters& p, bool zoned)
      : n_(extent),
        half_(scene(extent.columns, mirror_at_the_start, p, zoned)),
        whole_(scene(
            2 * extent.columns, [](const Vec3&) { return Support::free; }, p, zoned)) {
    half_.compute();
    whole_.compute();
  }

  /// Velocities along x of up to `speed` [m/s] and spins of up to `spin` [rad/s], mirrored in the
  /// whole.
  void set_off(double speed, double spin) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    each([&](BlockState& of_half, BlockState& same, BlockState& image) {
      of_half.velocity = Vec3(speed * unit(random), 0.0, 0.0);
      of_half.spin = spin * Vec3(unit(random), unit(random), unit(random));
      same.velocity = image.velocity = of_half.velocity;
      image.velocity.x() *= -1.0;
      same.spin = image.spin = of_half.spin;
      image.spin.tail<2>() *= -1.0;
    });
  }
  /// Every block moves by so much of its distance from the mirror, and forces are found there.
  void stretch(double by) {
    each([&](BlockState& of_half, BlockState& same, BlockState& image) {
      const double moved = by * of_half.centre.x();
      of_half.centre.x() += moved;
      same.centre.x() += moved;
      image.centre.x() -= moved;
    });
    half_.compute();
    whole_.compute();
  }
  [[nodiscard]] double stable_step() { return std::min(half_.stable_step(), whole_.stable_step()); }
  /// Of the velocities in 400 steps of dt, over `speed`.
  [[nodiscard]] double worst_off(double speed, double dt) {
    double worst = 0.0;
    for (int n = 0; n < 400; ++n) {
      half_.step(dt);
      whole_.step(dt);
      each([&](const BlockState& of_half, const BlockState& same, const BlockState&) {
        worst = std::max(worst, (of_half.velocity - same.velocity).norm());
      });
    }
    return worst / speed;
  }
  [[nodiscard]] BondScene& half() { return half_; }
  [[nodiscard]] BondScene& whole() { return whole_; }
  /// What dashpots have taken of the half, twice, over that of the whole.
  [[nodiscard]] double damped() {
    return 2.0 * half_.network().losses().damping / whole_.network().losses().damping;
  }

 private:
  [[nodiscard]] BondScene scene(int columns, const SupportRule& support, const JointParameters& p,
                                bool zoned) const {
    const std::vector<Block> blocks = cuboids(columns, n_.rows, n_.layers);
    Zones zones;
    if (zoned) zones = {{p}, std::vector<std::uint8_t>(blocks.size(), 1)};
    return {blocks, p, support, {}, Leaning::little, zones};
  }
  template <class Do>
  void each(const Do& with) {
    for (int row = 0; row < n_.rows * n_.layers; ++row) {
      for (int i = 0; i < n_.columns; ++i) {
        const int middle = 2 * n_.columns * row + n_.columns;
        with(half_.block(static_cast<std::size_t>(n_.columns * row + i)),
             whole_.block(static_cast<std::size_t>(middle + i)),
             whole_.block(static_cast<std::size_t>(middle - 1 - i)));
      }
    }
  }

  Extent n_;
  BondScene half_, whole_;
};

/// Runs both for a while: velocities and what dashpots take differ by rounding, of 1e-16 m in ways
/// of 1e-6 m.
void expect_alike(HalfAndWhole& rows, const char* what) {
  const double speed = 0.1, dt = 0.3 * rows.stable_step();
  rows.set_off(speed, 0.0);
  const double worst = rows.worst_off(speed, dt);
  std::cout << what << " row at a mirror: velocities off by " << worst << ", damping by "
            << rows.damped() - 1.0 << '\n';
  EXPECT_GT(rows.half().network().losses().damping, 0.0);
  EXPECT_LT(worst, 1e-9);
  EXPECT_NEAR(rows.damped(), 1.0, 1e-9);
}

class AtMirrors : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(OneRockOrZones, AtMirrors, testing::Bool());

TEST_P(AtMirrors, DashpotsOfHalfARowAreThoseOfTheRow) {
  HalfAndWhole rows({3, 1, 1}, damped_rock(1e30), GetParam());
  expect_alike(rows, "bonded");
}

TEST_P(AtMirrors, DashpotsOfBrokenJointsAreThoseOfTheWhole) {
  HalfAndWhole rows({3, 1, 1}, damped_rock(1e5), GetParam());
  rows.stretch(1e-4);   // every joint breaks,
  rows.stretch(-2e-4);  // and closes
  for (std::size_t f = 0; f < rows.half().network().facet_count(); ++f)
    ASSERT_EQ(rows.half().network().history().bonded_points(f), 0);
  expect_alike(rows, "broken");
}

TEST_P(AtMirrors, WallsThatCrushTakeHalfOfWhatTheyTakeOfTheWhole) {
  JointParameters p = damped_rock(1e5);
  p.wall_strength = 2e6;
  HalfAndWhole rows({3, 1, 1}, p, GetParam());
  rows.stretch(1e-4);   // every joint breaks,
  rows.stretch(-2e-4);  // and closes: to 6 MPa, if walls bore it
  const double speed = 0.1, dt = 0.3 * rows.stable_step();
  rows.set_off(speed, 0.0);
  const double worst = rows.worst_off(speed, dt);
  const double half = rows.half().network().losses().crushing;
  const double share = 2.0 * half / rows.whole().network().losses().crushing;
  std::cout << "crushing row at a mirror: velocities off by " << worst << ", crushing by "
            << share - 1.0 << '\n';
  EXPECT_GT(half, 0.0);
  EXPECT_LT(worst, 1e-9);
  EXPECT_NEAR(share, 1.0, 1e-9);
}

TEST_P(AtMirrors, FacetsThatSoftenAreThoseOfTheWhole) {
  JointParameters p = damped_rock(1e5);
  p.fracture_energy_tension = p.fracture_energy_shear = 2.0;  // spent as a joint is 40 um open
  HalfAndWhole rows({3, 1, 1}, p, GetParam());
  rows.stretch(2e-6);  // every joint breaks
  const double speed = 0.03, dt = 0.3 * rows.stable_step();
  rows.set_off(speed, 0.0);
  const double worst = rows.worst_off(speed, dt);
  const double of_half = 2.0 * rows.half().network().losses().fracture,
               of_whole = rows.whole().network().losses().fracture;
  std::cout << "softening row at a mirror: velocities off by " << worst << ", fracture by "
            << of_half / of_whole - 1.0 << ", damping by " << rows.damped() - 1.0 << '\n';
  EXPECT_GT(of_whole, 0.0);
  EXPECT_LT(of_whole, 0.9 * 5 * 2.0);  // five joints of 1 m2, some of them still soften
  EXPECT_LT(worst, 1e-7);              // breaking magnifies rounding
  EXPECT_NEAR(of_half / of_whole, 1.0, 1e-9);
  EXPECT_NEAR(rows.damped(), 1.0, 1e-9);
}

/// Breaks the points above the middle of the square facet in the plane x = `at`, whose points are
/// put where those of its image are.
int break_above(BondScene& scene, double at) {
  FacetLists lists = scene.network().lists();
  int broken = 0;
  for (std::size_t f = 0; f < lists.facets.size(); ++f) {
    Facet& facet = lists.facets[f];
    const Vec3 middle = scene.start(static_cast<std::size_t>(facet.i)) + facet.arm_i;
    if (std::abs(middle.x() - at) > 1e-9) continue;
    if (facet.half_axes[0].z() < 0.0) {
      for (Vec3& axis : facet.half_axes) axis *= -1.0;
    }
    for (std::size_t p = 0; p < kFacetPoints; ++p) {
      if (kOnFirst[p] * facet.half_axes[0].z() + kOnSecond[p] * facet.half_axes[1].z() < 1e-9)
        continue;
      lists.memory[f].broken.set(p);
      lists.memory[f].state = FacetState::cracked;
      ++broken;
    }
  }
  scene.network().set_facets(std::move(lists));
  scene.network().find_stresses();
  return broken;
}

TEST_P(AtMirrors, HalfBrokenFacetIsThatOfTheWhole) {
  HalfAndWhole rows({3, 1, 1}, damped_rock(1e30), GetParam());
  ASSERT_EQ(break_above(rows.half(), 0.0), 1);  // of three
  ASSERT_EQ(break_above(rows.whole(), 3.0), 1);
  rows.stretch(0.0);
  const double speed = 0.001, dt = 0.3 * rows.stable_step();
  rows.set_off(speed, 0.0);
  const double worst = rows.worst_off(speed, dt);
  std::cout << "half broken facet at a mirror: velocities off by " << worst << ", damping by "
            << rows.damped() - 1.0 << '\n';
  EXPECT_LT(worst, 1e-4);  // the block turns: of the order of the angle
  EXPECT_NEAR(rows.damped(), 1.0, 1e-4);
}

TEST_P(AtMirrors, SlidingAlongOneCostsNothing) {
  HalfAndWhole rows({3, 1, 1}, damped_rock(1e30), GetParam());
  for (std::size_t b = 0; b < rows.half().size(); ++b)
    rows.half().block(b).velocity = Vec3(0.0, 0.5, -0.2);
  const double dt = 0.3 * rows.stable_step();
  for (int n = 0; n < 20; ++n) rows.half().step(dt);
  EXPECT_EQ(rows.half().network().losses().damping, 0.0);
  for (std::size_t b = 0; b < rows.half().size(); ++b)
    EXPECT_LT((rows.half().block(b).velocity - Vec3(0.0, 0.5, -0.2)).norm(), 1e-12);
}

/// The mirror's own face turns by half of what its block does, that between block and image not at
/// all: the difference is of the order of the angle, here 1e-5.
TEST_P(AtMirrors, HalfOfAHeapThatSpinsIsHalfOfTheHeap) {
  for (const double tension : {1e30, 1e5}) {
    HalfAndWhole heaps({2, 2, 2}, damped_rock(tension), GetParam());
    if (tension < 1e30) {
      heaps.stretch(1e-4);
      heaps.stretch(-2e-4);
    }
    const double speed = 0.01, dt = 0.3 * heaps.stable_step();
    heaps.set_off(speed, speed);
    const double worst = heaps.worst_off(speed, dt);
    std::cout << "heap at a mirror: velocities off by " << worst << ", damping by "
              << heaps.damped() - 1.0 << '\n';
    EXPECT_LT(worst, 1e-4) << tension;
    EXPECT_NEAR(heaps.damped(), 1.0, 1e-4) << tension;
  }
}

}  // namespace
}  // namespace muckpile::test
