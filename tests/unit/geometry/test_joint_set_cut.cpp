// SPDX-License-Identifier: GPL-2.0-or-later
// Joint sets in concentric bands: blocks are convex and closed, fill the rock, share every face,
// follow the size law and the sets, and keep out of holes and air.
// Scope: scenes of a few hundred blocks; lengths in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bond/build/facet_builder.h"
#include "bond/build/joint_plane.h"
#include "cut_checks.h"
#include "geometry/cut/joint_set_cut.h"
#include "geometry/shape/convex_cell.h"
#include "input_error_of.h"
#include "shapes.h"

namespace muckpile {
namespace {

const JointSetCut kUpright{{{Vec3::UnitX()}, {Vec3::UnitY()}, {Vec3::UnitZ()}}};
const JointSetCut kLeaning{
    {{normal_of_dip(1.2, 1.6)}, {normal_of_dip(1.4, 0.1)}, {normal_of_dip(0.2, 3.0)}}};

// A 3 x 2 x 3 m box around an inclined charge of 2 m, blocks 0.15 m at the hole to 0.6 m far away.
TessellationOptions blast_options() {
  TessellationOptions options;
  options.lo = Vec3(-1.5, -1.0, 0.0);
  options.hi = Vec3(1.5, 1.0, 3.0);
  options.holes = {{Vec3(-0.2, 0.0, 0.5), Vec3(0.2, 0.1, 2.4), 0.15}};
  options.size = SizeLaw::power({0.8, 1.0}, {0.15, 0.6});
  return options;
}

TEST(JointSetCut, CubesOfOneSize) {
  TessellationOptions options;
  options.hi = Vec3(4.0, 3.0, 2.0);
  const Tessellation cut = cut_by_joint_sets(options, kUpright);
  ASSERT_EQ(cut.blocks.size(), 24u);
  for (const Block& block : cut.blocks) {
    EXPECT_NEAR(block.mass.volume, 1.0, 1e-12);
    EXPECT_EQ(block.shape.faces.size(), 6u);
  }
  test::expect_sound_cut(cut.blocks, 24.0);
}

TEST(JointSetCut, BandsAroundAHole) {
  for (const JointSetCut& how : {kUpright, kLeaning}) {
    const Tessellation cut = cut_by_joint_sets(blast_options(), how);
    const TessellationStatistics& s = cut.statistics;
    test::expect_sound_cut(cut.blocks, s.box_volume - s.hole_volume[0]);
    EXPECT_NEAR(s.hole_volume[0] / s.cylinder_volume[0], 1.0, 0.02);
    EXPECT_EQ(test::slivers(cut.blocks, how.sliver), 0u);
    // Halving leaves a block within 2^(1/6) of the size asked for; the first ring, divided along
    // radii, and blocks at the box wall are farther off.
    EXPECT_NEAR(s.median_size_ratio, 1.0, 0.12);
  }
}

TEST(JointSetCut, FacesLieAlongTheSets) {
  TessellationOptions options = blast_options();
  options.holes.clear();
  options.fine_axes = {{Vec3(0.0, 0.0, 0.5), Vec3(0.0, 0.0, 2.5)}};
  const Tessellation cut = cut_by_joint_sets(options, kLeaning);
  ASSERT_GT(cut.blocks.size(), 100u);
  for (const Block& block : cut.blocks) {
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] < 0) continue;
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      double best = 0.0;
      for (const JointSet& set : kLeaning.sets)
        best = std::max(best, std::abs(set.normal.dot(face.normal)));
      EXPECT_NEAR(best, 1.0, 1e-7);
    }
  }
}

TEST(JointSetCut, SpacingIsThatOfTheBand) {  // of cubes 1 m: half as far apart within 1 m
  TessellationOptions options;
  options.hi = Vec3(8.0, 8.0, 1.0);
  options.fine_axes = {{Vec3(4.0, 4.0, 0.0), Vec3(4.0, 4.0, 1.0)}};
  options.size = SizeLaw::table({{0.0, 0.5}, {1.4, 0.5}, {1.41, 1.0}}, {0.5, 1.0});
  const Tessellation cut = cut_by_joint_sets(options, kUpright);
  test::expect_sound_cut(cut.blocks, 64.0);
  ASSERT_EQ(cut.blocks.size(), 60u + 4u * 8u);  // the four cells around the axis
  for (const Block& block : cut.blocks) {
    const Vec3 away = block.mass.centroid - Vec3(4.0, 4.0, 0.0);
    EXPECT_NEAR(block.mass.volume, away.head<2>().norm() < 1.2 ? 0.125 : 1.0, 1e-12);
  }
}

