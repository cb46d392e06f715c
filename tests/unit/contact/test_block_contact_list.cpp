// SPDX-License-Identifier: GPL-2.0-or-later
// The candidate list of sphere pairs is complete, stays so while blocks move, is ordered, and free
// of pairs that no rank here owns.
// Scope: random blocks of spheres, compared with a search over all pairs of spheres.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
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

using TagPairs = std::set<std::pair<int, int>>;

TagPairs brute_force(const Scene& s, double gap) {
  TagPairs tags;
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

/// All block pairs less than `gap` apart, each looked up once.
BlockContactList listed(const Scene& scene, double gap) {
  BlockContactList list;
  list.group(scene.view(), scene.block_count);
  std::vector<int> dropped;
  for (BlockPair& pair : list.find_block_pairs(0.5 * gap))
    list.look_up(pair, scene.view(), dropped);
  return list;
}

TagPairs tags_of(BlockContactList& list, const Scene& scene) {
  TagPairs tags;
  for (const BlockPair& pair : list.block_pairs())
    for (int k = 0; k < pair.count; ++k) {
      const SpherePair& p = list.sphere_pairs(pair)[k];
      const int first = scene.tags[static_cast<std::size_t>(p.first)];
      const int second = scene.tags[static_cast<std::size_t>(p.second)];
      EXPECT_LT(first, second);
      EXPECT_TRUE(tags.insert({first, second}).second) << first << " and " << second << " twice";
    }
  return tags;
}

TEST(BlockContactList, ListsAllTouchingSpherePairsOfWhichOneIsOwned) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Scene scene = random_scene(120, seed);
    BlockContactList list = listed(scene, 0.03);
    const TagPairs found = tags_of(list, scene);
    const TagPairs touching = brute_force(scene, 0.0);
    ASSERT_GT(touching.size(), 100u);
    EXPECT_TRUE(std::includes(found.begin(), found.end(), touching.begin(), touching.end()));
    const TagPairs near = brute_force(scene, 0.2);  // more than any margin here
    EXPECT_TRUE(std::includes(near.begin(), near.end(), found.begin(), found.end()));
  }
}

// Blocks fly apart and together, turning, for as long as the block pairs hold.
struct Motion {
  std::vector<Vec3> velocity, spin;
  std::vector<double> spins;  ///< per sphere, as the list reads them

  Motion(const Scene& scene, double speed, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int b = 0; b < scene.block_count; ++b) {
      velocity.push_back(speed * Vec3(unit(random), unit(random), unit(random)));
      spin.push_back(20.0 * speed * Vec3(unit(random), unit(random), unit(random)));
    }
    for (int block : scene.blocks)
      for (int d = 0; d < 3; ++d) spins.push_back(spin[static_cast<std::size_t>(block)][d]);
  }

  void step(Scene& scene, std::vector<Vec3>& centres, double dt) const {
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      const auto b = static_cast<std::size_t>(scene.blocks[k]);
      Eigen::Map<Vec3> x(scene.positions.data() + 3 * k);
      const Eigen::AngleAxisd turn(spin[b].norm() * dt, spin[b].normalized());
      x = centres[b] + velocity[b] * dt + turn * (x - centres[b]);
    }
    for (std::size_t b = 0; b < centres.size(); ++b) centres[b] += velocity[b] * dt;
  }
};

std::vector<Vec3> mean_positions(const Scene& scene) {
  std::vector<Vec3> centres(static_cast<std::size_t>(scene.block_count), Vec3::Zero());
  for (std::size_t k = 0; k < scene.blocks.size(); ++k)
    centres[static_cast<std::size_t>(scene.blocks[k])] +=
        Eigen::Map<const Vec3>(scene.positions.data() + 3 * k) / 9.0;
  return centres;
}

