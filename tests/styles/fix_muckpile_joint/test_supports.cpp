// SPDX-License-Identifier: GPL-2.0-or-later
// Supported faces in the engine: strength of `fixed` and `mirror`, and rock that is made softer
// under a load that it carries at rest.
// Scope: one cube, and a hanging rock of some dozen blocks; nu = 0 where a number is worked by
// hand.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "rock_scene.h"

namespace muckpile::test {
namespace {

constexpr double kModulus = 50e9;   // E = 2G at nu = 0 [Pa]
constexpr double kDepth = 0.5;      // centre of the cube to its face [m]
constexpr double kTimeStep = 4e-7;  // [s]
constexpr int kElastic = 4, kFracture = 5, kStableStep = 8;

/// A cube of 1 m, supported at x = 0 (`faces` 1) or at x = 0 and x = 1 m (2).
void hold_cube(RockScene& scene, const std::string& support, int faces, double cohesion,
               double tension) {
  scene.command("region low block -0.1 0.001 -1 2 -1 2 units box");
  scene.command("region high block 0.999 1.1 -1 2 -1 2 units box");
  std::string supports = " support " + support + " low";
  if (faces == 2) supports += " support " + support + " high";
  scene.cut("0 1 0 1 0 1",
            "density 2600 size uniform 1 block_min 1 block_max 1 spheres_per_block 1" + supports);
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0 density 2600 "
      "friction_angle 45 cohesion " +
      std::to_string(cohesion) + " tension " + std::to_string(tension));
}

const std::string kBox = "-1 2 -1 2 -1 2";

struct Break {
  double before = 0.0, at = 0.0;  ///< traction in the steps before and of the break [Pa]
  Vec3 velocity_then, velocity_later;
};

/// Pushes the cube along `way` until a face breaks, then lets it fly on. The law is t = (2G/h) u.
Break push(RockScene& scene, const Vec3& way, double speed) {
  scene.set_motion([&](int, const Vec3&) { return Motion{speed * way, Vec3::Zero()}; });
  const Vec3 start = scene.blocks().at(1).centre;
  const auto traction = [&] {
    return kModulus / kDepth * (scene.blocks().at(1).centre - start).dot(way);
  };
  Break found;
  for (int step = 0; step < 1000 && scene.output("joint", kFracture) == 0.0; ++step) {
    found.before = traction();
    scene.run(1, kTimeStep);
  }
  found.at = traction();
  found.velocity_then = scene.blocks().at(1).velocity;
  scene.run(500, kTimeStep);
  found.velocity_later = scene.blocks().at(1).velocity;
  return found;
}

class SupportKinds : public testing::TestWithParam<const char*> {};

TEST_P(SupportKinds, FaceBreaksAtTheTensileStrengthAndLetsGo) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  hold_cube(scene, GetParam(), 1, 1e12, 2e6);
  ASSERT_EQ(scene.blocks().size(), 1u);
  // Swings to 0.25 m/s / sqrt(50e9 / 0.5 / 2600) = 40 um; the strength is reached at 2e6 / 50e9 x
  // 0.5 m = 20 um. A step is 0.4 % of the strength.
  const Break found = push(scene, Vec3::UnitX(), 0.25);
  EXPECT_LE(found.before, 2e6 * (1 + 1e-9));
  EXPECT_GT(found.at, 2e6);
  EXPECT_LT(found.at - found.before, 0.006 * 2e6);
  // 1/2 t^2 / E over the 0.5 m3 between centre and face: 20 J
  EXPECT_NEAR(scene.output("joint", kFracture), 20.0, 0.015 * 20.0);
  EXPECT_GT(found.velocity_then.x(), 0.2);
  EXPECT_LT((found.velocity_later - found.velocity_then).norm(), 1e-12);  // free flight
}

INSTANTIATE_TEST_SUITE_P(Supports, SupportKinds, testing::Values("fixed", "mirror"));

TEST(Supports, FixedFacesBreakInShearAtTheCohesion) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  hold_cube(scene, "fixed", 2, 4e6, 1e12);
  // Both faces are sheared alike, so the cube does not turn. It would swing to 0.7 / sqrt(2 x 50e9
  // / 0.5 / 2600) = 80 um; 4e6 Pa are reached at 40 um. A step is 0.6 % of the strength.
  const Break found = push(scene, Vec3::UnitY(), 0.7);
  EXPECT_LE(found.before, 4e6 * (1 + 1e-9));
  EXPECT_GT(found.at, 4e6);
  EXPECT_LT(found.at - found.before, 0.008 * 4e6);
  // 1/2 (2G/h) u^2 of each: 2 x 80 J
  EXPECT_NEAR(scene.output("joint", kFracture), 160.0, 0.02 * 160.0);
  EXPECT_LT((found.velocity_later - found.velocity_then).norm(), 1e-12);
}

