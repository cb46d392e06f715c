// SPDX-License-Identifier: GPL-2.0-or-later
// A mistyped word finds the known one it most likely meant, and nothing far-fetched.
// Scope: args/suggestion.h.
#include <gtest/gtest.h>

#include "args/suggestion.h"

namespace muckpile {
namespace {

TEST(EditDistance, CountsInsertDeleteReplaceAndSwap) {
  EXPECT_EQ(edit_distance("burden", "burden"), 0u);
  EXPECT_EQ(edit_distance("burde", "burden"), 1u);
  EXPECT_EQ(edit_distance("burdeen", "burden"), 1u);
  EXPECT_EQ(edit_distance("bxrden", "burden"), 1u);
  EXPECT_EQ(edit_distance("brudne", "burden"), 2u);
  EXPECT_EQ(edit_distance("", "vod"), 3u);
}

TEST(ClosestWord, FindsTheNearestWithinAThirdOfTheLength) {
  const std::vector<std::string> known = {"decay_time", "peak_pressure", "seed"};
  EXPECT_EQ(closest_word("decy_time", known), "decay_time");
  EXPECT_EQ(closest_word("sede", known), "seed");
  EXPECT_EQ(closest_word("temperature", known), "");
}

TEST(ClosestWord, CompletesAWordThatOnlyOneStartsWith) {
  EXPECT_EQ(closest_word("peak", {"decay_time", "peak_pressure"}), "peak_pressure");
  EXPECT_EQ(closest_word("bench", {"bench_height", "bench_width_left"}), "");
}

TEST(ClosestWord, TakesCapitalLettersForSmallOnes) {
  EXPECT_EQ(closest_word("ANFO", {"anfo", "anfo_dense", "tnt"}), "anfo");
  EXPECT_EQ(closest_word("TNTS", {"tnt"}), "tnt");
  EXPECT_EQ(closest_word("Heavy", {"anfo", "heavy_anfo"}), "heavy_anfo");
}

TEST(DidYouMean, IsEmptyWhenNothingIsNear) {
  EXPECT_EQ(did_you_mean("sed", {"seed"}), "; did you mean 'seed'?");
  EXPECT_EQ(did_you_mean("colour", {"seed"}), "");
}

}  // namespace
}  // namespace muckpile
