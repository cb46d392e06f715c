// SPDX-License-Identifier: GPL-2.0-or-later
// Which seeds of rings have a block in a part of the rock between planes.
// Scope: HoleRings::within() of hole_rings.h. From the rings and the planes alone.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/cut/hole_rings.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile {
namespace {

// [block sizes]: a cell does not go on so far beyond its seed; seeds so far apart share no face.
constexpr double kReach = 2.0, kBeside = 2.6;

/// The part's pieces of the cells of rings.
class RingPieces {
 public:
  RingPieces(const std::vector<RingSeed>& seeds, const std::vector<CutPlane>& bounds,
             const Vec3& lo, const Vec3& hi)
      : seeds_(seeds), bounds_(bounds), lo_(lo), hi_(hi) {
    for (std::size_t k = 0; k < seeds.size(); ++k) is_here_.push_back(depth(k) > -kReach);
    for (std::size_t k = 0; k < seeds.size(); ++k) worth_.push_back(worth(k));
  }

  /// Takes away the seeds that make no block, the least first: the cells beside them grow.
  void drop_slivers(bool one_at_least);
  [[nodiscard]] const std::vector<bool>& is_here() const { return is_here_; }

 private:
  [[nodiscard]] double depth(std::size_t seed) const;
  [[nodiscard]] std::optional<ConvexCell> piece(std::size_t seed) const;
  [[nodiscard]] double worth(std::size_t seed) const;
  void drop(std::size_t seed);

  const std::vector<RingSeed>& seeds_;
  const std::vector<CutPlane>& bounds_;
  const Vec3 lo_, hi_;
  std::vector<bool> is_here_;
  std::vector<double> worth_;  // of a block; below 1 the piece makes none
};

/// Below all planes [block sizes].
double RingPieces::depth(std::size_t seed) const {
  double least = std::numeric_limits<double>::infinity();
  for (const CutPlane& bound : bounds_)
    least = std::min(least, bound.normal.dot(bound.point - seeds_[seed].at));
  return least / seeds_[seed].size;
}

/// Without the void, and as if the seeds of other rings alone were beside it.
std::optional<ConvexCell> RingPieces::piece(std::size_t seed) const {
  const RingSeed& ring = seeds_[seed];
  const Vec3 reach = Vec3::Constant(kReach * ring.size), &out = ring.wall.normal;
  std::optional<ConvexCell> cell =
      box_cell((ring.at - reach).cwiseMax(lo_), (ring.at + reach).cwiseMin(hi_));
  const auto end_at = [&](const Vec3& point, const Vec3& normal) {
    if (cell) cell = part_below(std::move(*cell), point, normal, 0);
  };
  end_at(ring.at + 0.5 * ring.size * out, out);
  if (ring.hole >= 0) end_at(ring.wall.point, -out);
  for (const CutPlane& bound : bounds_) end_at(bound.point, bound.normal);
  for (std::size_t k = 0; k < seeds_.size() && cell; ++k) {
    const Vec3 between = seeds_[k].at - ring.at;
    if (k == seed || !is_here_[k] || between.norm() > kBeside * ring.size) continue;
    end_at(0.5 * (ring.at + seeds_[k].at), between.normalized());
  }
  return cell;
}

double RingPieces::worth(std::size_t seed) const {
  if (!is_here_[seed]) return 0.0;
  if (depth(seed) > kReach) return std::numeric_limits<double>::infinity();
  const std::optional<ConvexCell> rock = piece(seed);
  return rock ? worth_as_block(seeds_[seed], rock->shape) : 0.0;
}

void RingPieces::drop(std::size_t seed) {
  is_here_[seed] = false;
  worth_[seed] = 0.0;
  for (std::size_t k = 0; k < seeds_.size(); ++k) {
    const double away = (seeds_[k].at - seeds_[seed].at).norm();
    if (is_here_[k] && away < kBeside * seeds_[seed].size) worth_[k] = worth(k);
  }
}

void RingPieces::drop_slivers(bool one_at_least) {
  for (;;) {
    std::size_t least = seeds_.size(), count = 0;
    for (std::size_t k = 0; k < seeds_.size(); ++k) {
      if (!is_here_[k]) continue;
      ++count;
      if (least == seeds_.size() || worth_[k] < worth_[least]) least = k;
    }
    if (count == 0 || worth_[least] >= 1.0) return;
    if (count == 1 && one_at_least && worth_[least] > 0.0) return;
    drop(least);
  }
}

}  // namespace

double worth_as_block(const RingSeed& seed, const Polyhedron& rock) {
  constexpr double kNarrowest = 0.5;  // V^(1/3) [block sizes]
  const double volume = std::max(0.0, mass_properties(rock).volume);
  return std::min(mean_radius(rock) / (kThinnestPart * seed.size),
                  std::cbrt(volume) / (kNarrowest * seed.size));
}

HoleRings HoleRings::within(const std::vector<CutPlane>& bounds, bool one_at_least) const {
  HoleRings part = *this;
  RingPieces pieces(seeds_, bounds, lo_, hi_);
  pieces.drop_slivers(one_at_least);
  part.seeds_.clear();
  for (std::size_t k = 0; k < seeds_.size(); ++k)
    if (pieces.is_here()[k]) part.seeds_.push_back(seeds_[k]);
  return part;
}

}  // namespace muckpile
