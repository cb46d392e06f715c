// SPDX-License-Identifier: GPL-2.0-or-later
// Roots of some numbers at once against the processor's own; masks.
// Scope: math/lanes.h.
#include <gtest/gtest.h>

#include <cmath>

#include "math/lanes.h"

namespace muckpile {
namespace {

using Native = std::experimental::native_simd<double>;

TEST(InverseRoot, IsExactToAFewUnitsOfTheLastPlaceInAllLanes) {
  for (double x = 1e-150; x < 1e150; x *= 7.3) {
    const Native lanes([&](auto lane) { return x * (1.0 + 0.37 * static_cast<double>(lane)); });
    const Native found = inverse_root(lanes);
    for (std::size_t k = 0; k < kNativeLanes; ++k)
      EXPECT_NEAR(found[k] * std::sqrt(lanes[k]), 1.0, 1e-15) << lanes[k];
  }
  EXPECT_EQ(root(Native(0.0))[0], 0.0);
}

TEST(Masks, HaveABitPerLane) {
  const unsigned all = (1u << kNativeLanes) - 1;
  for (unsigned lanes = 0; lanes <= all; ++lanes) {
    const auto mask = mask_of<Native>(lanes);
    for (std::size_t k = 0; k < kNativeLanes; ++k) EXPECT_EQ(mask[k], (lanes >> k & 1u) != 0);
    EXPECT_EQ(bits_of<Native>(mask), lanes);
  }
}

}  // namespace
}  // namespace muckpile
