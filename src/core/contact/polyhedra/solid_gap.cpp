// SPDX-License-Identifier: GPL-2.0-or-later
// Gaps between convex solids: along a direction, above the planes of one, and a
// search. Scope: see the header.
#include "contact/polyhedra/solid_gap.h"

#include <algorithm>
#include <limits>

namespace muckpile {
namespace {

constexpr int kMostTurns = 12;

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

void AlongDirection::look(const PlacedSolid& s, const Vec3& n) {
  std::array<double, kRow> least, most;
  least.fill(std::numeric_limits<double>::infinity());
  most.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < s.rows; k += kRow)
    for (std::size_t j = 0; j < kRow; ++j) {
      const double along = n.x() * s.x[k + j] + n.y() * s.y[k + j] + n.z() * s.z[k + j];
      at[k + j] = along;
      least[j] = std::min(least[j], along);
      most[j] = std::max(most[j], along);
    }
  low = *std::min_element(least.begin(), least.end());
  high = *std::max_element(most.begin(), most.end());
}

std::uint64_t AlongDirection::planes_above(const PlacedSolid& s, double height) const {
  std::uint64_t planes = 0;
  const std::uint64_t* const of_corner = s.solid->planes_of_corner().data();
  for (std::size_t k = 0; k < s.rows; ++k) planes |= at[k] >= height ? of_corner[k] : 0;
  return planes;
}

std::uint64_t AlongDirection::planes_below(const PlacedSolid& s, double height) const {
  std::uint64_t planes = 0;
  const std::uint64_t* const of_corner = s.solid->planes_of_corner().data();
  for (std::size_t k = 0; k < s.rows; ++k) planes |= at[k] <= height ? of_corner[k] : 0;
  return planes;
}

void mark_outside(const PlacedSolid& a, const PlacedSolid& b, bool strictly, OutsideBits& bits) {
  const double bound = strictly ? 0.0 : std::numeric_limits<double>::denorm_min();
  for (std::size_t k = 0; k < a.rows; k += kRow) {
    std::array<std::uint64_t, kRow> outside{};
    for (std::size_t p = 0; p < b.planes; ++p) {
      const std::uint64_t bit = std::uint64_t{1} << p;
      for (std::size_t j = 0; j < kRow; ++j) {
        const double above =
            b.nx[p] * a.x[k + j] + b.ny[p] * a.y[k + j] + b.nz[p] * a.z[k + j] - b.offset[p];
        outside[j] |= above >= bound ? bit : 0;
      }
    }
    std::copy_n(outside.begin(), kRow, bits.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

double gap_above_planes(const PlacedSolid& a, const PlacedSolid& b, Vec3& n) {
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < b.planes; ++p) {
    const double nx = b.nx[p], ny = b.ny[p], nz = b.nz[p];
    std::array<double, kRow> low;
    low.fill(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < a.rows; k += kRow)
      for (std::size_t j = 0; j < kRow; ++j)
        low[j] = std::min(low[j], nx * a.x[k + j] + ny * a.y[k + j] + nz * a.z[k + j]);
    const double gap = *std::min_element(low.begin(), low.end()) - b.offset[p];
    if (gap <= greatest) continue;
    greatest = gap;
    n = b.normal(p);
  }
  return greatest;
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

}  // namespace muckpile
