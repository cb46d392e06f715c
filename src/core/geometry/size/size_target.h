// SPDX-License-Identifier: GPL-2.0-or-later
// Block sizes that follow a wanted size curve: the law of distance that gives it, and how near the
// cut comes.
// Scope: sizes are V^(1/3), shares are of mass; a sieve grades by width, some 0.8 to 1 of it.
#pragma once

#include <string>
#include <vector>

#include "geometry/cut/tessellation.h"

namespace muckpile {

/// Mass share finer than a size.
class SizeTarget {
 public:
  /// 1 - 2^-(x/x50)^n, Rosin and Rammler with Kuznetsov's x50 and Cunningham's n (Kuz-Ram).
  [[nodiscard]] static SizeTarget kuz_ram(double x50, double n);
  /// 1 / (1 + [ln(xmax/x)/ln(xmax/x50)]^b), Swebrec (Ouchterlony 2005).
  [[nodiscard]] static SizeTarget swebrec(double x50, double xmax, double b);

  [[nodiscard]] double passing(double size) const;   ///< 0 at size 0
  [[nodiscard]] double size_at(double share) const;  ///< the inverse, 0 < share < 1 [m]

 private:
  SizeTarget(double x50, double xmax, double exponent);
  double x50_, xmax_, exponent_;  // xmax 0: Rosin-Rammler
};

/// Achieved against target.
struct SizeComparison {
  struct Point {
    double share, target, achieved;  ///< sizes [m]
  };
  std::vector<Point> points;  ///< P10, P20 ... P90
  /// Greatest difference in mass share at any size from block_min to block_max
  /// (Kolmogorov-Smirnov).
  double greatest_difference = 0.0;
  [[nodiscard]] const Point& at(int percent) const {
    return points[static_cast<std::size_t>(percent / 10 - 1)];
  }
  /// P20, P50 and P80 within 5 %, the curve within 3 % of the mass.
  [[nodiscard]] bool good() const;
};

[[nodiscard]] SizeComparison compare_sizes(const std::vector<Block>& blocks,
                                           const SizeTarget& target, const SizeLimits& limits);

/// Why a comparison is not good(), in words, with numbers; `volume` is that of all blocks [m3].
[[nodiscard]] std::string why_missed(const SizeComparison& comparison, const SizeTarget& target,
                                     const SizeLimits& limits, double volume);

struct FittedCut {
  Tessellation cut;
  SizeComparison comparison;
  std::string why_missed;  ///< empty if the comparison is good()
  SizeTable law;           ///< distance [m], size [m]
  int rounds = 0;
};

/// Cuts with the law s(r) that gives the rock at distance r from the nearest charge the target's
/// size of the mass share that lies nearer: the finest at the holes. Voronoi cells scatter about
/// what the law asks for, so the law is corrected by target over achieved size, as a mean over a
/// block's width, and the rock cut again, until the comparison is well within good() or
/// `most_rounds` are done; the best is kept. options.size is not used. InputError as tessellate(),
/// or without a hole or fine axis.
[[nodiscard]] FittedCut tessellate_to_target(TessellationOptions options, const SizeTarget& target,
                                             const SizeLimits& limits, int most_rounds = 8);

}  // namespace muckpile
