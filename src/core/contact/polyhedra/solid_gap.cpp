// SPDX-License-Identifier: GPL-2.0-or-later
// Gaps between convex solids: along a direction, above the planes of one, and a
// search. Scope: see the header.
#include "contact/polyhedra/solid_gap.h"

#include <algorithm>
#include <limits>

namespace muckpile {
namespace {

constexpr int kMostTurns = 12;
constexpr std::size_t kRow = PlacedSolid::kRow;

/// Of n.x over the corners.
struct Extremes {
  double low, high;
};

Extremes extremes(const PlacedSolid& s, const Vec3& n) {
  std::array<double, kRow> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < s.rows; k += kRow)
    for (std::size_t j = 0; j < kRow; ++j) {
      const double along = n.x() * s.x[k + j] + n.y() * s.y[k + j] + n.z() * s.z[k + j];
      low[j] = std::min(low[j], along);
      high[j] = std::max(high[j], along);
    }
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

/// The corner that is farthest along n.
int farthest(const PlacedSolid& s, const Vec3& n) {
  int best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < s.solid->corners().size(); ++k) {
    const double along = n.x() * s.x[k] + n.y() * s.y[k] + n.z() * s.z[k];
    if (along <= most) continue;
    most = along;
    best = static_cast<int>(k);
  }
  return best;
}

}  // namespace

double gap_along(const PlacedSolid& a, const PlacedSolid& b, const Vec3& n) {
  return extremes(b, n).low - extremes(a, n).high;
}

double gap_along(const Solid& a, const Solid& b, const Vec3& n, const Vec3& n_second,
                 double between) {
  double high = -std::numeric_limits<double>::infinity(), low = -high;
  for (const Vec3& corner : a.corners()) high = std::max(high, n.dot(corner));
  for (const Vec3& corner : b.corners()) low = std::min(low, n_second.dot(corner));
  return between + low - high;
}

double find_gap(const PlacedSolid& a, const PlacedSolid& b, Vec3& n) {
  double gap = 0.0;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const Vec3 between = b.corner(farthest(b, -n)) - a.corner(farthest(a, n));
    gap = between.dot(n);
    if (gap > 0.0) return gap;
    const double squared = between.squaredNorm();
    if (!(squared > 0.0)) return 0.0;
    n = (n - 2.0 * gap / squared * between).normalized();
  }
  return gap;
}

double outside_bits(const PlacedSolid& a, const PlacedSolid& b, bool strictly, OutsideBits& bits,
                    Vec3& n) {
  const double bound = strictly ? 0.0 : std::numeric_limits<double>::denorm_min();
  for (std::size_t k = 0; k < a.rows; ++k) bits[k] = 0;
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < b.planes(); ++p) {
    const double nx = b.nx[p], ny = b.ny[p], nz = b.nz[p];
    const double offset = b.offset[p];
    const std::uint64_t bit = std::uint64_t{1} << p;
    std::array<double, kRow> low;
    low.fill(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < a.rows; k += kRow)
      for (std::size_t j = 0; j < kRow; ++j) {
        const double above = nx * a.x[k + j] + ny * a.y[k + j] + nz * a.z[k + j] - offset;
        bits[k + j] |= above >= bound ? bit : 0;
        low[j] = std::min(low[j], above);
      }
    const double gap = *std::min_element(low.begin(), low.end());
    if (gap <= greatest) continue;
    greatest = gap;
    n = b.normal(p);
  }
  return greatest;
}

}  // namespace muckpile
