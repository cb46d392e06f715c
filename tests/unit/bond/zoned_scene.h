// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks of two rocks, without the engine.
// Scope: tests only; cuboids and Voronoi blocks of about 1 m.
#pragma once

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "bond_scene.h"

namespace muckpile::test {

/// Softer, lighter, and of another Poisson ratio than rock(0.25).
inline JointParameters soft(double poisson_ratio = 0.4) {
  JointParameters p = rock(poisson_ratio);
  p.youngs_modulus = 10e9;
  p.density = 2200.0;
  return p;
}

struct ZonedBlocks {
  std::vector<Block> blocks;
  std::vector<std::uint8_t> of;
};

inline ZonedBlocks in_zones(std::vector<Block> blocks, const std::function<bool(const Vec3&)>& is_soft) {
  ZonedBlocks zoned{std::move(blocks), {}};
  for (const Block& block : zoned.blocks) zoned.of.push_back(is_soft(block.mass.centroid) ? 1 : 0);
  return zoned;
}

inline bool below_3(const Vec3& x) { return x.z() < 3.0; }
inline bool lower_part(const Vec3& x) { return x.z() < 0.1; }  // of a cube about the origin
inline bool odd_layer(const Vec3& x) { return static_cast<int>(std::floor(x.z())) % 2 != 0; }
inline bool checkered(const Vec3& x) {
  return (static_cast<int>(std::floor(x.x()) + std::floor(x.y()) + std::floor(x.z())) & 1) != 0;
}

inline BondScene scene_of(const ZonedBlocks& rock, const JointParameters& hard,
                   const JointParameters& other, Leaning leaning = Leaning::little) {
  return {rock.blocks, hard,    [](const Vec3&) { return Support::free; },
          {},          leaning, {{other}, rock.of}};
}

}  // namespace muckpile::test
