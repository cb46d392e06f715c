// SPDX-License-Identifier: GPL-2.0-or-later
// open_sleep of fix muckpile/joint: leaving open facets alone changes nothing while their gap
// lasts, and what forces can close meanwhile is bounded. Scope: a lump torn apart, and one cube
// that falls back on the face it broke off from.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "rock_scene.h"

namespace muckpile::test {
namespace {

/// Some 40 blocks that burst: most joints break, many facets open and close again.
std::map<int, BlockNow> burst(int open_sleep) {
  RockScene scene(MPI_COMM_WORLD, "-4 4 -4 4 -4 4");
  scene.command("pair_style muckpile/block youngs_modulus 1e8");
  scene.command("pair_coeff * *");
  scene.cut("-1 1 -1 1 -0.6 0.6",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 4 seed 3");
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 cohesion "
      "4e6 friction_angle 50 tension 2e6 open_sleep " +
      std::to_string(open_sleep));
  const Vec3 spin(4, -6, 20);
  scene.set_motion([&](int, const Vec3& at) {
    return Motion{spin.cross(at) + 0.4 * Vec3(std::sin(3 * at.y()), std::cos(2 * at.z()), 0), spin};
  });
  scene.run(1500, 2e-5);
  EXPECT_GT(scene.output("joint", 2), 0.5 * scene.output("joint", 1));
  return scene.blocks();
}

TEST(OpenSleep, ChangesNotOneBitOfABurst) {
  const auto awake = burst(0);
  for (const auto& [tag, block] : burst(20)) {
    EXPECT_EQ((block.centre - awake.at(tag).centre).norm(), 0.0) << tag;
    EXPECT_EQ((block.velocity - awake.at(tag).velocity).norm(), 0.0) << tag;
    EXPECT_EQ((block.spin - awake.at(tag).spin).norm(), 0.0) << tag;
  }
}

constexpr double kGravity = 10.0, kTimeStep = 1e-4;  // [m/s2], [s]

/// A cube without strength that moves 8 mm off its fixed face, at 0.2 m/s: with that gap its facet
/// may be left alone.
class LooseCube {
 public:
  explicit LooseCube(int open_sleep) : scene_(MPI_COMM_WORLD, "-1 2 -1 2 -1 2") {
    scene_.command("region low block -0.1 0.001 -1 2 -1 2 units box");
    scene_.cut("0 1 0 1 0 1",
               "density 2600 size uniform 1 block_min 1 block_max 1 spheres_per_block 1 support "
               "fixed low");
    scene_.command(
        "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0 density 2600 cohesion 0 "
        "friction_angle 45 tension 0 open_sleep " +
        std::to_string(open_sleep));
    start_ = scene_.blocks().at(1).centre.x();
    move(0.2);
    scene_.run(400, kTimeStep);
  }
  void move(double speed) {
    scene_.set_motion([&](int, const Vec3&) {
      return Motion{speed * Vec3::UnitX(), Vec3::Zero()};
    });
  }
  RockScene& scene() { return scene_; }
  /// How deep it sinks into the face when it comes back [m].
  double penetration() {
    BlockNow cube;
    double lowest = start_;
    for (int step = 0; step < 1500 && (lowest == start_ || cube.velocity.x() < 0.0); ++step) {
      scene_.run(1, kTimeStep);
      cube = scene_.blocks().at(1);
      lowest = std::min(lowest, cube.centre.x());
    }
    return start_ - lowest;
  }

 private:
  RockScene scene_;
  double start_ = 0.0;
};

/// All but stops, falls asleep, and is pulled back by a force that comes up then.
double pulled_back(int open_sleep) {
  LooseCube cube(open_sleep);
  cube.move(0.001);
  cube.scene().run(100, kTimeStep);
  cube.scene().command("fix pull all gravity 10 vector -1 0 0");
  return cube.penetration();
}

/// Comes back at a steady 0.5 m/s.
double thrown_back(int open_sleep) {
  LooseCube cube(open_sleep);
  cube.move(-0.5);
  cube.scene().run(150, kTimeStep);  // to within 0.5 mm
  return cube.penetration();
}

TEST(OpenSleep, IsAwakeInTimeWhenAGapClosesSteadily) {
  const double awake = thrown_back(0);
  // It sinks in by v sqrt(m h / (E A)) = 0.5 x sqrt(2600 / 1e11) = 81 um at most.
  EXPECT_GT(awake, 1e-5);
  EXPECT_LT(awake, 1.1 * 81e-6);
  EXPECT_EQ(thrown_back(20), awake);
  EXPECT_EQ(thrown_back(1000), awake);
}

TEST(OpenSleep, ClosesUnseenByAtMostWhatTheForceCanDoInThatTime) {
  // Seen in time: v^2 = 2 g 8 mm, 0.4 sqrt(2600/1e11) = 64 um at most.
  const double awake = pulled_back(0);
  EXPECT_GT(awake, 1e-5);
  EXPECT_LT(awake, 1.1 * 64e-6);
  // 20 steps: gravity closes 1/2 g (2 ms)^2 = 20 um; a facet sleeps only if open by 5.6 mm or more.
  EXPECT_EQ(pulled_back(20), awake);
  // 1000 steps are longer than the way back: the facet is looked at too late.
  EXPECT_GT(pulled_back(1000), 1e-3);
  EXPECT_LT(pulled_back(1000), 0.5 * kGravity * std::pow(1000 * kTimeStep, 2));
}

}  // namespace
}  // namespace muckpile::test
