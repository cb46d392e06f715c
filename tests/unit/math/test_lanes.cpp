// SPDX-License-Identifier: GPL-2.0-or-later
// Roots of eight numbers at once against the processor's own.
// Scope: math/lanes.h.
#include <gtest/gtest.h>

#include <cmath>

#include "math/lanes.h"

namespace muckpile {
namespace {

TEST(InverseRoot, IsExactToAFewUnitsOfTheLastPlaceInAllLanes) {
  using Eight = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, 8>>;
  for (double x = 1e-150; x < 1e150; x *= 7.3) {
    const Eight lanes([&](auto lane) { return x * (1.0 + 0.37 * static_cast<double>(lane)); });
    const Eight found = inverse_root(lanes);
    for (std::size_t k = 0; k < 8; ++k)
      EXPECT_NEAR(found[k] * std::sqrt(lanes[k]), 1.0, 1e-15) << lanes[k];
  }
  EXPECT_EQ(root(Eight(0.0))[0], 0.0);
}

}  // namespace
}  // namespace muckpile
