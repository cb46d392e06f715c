// SPDX-License-Identifier: GPL-2.0-or-later
// Stiffening of the facets on a crushed zone: by hand for a ring of six equal blocks, and what it
// leaves alone.
// Scope: rings of wedges with the axis z, radius 1 m inside; made here, not cut.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bond/build/wall_facets.h"
#include "bond_scene.h"
#include "geometry/shape/polyhedron.h"

namespace muckpile::test {
namespace {

constexpr int kSides = 6;
constexpr double kHeight = 1.0;               // [m]
constexpr double kRadii[] = {1.0, 2.0, 4.0};  // of the flats of the two rings [m]
const Vec3 kToe(3.0, -2.0, 5.0);              // the ring is about another place than the origin

Block wedge(int ring, int side) {
  const auto number = [](int of_ring, int of_side) {
    return of_ring * kSides + (of_side + kSides) % kSides;
  };
  Block block;
  const double corner = 1.0 / std::cos(M_PI / kSides);
  for (const double height : {0.0, kHeight}) {
    for (const auto& [out, turn] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      const double r = corner * kRadii[ring + out], angle = 2.0 * M_PI * (side + turn) / kSides;
      block.shape.vertices.push_back(kToe + Vec3(r * std::cos(angle), r * std::sin(angle), height));
    }
  }
  block.shape.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                       {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const int outer = ring == 0 ? number(1, side) : kFreeFace;
  const int inner = ring == 0 ? hole_face(0) : number(0, side);
  block.neighbour = {kFreeFace, kFreeFace, number(ring, side - 1), outer, number(ring, side + 1),
                     inner};
  block.mass = mass_properties(block.shape);
  return block;
}

std::vector<Block> two_rings() {
  std::vector<Block> blocks;
  for (const int ring : {0, 1})
    for (int side = 0; side < kSides; ++side) blocks.push_back(wedge(ring, side));
  return blocks;
}

FacetSet free_facets(const std::vector<Block>& blocks) {
  return build_facets(blocks, 1, [](const Vec3&) { return Support::free; });
}

const std::vector<Hole> kHoles = {{kToe, kToe + kHeight* Vec3::UnitZ(), 1.0}};

/// Of a wedge between flats at a and b: 2/3 (b^3 - a^3)/(b^2 - a^2).
double centre_of(double a, double b) {
  return 2.0 / 3.0 * (b * b * b - a * a * a) / (b * b - a * a);
}

TEST(WallFacets, StiffensSixEqualBlocksAsByHand) {
  const std::vector<Block> blocks = two_rings();
  FacetSet set = free_facets(blocks);
  fit_walls(blocks, 1, kHoles, set);
  // Flats of 2/sqrt(3) at 1 m, 4/sqrt(3) at 2 m; sides of (2 - 1) 2/sqrt(3), turned by 60 degrees.
  const double near = centre_of(1.0, 2.0), far = centre_of(2.0, 4.0), flat = 2.0 / std::sqrt(3.0);
  const double pressed = flat / near;  // A psi / a^2 of a block
  const double beyond = 2.0 * flat / (far - near) / near * (1.0 / near - 1.0 / far);
  const double in_ring = flat / near / (near * near);  // jump 1/near, distance near
  const double expected = (pressed - beyond) / in_ring;
  ASSERT_GT(expected, 1.0);
  for (const Facet& facet : set.facets) {
    const bool of_wall = facet.tag_i <= kSides && facet.tag_j <= kSides;
    EXPECT_NEAR(facet.stiffening, of_wall ? expected : 1.0, 1e-12)
        << "facet of blocks " << facet.tag_i << " and " << facet.tag_j;
  }
}

TEST(WallFacets, SweepsWhatLamesCylinderSweeps) {
  const std::vector<Block> blocks = two_rings();
  FacetSet set = free_facets(blocks);
  fit_walls(blocks, 1, kHoles, set);
  const double near = centre_of(1.0, 2.0);
  for (const BoundaryFace& face : set.faces) {
    // The block moves by 1/near, the face by 1: 1 - 1/near of a depth of near - 1.
    const double expected = face.hole == 0 ? (1.0 - 1.0 / near) / (near - 1.0) : 1.0;
    EXPECT_NEAR(face.depth_share, expected, 1e-12) << "face of block " << face.tag;
  }
}

TEST(WallFacets, LeavesRockWithoutHolesAlone) {
  const std::vector<Block> blocks = two_rings();
  FacetSet set = free_facets(blocks);
  fit_walls(blocks, 1, {}, set);
  for (const Facet& facet : set.facets) EXPECT_EQ(facet.stiffening, 1.0);
  for (const BoundaryFace& face : set.faces) EXPECT_EQ(face.depth_share, 1.0);
}

TEST(WallFacets, LeavesBlocksBeyondTheEndsOfAHoleAlone) {
  const std::vector<Block> blocks = two_rings();
  FacetSet set = free_facets(blocks);
  const std::vector<Hole> shorter = {{kToe + 0.6 * Vec3::UnitZ(), kToe + Vec3::UnitZ(), 1.0}};
  fit_walls(blocks, 1, shorter, set);  // the blocks' centres are at 0.5
  for (const Facet& facet : set.facets) EXPECT_EQ(facet.stiffening, 1.0);
}

TEST(WallFacets, AMirrorStandsForTheImageInTheRing) {
  const std::vector<Block> all = two_rings();
  FacetSet whole = free_facets(all);
  fit_walls(all, 1, kHoles, whole);
  std::vector<Block> half;  // the sides 0 to 2 of both rings, above the plane y = y of the toe
  for (const int ring : {0, 1})
    for (int side = 0; side < 3; ++side)
      half.push_back(all[static_cast<std::size_t>(6 * ring + side)]);
  for (Block& block : half) {
    for (int& other : block.neighbour) {
      if (other < 0) continue;
      const int ring = other / kSides, side = other % kSides;
      other = side < 3 ? 3 * ring + side : kFreeFace;
    }
  }
  FacetSet set = build_facets(half, 1, [](const Vec3& at) {
    return std::abs(at.y() - kToe.y()) < 1e-9 ? Support::mirror : Support::free;
  });
  fit_walls(half, 1, kHoles, set);
  for (const Facet& facet : set.facets) {
    const bool of_wall = facet.tag_i <= 3 && facet.tag_j <= 3;
    EXPECT_NEAR(facet.stiffening, of_wall ? whole.facets.front().stiffening : 1.0, 1e-12);
  }
}

TEST(WallFacets, ANetworkTakesTheStiffeningAndGivesItBack) {
  const std::vector<Block> blocks = two_rings();
  FacetSet set = free_facets(blocks);
  Facet facet = set.facets.front();
  facet.i = 0;
  facet.j = 1;
  const auto traction_per_jump = [&](double stiffening) {
    facet.stiffening = stiffening;
    FacetNetwork network{JointMaterial(rock(0.0))};
    network.set({{1, true, 1.0, 1.0, {}}, {2, true, 1.0, 1.0, {}}}, {{facet}, {}, {}});
    EXPECT_EQ(network.facet(0).stiffening, stiffening);
    return network.tables().bond(0).normal();
  };
  EXPECT_NEAR(traction_per_jump(1.5) / traction_per_jump(1.0), 1.5, 1e-12);
}

}  // namespace
}  // namespace muckpile::test
