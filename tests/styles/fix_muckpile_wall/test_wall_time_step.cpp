// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts with fix muckpile/wall, and of blocks with each other, in the bounds of fix
// muckpile/timestep; the same on any number of ranks.
// Scope: one block, or some 27 of 0.5 m.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>

#include "contact/contact_step_bound.h"
#include "wall/wall_law.h"
#include "wall_scene.h"

namespace muckpile::test {
namespace {

/// Springs of a sphere that touches with stiffness k along the normal and kt across it, at an arm L
/// from the centre of its cube: k / m, and the larger root for shift and turn together,
/// ((kt, kt L), (kt L, kt (L^2 + R^2))) over mass and moment of inertia.
double longest_step(const BlockNow& block, const SphereNow& sphere, double modulus) {
  const double overlap = sphere.radius - sphere.centre.z(), nu = 0.25;
  const double root = std::sqrt(sphere.radius * overlap);
  const double normal = modulus / (1.0 - nu * nu) * root;
  const double across = 2.0 * modulus / ((1.0 + nu) * (2.0 - nu)) * root;
  const double arm = block.centre.z() + 0.5 * overlap;  // half of the overlap is below the plane
  const double inertia = block.inertia(0, 0), r = sphere.radius;
  const double shift = across / block.mass, turn = across * (arm * arm + r * r) / inertia;
  const double both = across * arm / std::sqrt(block.mass * inertia);
  const double root_of_both =
      0.5 * (shift + turn) + std::sqrt(0.25 * std::pow(shift - turn, 2) + both * both);
  return 2.0 / std::sqrt(std::max(normal / block.mass, root_of_both));
}

/// On a ground as stiff as the rock, and on one a hundred times as stiff.
TEST(FixMuckpileWall, TimeStepKnowsItsContacts) {
  for (const double ground : {2.5e7, 2.5e9}) {
    RockScene scene =
        scene_on(MPI_COMM_WORLD, kPlane + " youngs_modulus " + std::to_string(ground), 0.5);
    scene.cut("0 0.5 -0.25 0.25 0.3 0.8", words(1));
    scene.set_motion([](int, const Vec3&) { return Motion{Vec3(0, 0, -10), Vec3::Zero()}; });
    scene.command("fix dt all muckpile/timestep every 1 max " + std::to_string(kStep));
    scene.run(0, kStep);
    EXPECT_TRUE(std::isinf(scene.output("dt", 2)));  // nothing touches
    for (int look = 0; look < 200 && scene.output("floor", contacts) == 0.0; ++look)
      scene.run(10, kStep);
    scene.run(100, kStep);
    const double modulus = 2.0 / (1.0 / 2.5e7 + 1.0 / ground);
    const double theory = longest_step(scene.blocks().at(1), scene.all_spheres().at(1), modulus);
    std::cout << "longest step: " << scene.output("dt", 2) << " s, off by "
              << scene.output("dt", 2) / theory - 1.0 << "\n";
    EXPECT_NEAR(scene.output("dt", 2) / theory, 1.0, 1e-6);
    EXPECT_LT(scene.output("dt", 6), scene.output("dt", 2));  // with the dashpots
  }
}

/// The first look may come before the wall has listed what is near it.
TEST(FixMuckpileWall, TimeStepKnowsItsLightCollisionsInTheOrderOfAnyScript) {
  std::array<double, 2> steps{};
  for (const bool wall_first : {true, false}) {
    RockScene scene(MPI_COMM_WORLD, "-12 12 -4 4 -4 6", "* * 1", "multisphere/muckpile");
    add_contacts(scene, 0.5, "friction 0.3 rolling_friction 0", "0.3");
    const std::string wall = "fix floor all " + kPlane + " youngs_modulus 2.5e9";
    if (wall_first) scene.command(wall);
    scene.command("fix dt all muckpile/timestep max 1");
    if (!wall_first) scene.command(wall);
    scene.cut("0 0.5 -0.25 0.25 0.3 0.8", words(1));
    scene.run(0, kStep);
    steps[wall_first ? 0 : 1] = scene.output("dt", 7);
  }
  EXPECT_EQ(steps[0], steps[1]);
  EXPECT_GT(steps[0], 0.0);
}

/// Nine blocks that part as they fall, so that they touch the floor alone; spheres of those in the
/// middle lie on other ranks than those that move them.
RockScene parting(MPI_Comm comm, const std::string& wall) {
  RockScene scene = scene_on(comm, wall, 0.5);
  scene.cut("-0.75 0.75 -0.75 0.75 0.1 0.6", words(5, 1.0));
  scene.set_motion([](int, const Vec3& at) {
    return Motion{Vec3(3.0 * at.x() + 0.5, 3.0 * at.y() + 0.3, -5.0), Vec3::Zero()};
  });
  scene.command("fix dt all muckpile/timestep every 1 max " + std::to_string(kStep));
  scene.run(1000, kStep);
  return scene;
}

/// Bounds of two scenes with fix muckpile/timestep, by springs and with dashpots, over some looks.
struct Apart {
  double worst = 0.0;
  int looks_with_contacts = 0;
};
Apart bounds_apart(RockScene& alone, RockScene& together, int looks, int steps) {
  Apart apart;
  for (int look = 0; look < looks; ++look) {
    alone.run(steps, kStep);
    together.run(steps, kStep);
    bool any = false;
    for (const int entry : {2, 6}) {
      const double one = alone.output("dt", entry), other = together.output("dt", entry);
      if (!std::isfinite(one)) continue;
      any = true;
      apart.worst = std::max(apart.worst, std::abs(other / one - 1.0));
    }
    if (any) ++apart.looks_with_contacts;
  }
  return apart;
}

TEST(FixMuckpileWall, TimeStepIsTheSameOnAnyNumberOfRanks) {
  const ScratchFolder folder("wall_step");
  const std::string wall = "muckpile/wall mesh " + mesh_of(folder, 12.0, 4.0, 30);
  RockScene alone = parting(MPI_COMM_SELF, wall), together = parting(MPI_COMM_WORLD, wall);
  const Apart apart = bounds_apart(alone, together, 20, 50);
  std::cout << "longest step on several ranks: off by " << apart.worst << "\n";
  EXPECT_GT(apart.looks_with_contacts, 10);
  EXPECT_LT(apart.worst, 1e-6);
}

/// Blocks that touch where their spheres lie on other ranks than those that move them, with
/// overlaps that carry no force among them.
TEST(FixMuckpileWall, TimeStepOfBlocksAmongThemselvesIsTheSameOnAnyNumberOfRanks) {
  const auto heap = [](MPI_Comm comm) {
    RockScene scene = scene_on(comm, kPlane, 0.5);
    scene.cut("-0.75 0.75 -0.75 0.75 0.1 1.6", words(5));
    scene.command("fix weight all gravity 9.81 vector 0 0 -1");
    scene.set_motion([](int tag, const Vec3& at) {
      return Motion{Vec3(-2.0 * at.x() + 0.5, -2.0 * at.y(), -3.0), Vec3(3, tag % 5, -2)};
    });
    scene.command("fix dt all muckpile/timestep every 1 max " + std::to_string(kStep));
    return scene;
  };
  RockScene alone = heap(MPI_COMM_SELF), together = heap(MPI_COMM_WORLD);
  const Apart apart = bounds_apart(alone, together, 12, 50);
  std::cout << "longest step of 27 blocks on several ranks: off by " << apart.worst << ", "
            << apart.looks_with_contacts << " looks with contacts\n";
  EXPECT_GT(apart.looks_with_contacts, 8);
  EXPECT_LT(apart.worst, 1e-6);  // rounding grows from impact to impact
}

const std::string kJoints =
    " youngs_modulus 50e9 poisson_ratio 0.25 density 2600 friction_angle 45 cohesion 1e12 tension "
    "1e12 contact_check no";

/// A block on one contact with what stands still, by the bound itself.
double longest_step_on(const BlockNow& block, const SphereNow& sphere, const WallContact& contact,
                       const WallLaw& law) {
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(block.inertia);
  ContactStepBound bound({{block.mass, axes.eigenvalues(), axes.eigenvectors()}});
  const WallSphere ball{sphere.centre, sphere.velocity, block.spin, sphere.radius, block.mass};
  bound.add(0, law.resistance(ball, contact), contact.normal,
            sphere.centre + WallLaw::arm(sphere.radius, contact) - block.centre,
            std::numeric_limits<double>::infinity());
  return bound.steps(false).springs;
}

/// The block amid 26 others to which it is joined; a plane of its own reaches 50 mm into its
/// sphere. No other block can touch it there, but the plane does.
TEST(FixMuckpileWall, TimeStepKnowsContactsOfEnclosedBlocksOnAnyRanks) {
  ContactParameters rock;
  rock.model = NormalModel::linear;
  rock.youngs_modulus = 2.5e7;
  RockScene scene(MPI_COMM_WORLD, "-12 12 -4 4 -4 6", "* * 1", "multisphere/muckpile");
  scene.command("pair_style muckpile/block model linear youngs_modulus 2.5e7");
  scene.command("pair_coeff * *");
  scene.cut("-0.75 0.75 -0.75 0.75 -0.75 0.75", words(1, 1.0));
  scene.command("fix joint all muckpile/joint" + kJoints);
  const auto spheres = scene.all_spheres();
  const auto nearer = [](const auto& a, const auto& b) {
    return a.second.centre.norm() < b.second.centre.norm();
  };
  const auto [tag, sphere] = *std::min_element(spheres.begin(), spheres.end(), nearer);
  constexpr double kDeep = 0.05;  // [m]
  scene.command("group inner id " + std::to_string(tag));
  scene.command("fix floor inner muckpile/wall plane 0 0 " +
                std::to_string(sphere.centre.z() - sphere.radius + kDeep) + " 0 0 1");
  scene.command("fix dt all muckpile/timestep every 1 max " + std::to_string(kStep));
  scene.run(0, 1e-9);
  EXPECT_EQ(scene.output("floor", contacts), 1.0);
  const double theory = longest_step_on(scene.blocks().at(tag), sphere,
                                        {Vec3::UnitZ(), {}, 0.0, kDeep}, WallLaw(rock));
  std::cout << "longest step of an enclosed block: off by " << scene.output("dt", 8) / theory - 1.0
            << "\n";
  EXPECT_NEAR(scene.output("dt", 8) / theory, 1.0, 1e-4);  // the plane's height has six digits
}

}  // namespace
}  // namespace muckpile::test