TEST(JointSetCut, SpacingsCanDiffer) {  // plates: 2 x 2 x 0.25 m of the volume of 1 m cubes
  JointSetCut how = kUpright;
  how.sets[2].spacing = 0.125;
  TessellationOptions options;
  options.hi = Vec3(4.0, 4.0, 1.0);
  const Tessellation cut = cut_by_joint_sets(options, how);
  ASSERT_EQ(cut.blocks.size(), 16u);
  for (const Block& block : cut.blocks) {
    const auto [from, to] = extent(block.shape, Vec3::UnitZ());
    EXPECT_NEAR(to - from, 0.25, 1e-12);
  }
}

TEST(JointSetCut, NaturalJointsGoThroughBands) {
  TessellationOptions options = blast_options();
  const CutPlane plane{Vec3(0.9, 0.0, 1.5), Vec3(1.0, 0.2, 0.1)};  // meets the long sides only
  options.planes = {plane};
  const Tessellation cut = cut_by_joint_sets(options, kLeaning);
  test::expect_sound_cut(cut.blocks, cut.statistics.box_volume - cut.statistics.hole_volume[0]);
  FacetSet set = build_facets(cut.blocks, 1, [](const Vec3&) { return Support::free; });
  assign_joint_classes({{plane.point, plane.normal, 1}}, cut.blocks, 1, set.facets);
  double area = 0.0;
  for (const Facet& facet : set.facets) area += facet.joint_class == 1 ? facet.area : 0.0;
  EXPECT_NEAR(area / (6.0 * plane.normal.norm()), 1.0, 1e-5);  // slivers have no facet
}

TEST(JointSetCut, FlatSurfacesOfARegionAreExact) {  // air where x > 0 and z > 0
  TessellationOptions options;
  options.lo = Vec3(-1.5, 0.0, -1.0);
  options.hi = Vec3(1.6, 1.5, 1.7);
  options.size = SizeLaw::uniform(0.3);
  options.region = test::bench_profile();
  for (const JointSetCut& how : {kUpright, kLeaning}) {
    const Tessellation cut = cut_by_joint_sets(options, how);
    test::expect_sound_cut(cut.blocks, (3.1 * 2.7 - 1.6 * 1.7) * 1.5);
    EXPECT_EQ(test::slivers(cut.blocks, how.sliver), 0u);
    for (const Block& block : cut.blocks) {
      for (const Vec3& v : block.shape.vertices) EXPECT_LT(std::min(v.x(), v.z()), 1e-9);
    }
  }
}

TEST(JointSetCut, CurvedSurfacesHaveOnePlanePerBlock) {  // a ball of radius 1
  TessellationOptions options;
  options.lo = Vec3::Constant(-1.0);
  options.hi = Vec3::Constant(1.0);
  options.size = SizeLaw::uniform(0.25);
  options.region.inside = [](const Vec3& p) { return p.norm() <= 1.0; };
  options.region.surface_points = [](const Vec3& p, double cutoff) {
    std::vector<Vec3> points;
    if (std::abs(p.norm() - 1.0) < cutoff) points.emplace_back(p.normalized());
    return points;
  };
  const Tessellation cut = cut_by_joint_sets(options, kLeaning);
  const double ball = 4.0 / 3.0 * M_PI;
  EXPECT_NEAR(cut.statistics.block_volume / ball, 1.0, 0.05);  // planes around it: 3.7 % too much
  test::expect_sound_cut(cut.blocks, cut.statistics.block_volume);
}

std::string refusal(const TessellationOptions& options, const JointSetCut& how) {
  return input_error_of([&] { (void)cut_by_joint_sets(options, how); });
}

TEST(JointSetCut, SaysWhatIsWrong) {
  TessellationOptions options;
  options.hi = Vec3::Constant(3.0);
  EXPECT_EQ(refusal(options, {{{Vec3::UnitX()}}}),
            "joint set cut: needs two or three sets, got '1'");
  EXPECT_EQ(refusal(options, {{{Vec3::UnitX()}, {Vec3(1.0, 0.05, 0.0)}, {Vec3::UnitZ()}}}),
            "joint set cut: the sets are nearly parallel to each other or to one line: their "
            "normals span '0.0499376', which must be >= 0.1");
  EXPECT_EQ(refusal(options, {kUpright.sets, 0.5}),
            "joint set cut: sliver must be >= 0 and <= 0.3, got '0.5'");
  options.max_blocks = 10;
  EXPECT_NE(refusal(options, kUpright).find("more than 10 blocks"), std::string::npos);
}

}  // namespace
}  // namespace muckpile
