// SPDX-License-Identifier: GPL-2.0-or-later
// Boxes of rock to verify on: uniform, graded and joint-set cuts, elastic constants, plain springs.
// Scope: one corner at the origin; blocks of about 1 m unless said otherwise.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bond/build/facet_builder.h"
#include "bond/law/joint_material.h"
#include "geometry/block_model.h"
#include "geometry/cut/tessellation.h"
#include "geometry/shape/polygon.h"
#include "geometry/size/size_law.h"
#include "unit/bond/bond_scene.h"

namespace muckpile::verification {

using test::rock;

struct RockSample {
  std::vector<Block> blocks;
  Vec3 box;     ///< [m]
  double size;  ///< edge of the largest blocks [m]
  Leaning leaning = Leaning::little;
};

[[nodiscard]] RockSample uniform_rock(const Vec3& box, unsigned long seed = 1);
/// Cut along planes too.
[[nodiscard]] RockSample uniform_rock(const Vec3& box, const std::vector<CutPlane>& planes);
/// Sizes from 0.1 m on the z axis, which is an edge of the box, to 1 m at 5 m from it and beyond.
[[nodiscard]] RockSample graded_rock(const Vec3& box, unsigned long seed = 1);
/// Sizes by a law of the distance from a line [m].
[[nodiscard]] RockSample graded_rock(const Vec3& box, const std::pair<Vec3, Vec3>& line,
                                     const SizeLaw& size, unsigned long seed = 1);
/// Joint sets in bands, with the sizes of graded_rock, or all of 1 m; dip and dip direction [deg].
[[nodiscard]] RockSample banded_rock(const Vec3& box, const std::vector<Vec2>& sets, bool graded);
/// Three joint sets at right angles; numbers of blocks and edges [m].
[[nodiscard]] RockSample cuboid_rock(const Eigen::Vector3i& number, const Vec3& edge);

/// The sample and its image behind the wall at the far end of x, joined: the wall becomes a plane
/// of facets between blocks.
[[nodiscard]] RockSample with_mirror_image(const RockSample& sample);

/// Springs alone, for comparison: kn = (lambda + 2G)/h and ks = 2G/h per area, which give both wave
/// speeds along the axes of cubes. A network of equal springs and one of normal springs, added.
[[nodiscard]] std::vector<JointParameters> plain_springs(double poisson_ratio);

}  // namespace muckpile::verification
