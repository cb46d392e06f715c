// SPDX-License-Identifier: GPL-2.0-or-later
// Rigid body of a block: mass, centre and principal inertia of the polyhedron, spheres inside.
// Scope: against an independent integration over the polyhedron.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bond/build/rigid_body.h"
#include "bond_scene.h"

namespace muckpile::test {
namespace {

struct Moments {
  double mass = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

/// Density times the integrals of 1, x and x x^T: tetrahedra from a far apex, and on each the
/// 4-point formula that is exact for second degree (Hammer and Stroud 1956).
Moments integrate(const Polyhedron& shape, double density) {
  constexpr double kNear = 0.58541019662496852, kFar = 0.13819660112501050;
  const Vec3 apex(-3.1, 2.7, 5.3);
  Moments m;
  for (const auto& face : shape.faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const auto corner = [&](std::size_t n) {
        return shape.vertices[static_cast<std::size_t>(face[n])];
      };
      const std::array<Vec3, 4> tet{apex, corner(0), corner(k), corner(k + 1)};
      const double mass = density * (tet[1] - apex).dot((tet[2] - apex).cross(tet[3] - apex)) / 6.0;
      m.mass += mass;
      for (std::size_t near = 0; near < 4; ++near) {
        Vec3 at = (kNear - kFar) * tet[near];
        for (const Vec3& v : tet) at += kFar * v;
        m.first += 0.25 * mass * at;
        m.second += 0.25 * mass * at * at.transpose();
      }
    }
  }
  return m;
}

TEST(RigidBody, HasTheMassPropertiesOfThePolyhedron) {
  for (const Block& block : voronoi_blocks(3.0, 5, 0)) {
    const RigidBody body = rigid_body(block, 2600.0, {.count = 4});
    const Moments m = integrate(block.shape, 2600.0);
    const Vec3 centre = m.first / m.mass;
    const Mat3 about = m.second - m.mass * centre * centre.transpose();
    const Mat3 inertia = about.trace() * Mat3::Identity() - about;
    EXPECT_NEAR(body.mass / m.mass, 1.0, 1e-10);  // the acceptance of create_blocks
    EXPECT_LT((body.centre - centre).norm(), 1e-10);
    const Mat3 told = body.axes * body.inertia.asDiagonal() * body.axes.transpose();
    EXPECT_LT((told - inertia).norm(), 1e-10 * inertia.norm());
    EXPECT_NEAR(body.axes.determinant(), 1.0, 1e-12);  // right-handed, orthonormal to rounding
  }
}

TEST(RigidBody, TellsTheLargestOverlapOfNeighbours) {
  std::vector<Block> blocks = cuboids(2, 1, 1);
  std::vector<RigidBody> bodies(2);
  bodies[0].spheres = {{Vec3(0.5, 0.5, 0.5), 0.6}, {Vec3(0.2, 0.5, 0.5), 0.1}};
  bodies[1].spheres = {{Vec3(1.5, 0.5, 0.5), 0.5}};
  // 0.6 + 0.5 - 1.0 = 0.1 over the smaller radius 0.5
  EXPECT_NEAR(largest_overlap(blocks, bodies), 0.2, 1e-14);
}

}  // namespace
}  // namespace muckpile::test
