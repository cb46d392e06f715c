// SPDX-License-Identifier: GPL-2.0-or-later
// Edges that polygons share, on squares whose edges are known by hand.
// Scope: geometry only.
#include <gtest/gtest.h>

#include <vector>

#include "geometry/shape/shared_edge.h"

namespace muckpile {
namespace {

using Face = std::vector<Vec3>;

/// A unit square from a corner along x and up along `up`.
Face square(const Vec3& corner, const Vec3& up) {
  return {corner, corner + Vec3::UnitX(), corner + Vec3::UnitX() + up, corner + up};
}

const Face kFloor = square({0.0, 0.0, 0.0}, Vec3::UnitY());

TEST(SharedEdge, OfTwoSquaresSideBySideIsWhole) {
  EXPECT_NEAR(shared_edge_length(kFloor, square({0.0, 1.0, 0.0}, Vec3::UnitY()), 1.0), 1.0, 1e-12);
}

TEST(SharedEdge, RunsAroundABend) {
  EXPECT_TRUE(share_an_edge(kFloor, square({0.0, 1.0, 0.0}, Vec3::UnitZ()), 1.0));
}

TEST(SharedEdge, OfShiftedSquaresIsWhatOverlaps) {
  EXPECT_NEAR(shared_edge_length(kFloor, square({0.7, 1.0, 0.0}, Vec3::UnitZ()), 1.0), 0.3, 1e-12);
}

TEST(SharedEdge, MayBeDividedByCorners) {
  const Face divided{{0, 1, 0}, {0.4, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  EXPECT_NEAR(shared_edge_length(kFloor, divided, 1.0), 1.0, 1e-12);
}

TEST(SharedEdge, IsNoneInACorner) {
  const Face at_a_corner = square({1.0, 1.0, 0.0}, Vec3::UnitY());
  EXPECT_EQ(shared_edge_length(kFloor, at_a_corner, 1.0), 0.0);
  EXPECT_FALSE(share_an_edge(kFloor, at_a_corner, 1.0));
  EXPECT_FALSE(share_an_edge(kFloor, square({0.995, 1.0, 0.0}, Vec3::UnitY()), 1.0));  // 5 mm
}

TEST(SharedEdge, IsNoneWhereEdgesCrossOrRunBesideEachOther) {
  EXPECT_FALSE(share_an_edge(kFloor, square({0.0, 1.01, 0.0}, Vec3::UnitY()), 1.0));
  const Face across{{0.5, 1.0, -0.5}, {0.5, 1.0, 0.5}, {0.5, 2.0, 0.5}, {0.5, 2.0, -0.5}};
  EXPECT_EQ(shared_edge_length(kFloor, across, 1.0), 0.0);
}

TEST(SharedEdge, ForgivesTheRoundingOfTwoBlocks) {
  EXPECT_TRUE(share_an_edge(kFloor, square({0.0, 1.0 + 1e-6, 1e-6}, Vec3::UnitZ()), 1.0));
}

}  // namespace
}  // namespace muckpile
