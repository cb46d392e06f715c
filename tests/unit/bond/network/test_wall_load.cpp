// SPDX-License-Identifier: GPL-2.0-or-later
// Pressure on the wall of a crushed zone: it acts while the block is joined behind, and ends
// once gas flows round it.
// Scope: two unit cubes along x, the face x = 0 of block 0 on the chamber; its area is 1 m2.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bond_scene.h"

namespace muckpile::test {
namespace {

constexpr double kPressure = 1e6;  // [Pa]
const double kRadius = std::sqrt(1.0 / M_PI);

class Wall {
 public:
  Wall() : scene(cuboids(2, 1, 1), weak()) {
    FacetLists lists = scene.network().lists();
    for (BoundaryFace& face : lists.faces) {
      if (face.normal.x() < -0.5) face.hole = 0;
    }
    scene.network().set_facets(std::move(lists));
    scene.compute();
  }
  BoundaryFace& face() {
    for (BoundaryFace& face : scene.network().faces()) {
      if (face.hole == 0) return face;
    }
    throw std::runtime_error("no loaded face");
  }
  /// As fix muckpile/joint does.
  void load(double pressure) { face().pressure = face().load_share * pressure; }
  /// Block 1 is put there; the pressure is that of the pose before.
  void put(const Vec3& jump) {
    scene.block(1).centre = scene.start(1) + jump;
    load(kPressure);
    scene.compute(1e-6);
  }

  BondScene scene;

