// SPDX-License-Identifier: GPL-2.0-or-later
// The crater of one charge under a flat free surface, and where its ejecta lie.
// Scope: ring means of column tops.
#include "measure/crater.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "measure/columns.h"
#include "measure/fragments.h"

namespace muckpile {
namespace {

// The crater ends where it is shallower than this share of its depth: rebound leaves the surface
// around a crater a little low, and without a raised lip it would have no edge.
constexpr double kEdgeDepth = 0.02;

// A column is measured where the model had rock at the start: outside, a ring would mix crater and
// empty box corner.
class RingSums {
 public:
  RingSums(const Columns& before, const Columns& after, const Columns& stayed,
           const std::vector<char>& moved, double width)
      : before_(before), after_(after), stayed_(stayed), moved_(moved), width_(width) {}

  void add(int i, int j, double deepest) {
    const ColumnGrid& grid = before_.grid;
    const size_t cell = grid.at(i, j);
    if (before_.top_block[cell] < 0) return;
    const auto ring = static_cast<size_t>(std::hypot(grid.x(i), grid.y(j)) / width_);
    while (rings_.size() <= ring) {
      rings_.push_back({(static_cast<double>(rings_.size()) + 0.5) * width_, 0.0, 0.0, 0.0, 0.0});
    }
    const double area = grid.dx * grid.dy, start = before_.top[cell];
    CraterRing& sum = rings_[ring];
    sum.area += area;
    sum.surface += area * (std::max(after_.top[cell], deepest) - start);
    sum.true_surface += area * (std::max(stayed_.top[cell], deepest) - start);
    if (moved_[static_cast<size_t>(before_.top_block[cell])] != 0) sum.moved_fraction += area;
  }

  std::vector<CraterRing> means() {
    for (CraterRing& ring : rings_) {
      if (ring.area == 0.0) continue;
      ring.surface /= ring.area;
      ring.true_surface /= ring.area;
      ring.moved_fraction /= ring.area;
    }
    return std::move(rings_);
  }

 private:
  const Columns &before_, &after_, &stayed_;
  const std::vector<char>& moved_;
  double width_;
  std::vector<CraterRing> rings_;
};

// Where `value` falls to zero between two rings, by a straight line; at the first ring's middle for
// no inner ring.
double zero_between(const std::vector<CraterRing>& rings, size_t outer, double inside,
                    double outside) {
  const double inner = rings[outer - 1].radius;
  return inner + inside / (inside - outside) * (rings[outer].radius - inner);
}

// Depth and volume of `surface` within the radius; the last ring counts by the share of its area
// inside.
CraterShape shape_within(double radius, const std::vector<CraterRing>& rings,
                         double CraterRing::*surface) {
  CraterShape shape{radius, 0.0, 0.0};
  const double half = 0.5 * (rings.size() > 1 ? rings[1].radius - rings[0].radius : 0.0);
  for (const CraterRing& ring : rings) {
    const double inner = ring.radius - half, outer = std::min(ring.radius + half, radius);
    if (inner >= radius) break;
    shape.depth = std::max(shape.depth, -(ring.*surface));
    shape.volume += std::numbers::pi * (outer * outer - inner * inner) * -(ring.*surface);
  }
  return shape;
}

}  // namespace

std::vector<CraterRing> crater_rings(const std::vector<StartBlock>& blocks, const Snapshot& last,
                                     const std::vector<char>& moved, double cell, double ring_width,
                                     const std::vector<char>& lies) {
  const Snapshot start = start_snapshot(blocks);
  const Extent extent = extent_of(blocks, start.states);
  const ColumnGrid grid =
      column_grid(extent.low.x(), extent.high.x(), extent.low.y(), extent.high.y(), cell);
  std::vector<char> stayed(moved);
  for (size_t b = 0; b < moved.size(); ++b) stayed[b] = moved[b] == 0 && lies[b] != 0;
  const std::vector<char> all(blocks.size(), 1);
  const Columns before = columns_through(grid, blocks, start.states, all);
  const Columns after = columns_through(grid, blocks, last.states, lies);
  const Columns in_place = columns_through(grid, blocks, last.states, stayed);
  RingSums sums(before, after, in_place, moved, ring_width);
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) sums.add(i, j, extent.low.z());
  }
  return sums.means();
}

CraterShape apparent_crater(const std::vector<CraterRing>& rings) {
  double depth = 0.0;
  for (const CraterRing& ring : rings) depth = std::max(depth, -ring.surface);
  const double edge = kEdgeDepth * depth;
  for (size_t k = 0; k < rings.size(); ++k) {
    if (-rings[k].surface > edge) continue;
    if (k == 0) return {0.0, 0.0, 0.0};
    const double radius =
        zero_between(rings, k, -rings[k - 1].surface - edge, -rings[k].surface - edge);
    return shape_within(radius, rings, &CraterRing::surface);
  }
  return {0.0, 0.0, 0.0};
}

CraterShape true_crater(const std::vector<CraterRing>& rings) {
  for (size_t k = 0; k < rings.size(); ++k) {
    if (rings[k].moved_fraction >= 0.5) continue;
    if (k == 0) return {0.0, 0.0, 0.0};
    return shape_within(
        zero_between(rings, k, rings[k - 1].moved_fraction - 0.5, rings[k].moved_fraction - 0.5),
        rings, &CraterRing::true_surface);
  }
  return {0.0, 0.0, 0.0};
}

Ejecta ejecta_beyond(double radius, const std::vector<StartBlock>& blocks, const Snapshot& last,
                     const std::vector<char>& moved) {
  std::vector<Piece> thrown;  // its "size" is the distance: the same curve answers both questions
  double mass = 0.0;
  for (size_t b = 0; b < blocks.size(); ++b) {
    const double distance = last.states[b].centre.head<2>().norm();
    // Rock around the crater that was heaved by more than its size has not been thrown out of it.
    if (moved[b] == 0 || distance <= radius || blocks[b].centroid.head<2>().norm() > radius)
      continue;
    thrown.push_back({distance, blocks[b].mass});
    mass += blocks[b].mass;
  }
  const std::vector<SizePoint> curve = passing_curve(std::move(thrown));
  return {mass, size_at(curve, 0.5), size_at(curve, 0.9), size_at(curve, 1.0)};
}

}  // namespace muckpile