TEST(BlockContactList, MissesNoTouchWhileBlocksMoveAndTurnAndSparesMostLooks) {
  Scene scene = random_scene(150, 6);
  constexpr double kGap = 0.2, kSpeed = 0.5, kStep = 1e-3;  // 100 steps: each moves by < kGap / 2
  const Motion motion(scene, kSpeed, 7);
  std::vector<Vec3> centres = mean_positions(scene);
  BlockContactList list = listed(scene, kGap);
  std::vector<int> dropped;
  std::size_t looks = 0, chances = 0, touches = 0;
  for (int step = 0; step < 100; ++step) {
    motion.step(scene, centres, kStep);
    list.follow(scene.positions.data(), motion.spins.data(), kStep);
    for (BlockPair& pair : list.block_pairs()) {
      ++chances;
      if (!list.moved(pair)) continue;
      ++looks;
      list.look_up(pair, scene.view(), dropped);
    }
    const TagPairs touching = brute_force(scene, 0.0), found = tags_of(list, scene);
    touches += touching.size();
    ASSERT_TRUE(std::includes(found.begin(), found.end(), touching.begin(), touching.end()))
        << "step " << step;
  }
  std::printf("looked up %zu of %zu times, %zu touches\n", looks, chances, touches);
  EXPECT_LT(5 * looks, chances);
  EXPECT_GT(touches, 10000u);
}

bool touch(const Scene& scene, const SpherePair& pair) {
  const auto centre = [&](int k) { return Eigen::Map<const Vec3>(scene.positions.data() + 3 * k); };
  return (centre(pair.second) - centre(pair.first)).norm() < pair.reach;
}

TEST(BlockContactList, MissesNoTouchWhilePairsThatCannotTouchYetAreHeldBack) {
  Scene scene = random_scene(150, 6);
  constexpr double kGap = 0.2, kStep = 1e-3;
  Motion motion(scene, 0.1, 7);
  for (std::size_t b = 0; b < 5; ++b) motion.velocity[b] *= 5.0;  // 100 steps: within kGap / 2
  std::vector<Vec3> centres = mean_positions(scene);
  BlockContactList list = listed(scene, kGap);
  list.deactivate(3);
  list.activate(3);
  std::vector<int> dropped;
  std::size_t woken = 0, chances = 0, touches = 0;
  for (int step = 0; step < 100; ++step) {
    motion.step(scene, centres, kStep);
    list.follow(scene.positions.data(), motion.spins.data(), kStep);
    TagPairs found;
    for (std::size_t k = 0; k < list.block_pairs().size(); ++k) {
      ++chances;
      if (!list.wake(k, scene.view(), dropped)) continue;
      ++woken;
      bool any = false;
      for (const SpherePair& pair : list.candidates(k)) {
        if (!touch(scene, pair)) continue;
        any = true;
        found.insert({scene.tags[static_cast<std::size_t>(pair.first)],
                      scene.tags[static_cast<std::size_t>(pair.second)]});
      }
      if (!any) list.rest(k, scene.positions.data());
    }
    ASSERT_EQ(found, brute_force(scene, 0.0)) << "step " << step;
    touches += found.size();
  }
  std::printf("woke %zu of %zu times, %zu touches\n", woken, chances, touches);
  EXPECT_LT(2 * woken, chances);
  EXPECT_GT(touches, 10000u);
}

// Two balls of 1 m, 0.04 m apart, fly a hundred times as far as that side by side; then one comes
// near the other.
TEST(BlockContactList, BlocksThatFlyTogetherAreHeldBackUntilTheyMeet) {
  Scene scene;
  scene.positions = {0.0, 0.0, 0.0, 1.04, 0.0, 0.0};
  scene.radii = {0.5, 0.5};
  scene.tags = {1, 2};
  scene.blocks = {0, 1};
  scene.owned = scene.block_count = 2;
  const std::vector<double> spins(6, 0.0);
  BlockContactList list = listed(scene, 10.0);
  std::vector<int> dropped;
  const auto wakes = [&] {
    list.follow(scene.positions.data(), spins.data(), 1.0);
    return list.wake(0, scene.view(), dropped);
  };
  ASSERT_TRUE(wakes());
  list.rest(0, scene.positions.data());
  for (int step = 0; step < 40; ++step) {
    for (const std::size_t y : {1u, 4u}) scene.positions[y] += 0.1;
    scene.positions[3] -= 0.0009;
    EXPECT_FALSE(wakes()) << "step " << step;
  }
  scene.positions[3] -= 0.005;  // 1 mm into the other
  EXPECT_TRUE(wakes());
}