 private:
  static JointParameters weak() {
    JointParameters p = rock(0.0);
    p.tension = 2e6;
    p.cohesion = 4e6;
    p.friction_angle = 0.9;
    p.residual_friction_angle = 0.6;
    return p;
  }
};

TEST(WallLoad, ActsInFullWhileTheJointBehindHoldsOrIsClosed) {
  Wall wall;
  EXPECT_DOUBLE_EQ(wall.face().load_share, 1.0);
  wall.put({1e-3, 0, 0});  // 50 GPa/m x 1 mm = 50 MPa: broken
  ASSERT_GT(wall.scene.network().broken_count(), 0.0);
  wall.put({-1e-5, 0, 0});
  EXPECT_DOUBLE_EQ(wall.face().load_share, 1.0);
  wall.put({0.09 * kRadius, 0, 0});  // open, but not yet by a tenth of the radius
  EXPECT_DOUBLE_EQ(wall.face().load_share, 1.0);
}

TEST(WallLoad, FadesWithTheJointThatSlides) {
  Wall wall;
  wall.put({-1e-4, 0.3 * kRadius, 0});  // breaks
  wall.put({-1e-4, 0.3 * kRadius, 0});  // fades: (0.5 - 0.3)/(0.5 - 0.1) = 0.5
  EXPECT_NEAR(wall.face().load_share, 0.5, 1e-9);
}

TEST(WallLoad, EndsOnceTheBlockBehindHasGoneAhead) {
  Wall wall;
  wall.put({1e-3, 0, 0});
  wall.put({0.11 * kRadius, 0, 0});
  EXPECT_EQ(wall.face().load_share, 0.0);
  wall.put({0.11 * kRadius, 0, 0});
  EXPECT_EQ(wall.scene.network().force()[0].norm(), 0.0);
  const double filled = wall.scene.network().volume_swept(wall.face());
  wall.scene.block(0).centre.x() += 0.05;
  wall.scene.compute(1e-6);
  EXPECT_EQ(wall.scene.network().volume_swept(wall.face()), filled);  // the gas is round it
}

TEST(WallLoad, IsNotReducedWhereTheGasBehindPressesByItself) {
  Wall wall;
  wall.scene.network().keep_gas_in_joints();
  wall.put({1e-3, 0, 0});
  wall.put({0.11 * kRadius, 0, 0});
  EXPECT_DOUBLE_EQ(wall.face().load_share, 1.0);
  wall.scene.network().release_gas(0);  // in the open: the gas is round the block
  wall.put({0.11 * kRadius, 0, 0});
  EXPECT_EQ(wall.face().load_share, 0.0);
}

/// Block 0 has y = 0 on another chamber: N0 = (-1, 0, 0), N1 = (0, -1, 0) m2. Once block 1 has gone
/// ahead the gas of the first is round the block, and along N1 nothing has changed.
TEST(WallLoad, OfOneChamberIsNotThatOfAnother) {
  Wall wall;
  FacetNetwork& network = wall.scene.network();
  FacetLists lists = network.lists();
  for (BoundaryFace& face : lists.faces) {
    if (face.block == 0 && face.normal.y() < -0.5) face.hole = 1;
  }
  network.set_facets(std::move(lists));
  const auto load_share = [&](int hole) {
    const auto found = std::find_if(network.faces().begin(), network.faces().end(),
                                    [hole](const BoundaryFace& f) { return f.hole == hole; });
    return found->load_share;
  };
  wall.scene.compute();
  EXPECT_DOUBLE_EQ(load_share(0), 1.0);
  EXPECT_DOUBLE_EQ(load_share(1), 1.0);
  wall.put({1e-3, 0, 0});
  wall.put({0.11 * kRadius, 0, 0});
  EXPECT_NEAR(load_share(0), 0.0, 1e-6);
  EXPECT_DOUBLE_EQ(load_share(1), 1.0);
}

/// A wall of 1e-4 m2 on a block of 6 m2: the sum of A n of the whole block is nothing to 1e-7 m2,
/// 1e-3 of the wall.
TEST(WallLoad, OfATinyFaceIsWholeWhileTheBlockIsHeld) {
  Wall wall;
  FacetNetwork& network = wall.scene.network();
  FacetLists lists = network.lists();
  std::vector<BoundaryFace>& faces = lists.faces;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (faces[k].hole != 0) continue;
    BoundaryFace rest = faces[k];
    rest.hole = -1;
    rest.area -= 1e-4 - 1e-7;  // as if single precision had rounded so
    faces[k].area = 1e-4;
    faces.push_back(rest);
    break;
  }
  network.set_facets(std::move(lists));
  wall.scene.compute();
  EXPECT_DOUBLE_EQ(wall.face().load_share, 1.0);
}

TEST(WallLoad, NothingIsSweptWhileNoPressureIsThereNorExpected) {
  Wall wall;
  const auto push_on = [&](double by) {
    wall.scene.block(0).centre.x() += by;
    wall.scene.block(1).centre.x() += by;
    wall.scene.compute(1e-6);
  };
  const auto swept = [&] { return wall.scene.network().volume_swept(wall.face()); };
  wall.load(kPressure);
  wall.scene.network().expect_pressure(false);
  const double start = swept();
  push_on(1e-3);                             // still under pressure
  EXPECT_NEAR(swept() - start, 1e-3, 1e-6);  // less what the wall itself gives way
  wall.load(0.0);
  push_on(1e-3);  // the last one
  const double end = swept();
  EXPECT_NEAR(end - start, 2e-3, 1e-4);  // the wall no longer gives way
  push_on(0.5);
  EXPECT_EQ(swept(), end);
  wall.scene.network().expect_pressure(true);
  push_on(0.0);
  EXPECT_NEAR(swept(), end, 1e-12);
  push_on(1e-3);
  EXPECT_NEAR(swept() - end, 1e-3, 1e-12);
}

TEST(WallLoad, WorkIsTheEnergyOfTheBlocksThroughTheChange) {
  // The wall pushes both blocks to 1e6 / (2 x 2600) m/s2 until block 1 is given 40 m/s more and
  // leaves block 0 behind; then block 0 keeps its speed.
  Wall wall;
  const double dt = 0.2 * wall.scene.stable_step();
  const auto run = [&](int steps) {
    for (int k = 0; k < steps; ++k) {
      wall.load(kPressure);
      wall.scene.step(dt);
    }
  };
  run(2000);
  wall.scene.block(1).velocity.x() += 40.0;
  const double start = wall.scene.energy_account();
  const double work = wall.scene.network().pressure_work();
  run(static_cast<int>(0.11 * kRadius / 40.0 / dt) + 50);
  ASSERT_EQ(wall.face().load_share, 0.0);
  const double speed = wall.scene.block(0).velocity.x();
  run(1000);
  EXPECT_NEAR(wall.scene.block(0).velocity.x(), speed, 1e-12 * speed);
  const double gained = wall.scene.network().pressure_work() - work;
  ASSERT_GT(gained, 1e3);
  EXPECT_NEAR(wall.scene.energy_account(), start, 5e-3 * gained);  // O(dt^2), and the break
}

}  // namespace
}  // namespace muckpile::test
