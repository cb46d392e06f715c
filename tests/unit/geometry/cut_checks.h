// SPDX-License-Identifier: GPL-2.0-or-later
// What every cut of rock must satisfy, however it was made.
// Scope: tests only; GoogleTest expectations on blocks and their neighbours.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "geometry/block_model.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile::test {

/// `rounding`: of areas, over those of cuts by planes that are known to rounding.
inline void expect_convex_and_closed(const Block& block, double rounding = 1.0) {
  const double area = std::pow(block.mass.volume, 2.0 / 3.0), size = std::sqrt(area);
  EXPECT_GT(block.mass.volume, 0.0);
  EXPECT_LT(area_vector_sum(block.shape).norm(), rounding * 1e-9 * area);
  ASSERT_EQ(block.neighbour.size(), block.shape.faces.size());
  for (std::size_t f = 0; f < block.shape.faces.size(); ++f) {
    const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
    if (face.area < 1e-6 * area) continue;  // no direction to speak of
    for (const Vec3& v : block.shape.vertices)
      EXPECT_LT(face.normal.dot(v - face.centroid), 1e-6 * size);
  }
}

/// Each block's faces against another have, together, the area and centroid of the other's against
/// it. Returns the area of all of them, both sides [m2].
inline double expect_shared_faces(const std::vector<Block>& blocks, double rounding = 1.0) {
  std::map<std::pair<int, int>, std::pair<double, Vec3>> shared;
  double all = 0.0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::size_t f = 0; f < blocks[b].neighbour.size(); ++f) {
      const int other = blocks[b].neighbour[f];
      if (other < 0) continue;
      const FaceGeometry face = face_geometry(blocks[b].shape, static_cast<int>(f));
      auto& [area, moment] =
          shared.try_emplace({static_cast<int>(b), other}, 0.0, Vec3::Zero()).first->second;
      area += face.area;
      moment += face.area * face.centroid;
      all += face.area;
    }
  }
  for (const auto& [pair, mine] : shared) {
    const double size = std::cbrt(blocks[static_cast<std::size_t>(pair.first)].mass.volume);
    const auto back = shared.find({pair.second, pair.first});
    if (back == shared.end()) {
      ADD_FAILURE() << pair.first << " has a face on " << pair.second << " of area " << mine.first
                    << " and not the other way round";
      continue;
    }
    EXPECT_NEAR(mine.first, back->second.first, rounding * 1e-9 * size * size);
    EXPECT_LT((mine.second - back->second.second).norm(), rounding * 1e-8 * size * size);
  }
  return all;
}

inline void expect_sound_cut(const std::vector<Block>& blocks, double volume,
                             double rounding = 1.0) {
  double sum = 0.0;
  for (const Block& block : blocks) {
    expect_convex_and_closed(block, rounding);
    sum += block.mass.volume;
  }
  EXPECT_NEAR(sum, volume, 1e-9 * volume);
  (void)expect_shared_faces(blocks, rounding);
}

/// Blocks with 3 V / A below this share of the size asked for.
inline std::size_t slivers(const std::vector<Block>& blocks, double share) {
  std::size_t count = 0;
  for (const Block& block : blocks)
    count += mean_radius(block.shape) < share * block.target_size ? 1 : 0;
  return count;
}

}  // namespace muckpile::test