TEST(BlockContactList, AMutedBlockPairIsHeldBackUntilItIsHeard) {
  const Scene scene = random_scene(60, 3);
  BlockContactList list = listed(scene, 0.03);
  std::size_t k = 0;
  while (list.block_pairs()[k].count == 0) ++k;
  std::vector<int> dropped;
  EXPECT_FALSE(list.inactive(k));
  EXPECT_TRUE(list.wake(k, scene.view(), dropped));
  list.deactivate(k);
  EXPECT_TRUE(list.inactive(k));
  EXPECT_FALSE(list.wake(k, scene.view(), dropped));
  list.activate(k);
  EXPECT_FALSE(list.inactive(k));
  EXPECT_TRUE(list.wake(k, scene.view(), dropped));
  EXPECT_EQ(list.candidates(k).size(), static_cast<std::size_t>(list.block_pairs()[k].count));
}

/// Velocity and spin of each sphere's block, as the list reads them.
std::pair<std::vector<double>, std::vector<double>> rates_of(const Motion& motion,
                                                             const Scene& scene) {
  std::pair<std::vector<double>, std::vector<double>> rates;
  for (const int block : scene.blocks) {
    const auto b = static_cast<std::size_t>(block);
    for (int d = 0; d < 3; ++d) {
      rates.first.push_back(motion.velocity[b][d]);
      rates.second.push_back(motion.spin[b][d]);
    }
  }
  return rates;
}

// Slow blocks are hit one after the other and fly through the others: only their own pairs are
// looked for again, some of them over and over.
TEST(BlockContactList, MissesNoTouchWhilePairsOfFewBlocksAreAddedAndListsNoPairTwice) {
  Scene scene = random_scene(200, 11);
  constexpr double kRange = 0.1, kStep = 1e-3;
  Motion motion(scene, 0.005, 12);
  auto rates = rates_of(motion, scene);
  std::vector<Vec3> centres = mean_positions(scene);
  BlockContactList list;
  list.group(scene.view(), scene.block_count);
  const std::size_t at_first =
      list.find_block_pairs(kRange, rates.first.data(), rates.second.data()).size();
  std::vector<int> dropped;
  std::size_t added = 0, touches = 0;
  for (int step = 0; step < 150; ++step) {
    if (step % 5 == 0) {
      const double way = step % 2 == 0 ? 1.0 : -1.0;
      motion.velocity[static_cast<std::size_t>(step / 5)] = way * Vec3(6.0, -3.0, 4.5);
      rates = rates_of(motion, scene);
    }
    for (BlockPair& pair : list.block_pairs())
      if (list.moved(pair)) list.look_up(pair, scene.view(), dropped);
    const TagPairs touching = brute_force(scene, 0.0), found = tags_of(list, scene);
    touches += touching.size();
    ASSERT_TRUE(std::includes(found.begin(), found.end(), touching.begin(), touching.end()))
        << "step " << step;
    motion.step(scene, centres, kStep);
    list.follow(scene.positions.data(), rates.second.data(), kStep);
    if (!list.outgrown()) continue;
    ++added;
    ASSERT_TRUE(list.add_block_pairs(scene.view(), rates.first.data(), rates.second.data()));
    EXPECT_FALSE(list.outgrown());
  }
  std::printf("%zu pairs, %zu in the end, added %zu times; %zu touches\n", at_first,
              list.block_pairs().size(), added, touches);
  EXPECT_GT(added, 15u);
  EXPECT_GT(list.block_pairs().size(), at_first + 100);
  std::set<std::pair<int, int>> pairs;
  for (const BlockPair& pair : list.block_pairs())
    EXPECT_TRUE(pairs.insert({pair.first, pair.second}).second);
}

TEST(BlockContactList, WhereManyBlocksAreOutgrownAllAreToBeLookedForAnew) {
  Scene scene = random_scene(100, 13);
  Motion motion(scene, 0.5, 14);
  const auto rates = rates_of(motion, scene);
  std::vector<Vec3> centres = mean_positions(scene);
  BlockContactList list;
  list.group(scene.view(), scene.block_count);
  const std::size_t pairs = list.find_block_pairs(0.01).size();
  motion.step(scene, centres, 0.5);
  list.follow(scene.positions.data(), rates.second.data(), 0.5);
  ASSERT_TRUE(list.outgrown());
  EXPECT_FALSE(list.add_block_pairs(scene.view(), rates.first.data(), rates.second.data()));
  EXPECT_EQ(list.block_pairs().size(), pairs);
}

