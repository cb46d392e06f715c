// SPDX-License-Identifier: GPL-2.0-or-later
// Eight bytes at once against one by one.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "math/byte_lanes.h"
#include "math/lanes.h"

namespace muckpile {
namespace {

using Bytes = std::array<std::uint8_t, kByteLanes>;

Bytes random_bytes(std::mt19937& random) {
  Bytes bytes;
  std::uniform_int_distribution<int> few(0, 3), any(0, 255);
  for (std::uint8_t& byte : bytes)
    byte = static_cast<std::uint8_t>(few(random) == 0 ? any(random) : few(random));
  return bytes;
}

TEST(ByteLanes, AreWhatEachByteSays) {
  std::mt19937 random(1);
  for (int n = 0; n < 2000; ++n) {
    const Bytes bytes = random_bytes(random);
    const std::uint64_t all = load_bytes<kByteLanes>(bytes.data(), kByteLanes, 0);
    for (std::size_t bit = 0; bit < 8; ++bit) {
      unsigned set = 0;
      for (std::size_t k = 0; k < kByteLanes; ++k) set |= (bytes[k] >> bit & 1u) << k;
      ASSERT_EQ(lanes_with_bit(all, bit), set);
    }
    for (const int each : {0, 1, 2, 3, 127, 128, 255}) {
      const auto value = static_cast<std::uint8_t>(each);
      unsigned equal = 0;
      for (std::size_t k = 0; k < kByteLanes; ++k) equal |= (bytes[k] == value ? 1u : 0u) << k;
      ASSERT_EQ(lanes_equal(all, value), equal) << each;
    }
  }
}

TEST(ByteLanes, OfFewerTheOthersAreTheRest) {
  const Bytes bytes = {1, 2, 3, 4, 5, 6, 7, 8};
  const std::uint64_t three = load_bytes<kByteLanes>(bytes.data(), 3, 9);
  EXPECT_EQ(lanes_equal(three, 9), 0b11111000u);
  EXPECT_EQ(lanes_equal(three, 2), 0b00000010u);
}

TEST(StoreLanes, PutsThoseOfSomeOneBehindTheOther) {
  using Native = std::experimental::native_simd<double>;
  const Native numbers([](auto lane) { return 1.0 + static_cast<double>(lane); });
  for (unsigned lanes = 0; lanes < 1u << Native::size(); ++lanes) {
    std::array<double, Native::size() + 1> to{};
    store_lanes(numbers, lanes, to.data());
    std::size_t at = 0;
    for (std::size_t k = 0; k < Native::size(); ++k) {
      if ((lanes >> k & 1u) == 0) continue;
      ASSERT_EQ(to[at++], 1.0 + static_cast<double>(k)) << lanes;
    }
    for (; at < to.size(); ++at) ASSERT_EQ(to[at], 0.0) << lanes;
  }
}

}  // namespace
}  // namespace muckpile
