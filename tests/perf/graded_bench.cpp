// SPDX-License-Identifier: GPL-2.0-or-later
// The graded bench.
// Scope: see the header.
#include "graded_bench.h"

#include <cmath>

#include "../unit/geometry/shapes.h"

namespace muckpile::perf {
namespace {

constexpr double kHeight = 10.0, kFloor = -2.0, kBack = -8.0, kFront = 3.0;  // [m]
constexpr double kBurden = 3.0, kSpacing = 4.0, kCrushedRadius = 0.15;       // [m]

/// Grows linearly from the wall of the crushed zone to its `ratio`-fold at the burden's distance.
SizeLaw law(double smallest, double ratio) {
  return SizeLaw::table({{kCrushedRadius, smallest}, {kBurden, ratio * smallest}},
                        {smallest, ratio * smallest});
}

}  // namespace

TessellationOptions graded_bench(const BenchRock& what) {
  TessellationOptions options;
  const double width = kSpacing * what.holes;
  options.lo = Vec3(kBack, 0.0, kFloor);
  options.hi = Vec3(kFront, width, kHeight);
  for (int h = 0; h < what.holes; ++h) {
    const double y = kSpacing * (h + 0.5);
    options.holes.push_back({{-kBurden, y, -0.5}, {-kBurden, y, 7.0}, kCrushedRadius});
  }
  options.region = test::bench_profile();
  options.max_blocks = 4 * what.blocks;
  const auto wanted = static_cast<double>(what.blocks);
  double smallest = 0.1;         // [m]
  for (int k = 0; k < 8; ++k) {  // the count goes with size^-3, but for the edges
    options.size = law(smallest, what.size_ratio);
    smallest *= std::cbrt(expected_block_count(options, 1e9) / wanted);
  }
  options.size = law(smallest, what.size_ratio);
  return options;
}

}  // namespace muckpile::perf