// What find_block_pairs() leaves out cannot touch before outgrown() says so.
TEST(BlockContactList, SlowBlocksHaveFewerPairsAndNoTouchIsMissedBeforeOneIsOutgrown) {
  Scene scene = random_scene(150, 8);
  constexpr double kRange = 0.1, kStep = 1e-4;
  Motion motion(scene, 0.5, 9);
  for (std::size_t b = 0; b < motion.velocity.size(); ++b) {
    if (b % 5 == 0) continue;  // the others hardly move at first
    motion.velocity[b] *= 0.02;
    motion.spin[b] *= 0.02;
  }
  const auto [velocities, spins] = rates_of(motion, scene);
  std::vector<Vec3> centres = mean_positions(scene);
  BlockContactList list;
  list.group(scene.view(), scene.block_count);
  const std::size_t all = list.find_block_pairs(kRange).size();
  const std::size_t fewer = list.find_block_pairs(kRange, velocities.data(), spins.data()).size();
  std::vector<int> dropped;
  for (BlockPair& pair : list.block_pairs()) list.look_up(pair, scene.view(), dropped);
  int steps = 0;
  for (; !list.outgrown() && steps < 1000; ++steps) {
    const TagPairs touching = brute_force(scene, 0.0), found = tags_of(list, scene);
    ASSERT_TRUE(std::includes(found.begin(), found.end(), touching.begin(), touching.end()))
        << "step " << steps;
    if (steps == 30) motion.velocity[1] = Vec3(5.0, 0.0, 0.0);  // a slow block is hit
    motion.step(scene, centres, kStep);
    list.follow(scene.positions.data(), spins.data(), kStep);
    for (BlockPair& pair : list.block_pairs())
      if (list.moved(pair)) list.look_up(pair, scene.view(), dropped);
  }
  std::printf("%zu pairs instead of %zu; outgrown after %d steps\n", fewer, all, steps);
  EXPECT_LT(1.2 * static_cast<double>(fewer), static_cast<double>(all));
  EXPECT_GT(steps, 30);
  EXPECT_LT(steps, 70);  // the hit one's range lasts 20 steps or some more, the others' above 100
}

TEST(BlockContactList, ContactsStayWithTheirSpheresAndLostOnesAreReported) {
  Scene scene = random_scene(60, 11);
  BlockContactList list = listed(scene, 0.03);
  BlockPair* pair = nullptr;
  for (BlockPair& p : list.block_pairs())
    if (p.count > 2) pair = &p;
  ASSERT_NE(pair, nullptr);
  const int first = list.sphere_pairs(*pair)[1].first;
  list.sphere_pairs(*pair)[1].contact = 42;
  std::vector<int> dropped;
  list.look_up(*pair, scene.view(), dropped);
  EXPECT_EQ(list.sphere_pairs(*pair)[1].contact, 42);
  EXPECT_TRUE(dropped.empty());

  const int moved_block = scene.blocks[static_cast<std::size_t>(first)];
  for (std::size_t k = 0; k < scene.blocks.size(); ++k)
    if (scene.blocks[k] == moved_block) scene.positions[3 * k] += 50.0;
  list.follow(scene.positions.data(), std::vector<double>(3 * scene.blocks.size()).data(), 1e-3);
  ASSERT_TRUE(list.moved(*pair));
  list.look_up(*pair, scene.view(), dropped);
  EXPECT_EQ(pair->count, 0);
  EXPECT_EQ(dropped, std::vector<int>{42});
}

TEST(BlockContactList, DroppedBlockPairsAndLeftOutSpheresGiveNoCandidates) {
  Scene scene = random_scene(60, 3);
  BlockContactList list = listed(scene, 0.03);
  list.find_block_pairs(0.015).clear();
  EXPECT_TRUE(tags_of(list, scene).empty());

  scene.blocks.assign(scene.blocks.size(), -1);
  list.group(scene.view(), scene.block_count);
  EXPECT_TRUE(list.find_block_pairs(0.015).empty());
}

TEST(BlockContactList, ABlockWithAPositionThatIsNotANumberIsCounted) {
  Scene scene = random_scene(10, 5);
  scene.positions[4] = std::numeric_limits<double>::quiet_NaN();
  BlockContactList list;
  list.group(scene.view(), scene.block_count);
  (void)list.find_block_pairs(5.0);
  EXPECT_EQ(list.skipped_blocks(), 1);
}

}  // namespace
}  // namespace muckpile
