// SPDX-License-Identifier: GPL-2.0-or-later
// The random numbers of cuts and of Lanczos' start, against published ones.
#include <gtest/gtest.h>

#include "math/random.h"

namespace muckpile {
namespace {

// First outputs of splitmix64 from state 0, as published with it.
constexpr std::uint64_t kFirst = 0xe220a8397b1dcdafu, kSecond = 0x6e789e6aa1b965f4u;

double unit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

TEST(Random, NumbersAreTheSameEverywhere) {
  Random random(0);
  EXPECT_EQ(random.uniform(), unit(kFirst));
  EXPECT_EQ(random.uniform(), unit(kSecond));
}

TEST(Random, ANumberIsHadByItsIndexToo) {
  EXPECT_EQ(random_bits(0, 0), kFirst);
  EXPECT_EQ(random_bits(0, 1), kSecond);
  Random random(7);
  for (std::uint64_t index = 0; index < 5; ++index)
    EXPECT_EQ(random.uniform(), unit(random_bits(7, index)));
}

}  // namespace
}  // namespace muckpile
