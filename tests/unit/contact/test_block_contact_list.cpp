// SPDX-License-Identifier: GPL-2.0-or-later
// The candidate list of sphere pairs is complete, ordered and free of pairs nobody here owns.
// Scope: random blocks of spheres, compared with a search over all pairs of spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "contact/block_contact_list.h"

namespace muckpile {
namespace {

struct Scene {
  std::vector<double> positions, radii;
  std::vector<int> tags, blocks;
  int owned = 0, block_count = 0;
  [[nodiscard]] SphereSet view() const {
    return {positions.data(),
            radii.data(),
            tags.data(),
            blocks.data(),
            static_cast<int>(radii.size()),
            owned};
  }
};

// Blocks of nine spheres, sizes 10:1; sphere order mixed as a domain decomposition would.
Scene random_scene(int block_count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Scene scene;
  scene.block_count = block_count;
  std::vector<int> order;
  for (int k = 0; k < 9 * block_count; ++k) order.push_back(k);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<Vec3> centres;
  std::vector<double> sizes;
  for (int b = 0; b < block_count; ++b) {
    centres.emplace_back(3 * unit(random), 3 * unit(random), 3 * unit(random));
    sizes.push_back(0.1 * std::pow(10.0, unit(random)));
  }
  for (int k : order) {
    const auto b = static_cast<std::size_t>(k / 9);
    for (int d = 0; d < 3; ++d)
      scene.positions.push_back(centres[b][d] + sizes[b] * (unit(random) - 0.5));
    scene.radii.push_back(0.25 * sizes[b]);
    scene.tags.push_back(k + 1);
    scene.blocks.push_back(k / 9);
  }
  scene.owned = static_cast<int>(scene.radii.size()) / 2;
  return scene;
}

std::set<std::pair<int, int>> brute_force(const Scene& s, double gap) {
  std::set<std::pair<int, int>> tags;
  for (std::size_t i = 0; i < s.radii.size(); ++i)
    for (std::size_t j = i + 1; j < s.radii.size(); ++j) {
      if (s.blocks[i] == s.blocks[j] || static_cast<int>(i) >= s.owned) continue;
      const Vec3 a(s.positions[3 * i], s.positions[3 * i + 1], s.positions[3 * i + 2]);
      const Vec3 b(s.positions[3 * j], s.positions[3 * j + 1], s.positions[3 * j + 2]);
      const double limit = s.radii[i] + s.radii[j] + gap;
      if ((a - b).squaredNorm() < limit * limit) tags.insert(std::minmax(s.tags[i], s.tags[j]));
    }
  return tags;
}

TEST(BlockContactList, FindsAllSpherePairsThatTouchAnOwnedSphere) {
  BlockContactList list;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Scene scene = random_scene(120, seed);
    list.group(scene.view(), scene.block_count);
    (void)list.find_block_pairs(0.03);
    list.find_sphere_pairs(scene.view(), 0.03);
    std::set<std::pair<int, int>> found;
    for (const SpherePair& p : list.sphere_pairs()) {
      const int first = scene.tags[static_cast<std::size_t>(p.first)];
      const int second = scene.tags[static_cast<std::size_t>(p.second)];
      EXPECT_LT(first, second);
      EXPECT_TRUE(found.insert({first, second}).second);
    }
    const auto expected = brute_force(scene, 0.03);
    ASSERT_GT(expected.size(), 100u);
    EXPECT_EQ(found, expected);
  }
}

TEST(BlockContactList, BlockPairsCoverTheSpherePairsOneAfterTheOther) {
  const Scene scene = random_scene(80, 9);
  BlockContactList list;
  list.group(scene.view(), scene.block_count);
  (void)list.find_block_pairs(0.03);
  list.find_sphere_pairs(scene.view(), 0.03);
  int next = 0;
  for (const BlockPair& pair : list.block_pairs()) {
    EXPECT_EQ(pair.begin, next);
    EXPECT_GT(pair.end, pair.begin);
    next = pair.end;
    for (int k = pair.begin; k < pair.end; ++k) {
      const SpherePair& p = list.sphere_pairs()[static_cast<std::size_t>(k)];
      const std::set<int> blocks{scene.blocks[static_cast<std::size_t>(p.first)],
                                 scene.blocks[static_cast<std::size_t>(p.second)]};
      EXPECT_EQ(blocks, (std::set<int>{pair.first, pair.second}));
    }
  }
  EXPECT_EQ(next, static_cast<int>(list.sphere_pairs().size()));
}

TEST(BlockContactList, DroppedBlockPairsAndLeftOutSpheresGiveNoCandidates) {
  Scene scene = random_scene(60, 3);
  BlockContactList list;
  list.group(scene.view(), scene.block_count);
  list.find_block_pairs(0.03).clear();
  list.find_sphere_pairs(scene.view(), 0.03);
  EXPECT_TRUE(list.sphere_pairs().empty());

  scene.blocks.assign(scene.blocks.size(), -1);
  list.group(scene.view(), scene.block_count);
  EXPECT_TRUE(list.find_block_pairs(0.03).empty());
}

TEST(BlockContactList, ABlockWithAPositionThatIsNotANumberIsCounted) {
  Scene scene = random_scene(10, 5);
  scene.positions[4] = std::numeric_limits<double>::quiet_NaN();
  BlockContactList list;
  list.group(scene.view(), scene.block_count);
  (void)list.find_block_pairs(10.0);
  EXPECT_EQ(list.skipped_blocks(), 1);
}

}  // namespace
}  // namespace muckpile
