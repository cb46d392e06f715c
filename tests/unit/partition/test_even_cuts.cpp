// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts of one axis: equal weight, least width, and no jump past a neighbour.
#include <gtest/gtest.h>

#include "partition/even_cuts.h"

namespace muckpile {
namespace {

TEST(EvenCuts, HalveTheWeightInsideABin) {
  // 4 bins of width 1/4; total 8, half of it is 4: 1 in bin 0 and 3 of the 6 in bin 1.
  const std::vector<double> cuts = even_cuts(std::vector{1.0, 6.0, 1.0, 0.0}, 2);
  ASSERT_EQ(cuts.size(), 3u);
  EXPECT_DOUBLE_EQ(cuts[1], 0.25 + 0.5 * 0.25);
}

TEST(EvenCuts, EveryPartHoldsTheSameWeight) {
  std::vector<double> weights(1000);
  for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = static_cast<double>(k * k % 97);
  const std::vector<double> cuts = even_cuts(weights, 7);
  double total = 0.0;
  for (double w : weights) total += w;
  for (std::size_t part = 0; part < 7; ++part) {
    double inside = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const double lo = std::max(cuts[part], static_cast<double>(k) / 1000.0);
      const double hi = std::min(cuts[part + 1], static_cast<double>(k + 1) / 1000.0);
      inside += weights[k] * std::max(hi - lo, 0.0) * 1000.0;
    }
    EXPECT_NEAR(inside, total / 7.0, 1e-9 * total) << "part " << part;
  }
}

TEST(EvenCuts, NoWeightGivesEvenWidths) {
  const std::vector<double> cuts = even_cuts(std::vector<double>(10, 0.0), 4);
  EXPECT_EQ(cuts, (std::vector{0.0, 0.25, 0.5, 0.75, 1.0}));
}

TEST(EvenCuts, AllWeightInOneBinStillRises) {
  std::vector<double> weights(10, 0.0);
  weights[0] = 5.0;
  const std::vector<double> cuts = widened_cuts(even_cuts(weights, 4), 0.1);
  for (std::size_t k = 1; k < cuts.size(); ++k) EXPECT_GE(cuts[k] - cuts[k - 1], 0.1 - 1e-12);
  EXPECT_EQ(cuts.back(), 1.0);
}

TEST(EvenCuts, AWidthThatDoesNotFitFallsBackToEvenWidths) {
  const std::vector<double> cuts = widened_cuts({0.0, 0.1, 0.2, 1.0}, 0.5);
  EXPECT_NEAR(cuts[1], 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(cuts[2], 2.0 / 3.0, 1e-12);
}

TEST(EvenCuts, NeighbourlyCutsDoNotPassTheOldNeighbour) {
  const std::vector<double> now{0.0, 0.25, 0.5, 0.75, 1.0}, wanted{0.0, 0.02, 0.05, 0.1, 1.0};
  EXPECT_EQ(neighbourly_cuts(now, wanted, 0.0), (std::vector{0.0, 0.02, 0.25, 0.5, 1.0}));
}

TEST(EvenCuts, WhatIsBeyondItsBorderByLessThanTheMarginGoesNoFartherThanToANeighbour) {
  const std::vector<double> now{0.0, 0.25, 0.5, 0.75, 1.0};
  const double margin = 0.0625;
  for (const auto& wanted :
       {std::vector{0.0, 0.01, 0.02, 0.03, 1.0}, std::vector{0.0, 0.97, 0.98, 0.99, 1.0},
        std::vector{0.0, 0.01, 0.98, 0.99, 1.0}}) {
    const std::vector<double> cuts = neighbourly_cuts(now, wanted, margin);
    for (std::size_t part = 0; part < 4; ++part) {
      const std::size_t below = part == 0 ? 0 : part - 1,
                        above = std::min<std::size_t>(part + 2, 4);
      if (below > 0) {
        EXPECT_LE(cuts[below], now[part] - margin);
      }
      if (above < 4) {
        EXPECT_GE(cuts[above], now[part + 1] + margin);
      }
    }
  }
}

TEST(EvenCuts, ACutBetweenThinPartsStays) {
  const std::vector<double> now{0.0, 0.04, 0.08, 1.0}, wanted{0.0, 0.3, 0.6, 1.0};
  EXPECT_EQ(neighbourly_cuts(now, wanted, 0.05)[1], now[1]);
}

}  // namespace
}  // namespace muckpile