TEST(Supports, MirrorFacesHaveNoShear) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  hold_cube(scene, "mirror", 2, 1.0, 1e12);
  const Vec3 velocity(0.0, 0.7, -0.2);
  scene.set_motion([&](int, const Vec3&) { return Motion{velocity, Vec3::Zero()}; });
  scene.run(1000, kTimeStep);  // 0.3 mm: fixed faces would have turned the motion round
  EXPECT_LT((scene.blocks().at(1).velocity - velocity).norm(), 1e-12);
  EXPECT_EQ(scene.output("joint", kFracture), 0.0);
}

/// A cube of 2 m that hangs at rest in gravity along x, and how far each block has sunk.
class HangingRock {
 public:
  HangingRock() : scene(MPI_COMM_WORLD, "-1 4 -1 3 -1 3") {
    scene.command("region top block -0.1 0.001 -1 3 -1 3 units box");
    scene.cut("0 2 0 2 0 2",
              "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1 seed "
              "3 support fixed top");
    start_ = scene.blocks();
    scene.command(
        "fix joint all muckpile/joint youngs_modulus 5e9 poisson_ratio 0.25 density 2600 cohesion "
        "1e12 friction_angle 45 tension 1e12 damping 0.4");
    scene.command("fix ledger all muckpile/ledger");
    scene.command("fix pull all gravity 10 vector 1 0 0");
    scene.run(0, 1e-6);
    settle(0.6);
  }

  /// Dashpots of D rho cP per area on joints h apart take a swing of rate w down as exp(-D h w^2 t
  /// / (2 cP)). The slowest, sideways as a cantilever, has w = 700/s: 35/s. Softer by F: sqrt(F) of
  /// it.
  void settle(double time) {
    const double step = 0.3 * scene.output("joint", kStableStep);
    scene.run(static_cast<int>(time / step), step);
  }
  [[nodiscard]] std::map<int, double> sunk() const {
    std::map<int, double> by;
    for (const auto& [tag, block] : scene.blocks())
      by[tag] = block.centre.x() - start_.at(tag).centre.x();
    return by;
  }

  RockScene scene;

 private:
  std::map<int, BlockNow> start_;
};

TEST(Softening, LeavesThatShareOfEveryTractionAndBooksTheRest) {
  for (const double factor : {1.0, 0.25}) {
    HangingRock rock;
    RockScene& scene = rock.scene;
    const auto sunk = rock.sunk();
    const double elastic = scene.output("joint", kElastic),
                 fracture = scene.output("joint", kFracture);
    ASSERT_GT(sunk.size(), 12u);
    ASSERT_GT(elastic, 0.01);
    EXPECT_EQ(fracture, 0.0);
    scene.command("fix_modify joint soften " + std::to_string(factor));
    constexpr double kInstant = 1e-6;  // [s]; stiff enough a joint changes its force by 5e-5 in it
    scene.run(1, kInstant);
    // At rest the tractions on a block carried its weight; the share that is left carries that
    // share of it, so each block starts to fall with the rest. The tractions' moments also
    // balanced.
    for (const auto& [tag, block] : scene.blocks()) {
      const Vec3 fall((1.0 - factor) * 10.0 * kInstant, 0, 0);
      EXPECT_LT((block.velocity - fall).norm(), 1e-3 * 10.0 * kInstant) << tag << ' ' << factor;
      EXPECT_LT(block.spin.norm(), 1e-3 * 10.0 * kInstant) << tag << ' ' << factor;
    }
    // The rock falls 4e-12 m meanwhile; it had sunk 1e-5 m.
    EXPECT_NEAR(scene.output("joint", kElastic) / (factor * elastic), 1.0, 5e-6);
    EXPECT_NEAR(scene.output("joint", kFracture), (1.0 - factor) * elastic, 1e-6 * elastic);
    rock.settle(0.6);
    for (const auto& [tag, before] : sunk) {  // Hooke's law; strains are 2e-5 and 6e-5
      EXPECT_NEAR(rock.sunk().at(tag) * factor / before, 1.0, 1e-3) << tag;
    }
    EXPECT_LT(scene.output("ledger", 0), 1e-3);
  }
}

}  // namespace
}  // namespace muckpile::test
