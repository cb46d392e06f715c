// SPDX-License-Identifier: GPL-2.0-or-later
// The size-aware broad phase finds exactly the pairs that a brute-force search finds.
// Scope: random graded sets and degenerate ones.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "contact/hierarchical_grid.h"

namespace muckpile {
namespace {

using PairSet = std::set<std::pair<int, int>>;

PairSet brute_force(const std::vector<BoundingSphere>& items, double gap) {
  PairSet pairs;
  for (std::size_t a = 0; a < items.size(); ++a)
    for (std::size_t b = a + 1; b < items.size(); ++b) {
      const double limit = items[a].radius + items[b].radius + gap;
      if ((items[a].centre - items[b].centre).squaredNorm() < limit * limit)
        pairs.insert({static_cast<int>(a), static_cast<int>(b)});
    }
  return pairs;
}

PairSet found_by(HierarchicalGrid& grid, const std::vector<BoundingSphere>& items, double gap) {
  PairSet pairs;
  for (const IndexPair& p : grid.find_pairs(items, gap)) {
    EXPECT_LT(p.first, p.second);
    EXPECT_TRUE(pairs.insert({p.first, p.second}).second)
        << "twice: " << p.first << " " << p.second;
  }
  return pairs;
}

std::vector<BoundingSphere> graded_set(int count, double size_ratio, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<BoundingSphere> items;
  for (int k = 0; k < count; ++k) {
    const Vec3 centre(4 * unit(random) - 2, 4 * unit(random) - 2, 4 * unit(random) - 2);
    items.push_back({centre, 0.05 * std::pow(size_ratio, unit(random))});
  }
  return items;
}

class GradedSets : public testing::TestWithParam<double> {};

TEST_P(GradedSets, GiveTheSamePairsAsBruteForce) {
  HierarchicalGrid grid;  // one grid for all sets: old contents must not leak
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const std::vector<BoundingSphere> items = graded_set(1500, GetParam(), seed);
    const double gap = 0.02 * seed;
    const PairSet expected = brute_force(items, gap);
    ASSERT_GT(expected.size(), 100u);
    EXPECT_EQ(found_by(grid, items, gap), expected);
  }
}

INSTANTIATE_TEST_SUITE_P(SizeRatios, GradedSets, testing::Values(1.0, 10.0, 30.0));

TEST(HierarchicalGrid, CoincidentItemsAreAllPairs) {
  HierarchicalGrid grid;
  const std::vector<BoundingSphere> items(40, BoundingSphere{Vec3(1, 2, 3), 0.5});
  EXPECT_EQ(found_by(grid, items, 0.0).size(), 40u * 39u / 2u);
}

TEST(HierarchicalGrid, OneItemOrNoneHasNoPair) {
  HierarchicalGrid grid;
  EXPECT_TRUE(grid.find_pairs({}, 0.1).empty());
  const std::vector<BoundingSphere> one{{Vec3::Zero(), 1.0}};
  EXPECT_TRUE(grid.find_pairs(one, 0.1).empty());
}

TEST(HierarchicalGrid, CollinearRowHasNeighbourPairsOnly) {
  HierarchicalGrid grid;
  std::vector<BoundingSphere> items;
  for (int k = 0; k < 100; ++k) items.push_back({Vec3(1.01 * k, 0, 0), 0.5});  // gaps of 0.01
  EXPECT_TRUE(grid.find_pairs(items, 0.005).empty());
  EXPECT_EQ(found_by(grid, items, 0.02).size(), 99u);
}

TEST(HierarchicalGrid, PointsWithoutRadiusOrGapHaveNoPair) {
  HierarchicalGrid grid;
  const std::vector<BoundingSphere> items{{Vec3::Zero(), 0.0}, {Vec3(1, 0, 0), 0.0}};
  EXPECT_TRUE(grid.find_pairs(items, 0.0).empty());
}

TEST(HierarchicalGrid, NumbersThatAreNotFiniteAreLeftOutAndCounted) {
  HierarchicalGrid grid;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<BoundingSphere> items{{Vec3(0, 0, 0), 1.0},
                                          {Vec3(nan, 0, 0), 1.0},
                                          {Vec3(1, 0, 0), 1.0},
                                          {Vec3(0, inf, 0), 1.0},
                                          {Vec3(0.5, 0, 0), nan},
                                          {Vec3(0.5, 0, 0), -1.0},
                                          {Vec3(0, 0, 0), std::numeric_limits<double>::max()}};
  EXPECT_EQ(found_by(grid, items, 0.1), (PairSet{{0, 2}}));
  EXPECT_EQ(grid.skipped(), 5);
}

TEST(HierarchicalGrid, FarAwayAndTinyItemsDoNotHang) {
  HierarchicalGrid grid;
  const std::vector<BoundingSphere> items{{Vec3(1e300, 0, 0), 1e-12},
                                          {Vec3(-1e300, 0, 0), 1e-12},
                                          {Vec3(0, 0, 0), 1e6},
                                          {Vec3(0, 0, 1e6), 1e-12}};
  EXPECT_EQ(found_by(grid, items, 1e-3), (PairSet{{2, 3}}));
}

TEST(HierarchicalGrid, OrderOfPairsIsRepeatable) {
  const std::vector<BoundingSphere> items = graded_set(800, 30.0, 7);
  HierarchicalGrid one, other;
  (void)other.find_pairs(graded_set(500, 10.0, 8), 0.3);  // another history
  const std::vector<IndexPair>& a = one.find_pairs(items, 0.05);
  const std::vector<IndexPair>& b = other.find_pairs(items, 0.05);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].first, b[k].first);
    EXPECT_EQ(a[k].second, b[k].second);
  }
}

}  // namespace
}  // namespace muckpile
