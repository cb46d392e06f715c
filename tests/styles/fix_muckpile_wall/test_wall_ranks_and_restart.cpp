// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/wall on several ranks and from restart files: the memory of contacts goes along.
// Scope: one block, or some 27 of 0.5 m.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>

#include "wall_scene.h"

namespace muckpile::test {
namespace {

const std::string kTorsion = " rolling_friction 0.3 torsion yes";

/// Blocks cross the borders between ranks while they slide.
TEST(FixMuckpileWall, RanksDoNotMatter) {
  const ScratchFolder folder("wall_ranks");
  const std::string mesh = "muckpile/wall mesh " + mesh_of(folder, 12.0, 4.0, 30);
  for (const std::string& wall : {mesh, mesh + kTorsion}) {
    RockScene alone = thrown(MPI_COMM_SELF, wall, 3.0);
    RockScene together = thrown(MPI_COMM_WORLD, wall, 3.0);
    alone.run(8000, kStep);
    together.run(8000, kStep);
    std::cout << "ranks: apart by " << farthest_apart(alone, together) << " m\n";
    EXPECT_LT(farthest_apart(alone, together), 1e-7);
    for (const int entry : {stored, rubbed, damped})
      EXPECT_NEAR(alone.output("floor", entry), together.output("floor", entry),
                  1e-5 * std::abs(alone.output("floor", entry)));
  }
}

/// A block that is pressed through the floor and moves on along x, from a corner at x [m].
RockScene pressed_through(MPI_Comm comm, const std::string& wall, double x) {
  RockScene scene = scene_on(comm, wall, 1.0);
  scene.command("neighbor 1e-4 bin");  // spheres are exchanged at every step
  scene.cut(std::to_string(x) + " " + std::to_string(x + 0.5) + " -0.25 0.25 0.01 0.51",
            words(1, 1.0));
  scene.set_motion([](int, const Vec3&) { return Motion{Vec3(20, 0, -80), Vec3::Zero()}; });
  return scene;
}

/// The border between two ranks lies at x = 0, where it comes by in the step that lets it go.
TEST(FixMuckpileWall, RanksCountASphereThatIsLetGoAsItChangesThem) {
  const ScratchFolder folder("wall_crossing");
  const std::string wall = "muckpile/wall mesh " + mesh_of(folder, 12.0, 4.0, 7);
  constexpr double kShort = 0.5 * kStep;
  RockScene alone = pressed_through(MPI_COMM_SELF, wall, 0.0);
  double before = 0.0, at = 0.0;
  int steps = 0;
  for (; steps < 3000 && (steps == 0 || alone.output("floor", let_go) == 0.0); ++steps) {
    before = at;
    alone.run(1, kShort);
    at = alone.all_spheres().at(1).centre.x();
  }
  ASSERT_EQ(alone.output("floor", let_go), 1.0);
  RockScene together = pressed_through(MPI_COMM_WORLD, wall, -0.5 * (before + at));
  for (int k = 1; k < steps; ++k) together.run(1, kShort);
  EXPECT_LT(together.all_spheres().at(1).centre.x(), 0.0);
  EXPECT_EQ(together.output("floor", let_go), 0.0);
  together.run(1, kShort);
  EXPECT_GT(together.all_spheres().at(1).centre.x(), 0.0);
  EXPECT_EQ(together.output("floor", let_go), 1.0);
}

/// In the middle of sliding, with the step before and behind it.
void go_on_from_a_restart(const std::string& wall) {
  const ScratchFolder folder("wall_restart");
  const std::string file = (folder / "sliding.restart").string();
  RockScene went_on = thrown(MPI_COMM_WORLD, wall, 3.0);
  went_on.run(4000, kStep);
  ASSERT_GT(went_on.output("floor", contacts), 5.0);
  const double rubbed_so_far = went_on.output("floor", rubbed);
  went_on.command("write_restart " + file);
  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add_wall(restarted, wall, 0.5);
  restarted.command("fix weight all gravity 9.81 vector 0 0 -1");
  restarted.run(0, kStep);
  EXPECT_NEAR(restarted.output("floor", rubbed), rubbed_so_far, 1e-9 * rubbed_so_far);
  went_on.run(300, kStep);
  restarted.run(300, kStep);
  std::cout << "restart: apart by " << farthest_apart(went_on, restarted) << " m\n";
  EXPECT_LT(farthest_apart(went_on, restarted), 1e-6);
}

TEST(FixMuckpileWall, RestartGoesOnWithTheMemoryOfItsContacts) {
  go_on_from_a_restart(kPlane);
  go_on_from_a_restart(kPlane + kTorsion);
}

/// So that the two tests above are about something.
TEST(FixMuckpileWall, TorsionSlowsBlocksThatSpin) {
  RockScene free = thrown(MPI_COMM_WORLD, kPlane + " rolling_friction 0.3", 3.0);
  RockScene held = thrown(MPI_COMM_WORLD, kPlane + kTorsion, 3.0);
  free.run(8000, kStep);
  held.run(8000, kStep);
  EXPECT_GT(farthest_apart(free, held), 1e-4);
}

}  // namespace
}  // namespace muckpile::test
