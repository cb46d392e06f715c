// SPDX-License-Identifier: GPL-2.0-or-later
// Four vectors as they lie in memory, for loops that work on all four at once (lanes.h).
// Scope: storage only.
#pragma once

#include <array>
#include <cstddef>

#include "math/types.h"

namespace muckpile {

inline constexpr int kLanes = 4;

/// All x, then all y, then all z.
struct alignas(32) FourVectors {
  std::array<double, kLanes> x{}, y{}, z{};

  void set(int lane, const Vec3& v) {
    const auto k = static_cast<std::size_t>(lane);
    x[k] = v.x(), y[k] = v.y(), z[k] = v.z();
  }
  [[nodiscard]] Vec3 at(int lane) const {
    const auto k = static_cast<std::size_t>(lane);
    return {x[k], y[k], z[k]};
  }
};

}  // namespace muckpile
