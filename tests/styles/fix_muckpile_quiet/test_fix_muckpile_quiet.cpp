// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/quiet in the engine: static load without creep, waves let out, energy, ranks, end.
// Scope: a column of some thirty Voronoi blocks between symmetry planes; run with mpirun -np 1, 2
// and 4. The laws are tested in tests/unit/bond.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "rock_scene.h"

namespace muckpile::test {
namespace {

enum Quiet { given = 0, yielding = 1, radiated = 2, power = 3, over = 4 };
constexpr double kStep = 2e-5;  // s; 0.6 m blocks, c_P = 4804 m/s

/// Column 1.2 m x 1.2 m x 6 m, base on the z = 0 plane, mirrored all around.
struct Column {
  explicit Column(MPI_Comm comm, const std::string& strength = "cohesion 1e12 tension 1e12")
      : scene(comm, "-2 3.2 -2 3.2 -2 8", "1 1 *") {
    scene.command("region base block -1 3 -1 3 -1 0.001 units box");
    scene.command("region sides block 0.001 1.199 0.001 1.199 -1 9 side out units box");
    scene.cut(
        "0 1.2 0 1.2 0 6",
        "density 2600 size uniform 0.6 block_min 0.6 block_max 0.6 spheres_per_block 2 seed 3 "
        "support fixed base support mirror sides");
    scene.command(
        "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 "
        "friction_angle 45 " +
        strength);
    scene.command("fix energy all muckpile/ledger");
  }
  void quiet(const std::string& words) {
    scene.command("fix quiet all muckpile/quiet region base " + words);
  }
  /// A jolt downwards, smooth over the height of the column.
  void jolt(double speed) {
    scene.set_motion([=](int, const Vec3& at) {
      return Motion{Vec3(0, 0, -speed * std::pow(std::sin(M_PI * at.z() / 6.0), 2)), Vec3::Zero()};
    });
  }
  /// Mean height of all blocks [m].
  [[nodiscard]] double height() const {
    double sum = 0.0, mass = 0.0;
    for (const auto& [tag, block] : scene.blocks()) {
      sum += block.mass * block.centre.z();
      mass += block.mass;
    }
    return sum / mass;
  }
  RockScene scene;
};

TEST(FixMuckpileQuiet, CarriesGravityWithoutCreep) {
  Column column(MPI_COMM_WORLD);
  column.quiet("rock_behind 6");
  column.scene.command("fix pull all gravity 9.81 vector 0 0 -1");
  const double start = column.height();
  column.scene.run(4000, kStep);
  const double rested = column.height();
  column.scene.run(1000, kStep);
  // Base: rho g 6 m x 6 m / M; the column itself shortens by rho g 12 m2 / M on average.
  EXPECT_NEAR((start - rested) / (2600 * 9.81 * (36.0 + 12.0) / 60e9), 1.0, 0.02);
  const double creep = std::abs(column.height() - rested) / (1000 * kStep);  // m/s
  // A dashpot alone lets it sink by rho g 6 m / (rho c_P) = 12 mm/s.
  EXPECT_LT(creep, 1e-6 * 9.81 * 6.0 / 4804.0);
}

TEST(FixMuckpileQuiet, LetsAJoltOutAndBooksIt) {
  double left[2] = {};
  for (const bool quiet : {false, true}) {
    Column column(MPI_COMM_WORLD);
    column.jolt(1.0);
    const double sent = column.scene.kinetic_energy();
    if (quiet) column.quiet("rock_behind 30");
    column.scene.run(400, kStep);  // 8 ms: six times up or down
    left[quiet ? 1 : 0] = (column.scene.kinetic_energy() + column.scene.output("joint", 4)) / sent;
    // K at full steps against leapfrog's own energy: (omega dt)^2/8 of the shortest waves.
    EXPECT_LT(column.scene.output("energy", 0), 0.01);
    if (!quiet) continue;
    EXPECT_DOUBLE_EQ(column.scene.output("energy", 12), column.scene.output("quiet", given));
    EXPECT_NEAR(column.scene.output("quiet", given) / sent, 1.0 - left[1], 0.01);
    EXPECT_NEAR(column.scene.output("quiet", radiated) / sent, 1.0 - left[1], 0.02);
  }
  EXPECT_GT(left[0], 0.99);
  EXPECT_LT(left[1], 0.01);  // ten blocks to a wave of 6 m, 30 m of rock behind
}

TEST(FixMuckpileQuiet, RanksShareTheBoundaryWithoutChangingIt) {
  Column alone(MPI_COMM_SELF), shared(MPI_COMM_WORLD);
  for (Column* column : {&alone, &shared}) {
    column->quiet("rock_behind 30");
    column->jolt(1.0);
    column->scene.run(300, kStep);
  }
  const auto one = alone.scene.blocks(), two = shared.scene.blocks();
  ASSERT_EQ(one.size(), two.size());
  for (const auto& [tag, block] : one)
    EXPECT_LT((block.velocity - two.at(tag).velocity).norm(), 1e-10) << tag;  // of 1 m/s
  for (const int n : {0, 1, 2})
    EXPECT_NEAR(shared.scene.output("quiet", n) / alone.scene.output("quiet", n), 1.0, 1e-9) << n;
}

TEST(FixMuckpileQuiet, StopsWhenTheWaveHasPassedAndChangesLittle) {
  Column always(MPI_COMM_WORLD), passing(MPI_COMM_WORLD);
  always.quiet("rock_behind 30");
  passing.quiet("rock_behind 30 power_share 0.001 every 20");
  for (Column* column : {&always, &passing}) {
    column->jolt(1.0);
    column->scene.run(60, kStep);
    EXPECT_EQ(column->scene.output("quiet", over), 0.0);
    column->scene.run(940, kStep);
  }
  EXPECT_EQ(always.scene.output("quiet", over), 0.0);
  EXPECT_EQ(passing.scene.output("quiet", over), 1.0);
  EXPECT_EQ(passing.scene.output("quiet", yielding), 0.0);
  EXPECT_EQ(passing.scene.output("quiet", power), 0.0);
  // The tail of the jolt is kept in: 1 % of its energy at most.
  EXPECT_NEAR(passing.scene.output("quiet", given) / always.scene.output("quiet", given), 1.0,
              0.01);
}

TEST(FixMuckpileQuiet, StopsAtTheGivenTimeAndWhenTheRockIsSoftened) {
  Column column(MPI_COMM_WORLD), softened(MPI_COMM_WORLD);
  for (Column* c : {&column, &softened}) {
    c->quiet("rock_behind 30 until 1e-3 every 10");
    c->jolt(1.0);
  }
  column.scene.run(40, kStep);  // 0.8 ms
  EXPECT_GT(column.scene.output("quiet", yielding), 0.0);
  column.scene.run(20, kStep);
  EXPECT_EQ(column.scene.output("quiet", over), 1.0);
  const double taken = column.scene.output("quiet", given);
  column.scene.run(100, kStep);
  EXPECT_EQ(column.scene.output("quiet", given), taken);

  softened.scene.run(20, kStep);
  softened.scene.command("fix_modify joint soften 0.5");
  EXPECT_EQ(softened.scene.output("quiet", yielding), 0.0);
  softened.scene.run(20, kStep);
  EXPECT_EQ(softened.scene.output("quiet", yielding), 0.0);
  EXPECT_EQ(softened.scene.output("quiet", over), 1.0);
}

TEST(FixMuckpileQuiet, UnfixMakesAFixedSupportOfIt) {
  Column column(MPI_COMM_WORLD);
  column.quiet("rock_behind 3");
  column.jolt(1.0);
  column.scene.run(100, kStep);
  column.scene.command("unfix quiet");
  const double before = column.scene.output("energy", 12);
  EXPECT_GT(before, 0.0);
  column.scene.run(100, kStep);
  EXPECT_EQ(column.scene.output("energy", 12), before);
}

TEST(FixMuckpileQuiet, BrokenSupportsStopYielding) {
  Column column(MPI_COMM_WORLD, "cohesion 4e6 tension 2e6");
  column.quiet("rock_behind 30");
  // Up as a whole: rho c_P x 1 m/s = 12 MPa at the base, six times what it holds.
  column.scene.set_motion([](int, const Vec3&) { return Motion{Vec3::UnitZ(), Vec3::Zero()}; });
  column.scene.run(0, kStep);
  const double begun = column.scene.output("quiet", yielding);
  column.scene.run(200, kStep);
  EXPECT_LT(column.scene.output("quiet", yielding), begun);
  EXPECT_LT(column.scene.output("energy", 0), 0.03);
}

TEST(FixMuckpileQuiet, PowerIsThatBetweenLooksInAnyRunAndAnyFix) {
  Column one(MPI_COMM_WORLD), two(MPI_COMM_WORLD);
  for (Column* column : {&one, &two}) {
    column->quiet("rock_behind 30 power_share 0.001 every 20");
    column->jolt(1.0);
  }
  one.scene.run(60, kStep);
  two.scene.run(50, kStep);
  two.scene.run(10, kStep);
  EXPECT_NEAR(two.scene.output("quiet", power) / one.scene.output("quiet", power), 1.0, 1e-9);
  one.scene.command("unfix quiet");
  one.quiet("rock_behind 30 every 20");
  one.scene.run(0, kStep);
  const double before = one.scene.output("quiet", radiated);
  one.scene.run(20, kStep);
  const double more = one.scene.output("quiet", radiated) - before;
  EXPECT_NEAR(one.scene.output("quiet", power), more / (20 * kStep), 1e-6 * before / kStep);
}

}  // namespace
}  // namespace muckpile::test
