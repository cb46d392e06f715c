// SPDX-License-Identifier: GPL-2.0-or-later
// Vertical section: the polygons in which a plane y = const cuts the posed blocks.
// Scope: convex blocks; the crossings of edges are put in order by their angle about their mean. A
// face may be made of several polygons whose corners lie on the edges of faces beside it, as on a
// natural joint, so an edge need not belong to two polygons.
#include "measure/section.h"

#include <algorithm>
#include <cmath>

#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

// Whether any of its vertices is as far from the centroid; with room for rounding.
bool reaches(const StartBlock& block, double distance) {
  const double least = 0.998 * distance * distance;
  return std::ranges::any_of(block.shape.vertices, [&](const Vec3& p) {
    return (p - block.centroid).squaredNorm() >= least;
  });
}

/// An edge that belongs to two faces gives the same point twice.
std::vector<Vec2> crossings(double y, const std::vector<Vec3>& vertices,
                            const FlatPolyhedron& shape) {
  std::vector<Vec2> points;
  for (const std::span<const int> face : shape.faces) {
    for (size_t k = 0; k < face.size(); ++k) {
      const auto [from, to] = std::minmax(face[k], face[(k + 1) % face.size()]);
      const Vec3 &a = vertices[static_cast<size_t>(from)], &b = vertices[static_cast<size_t>(to)];
      if ((a.y() <= y) == (b.y() <= y)) continue;
      const double t = (y - a.y()) / (b.y() - a.y());
      points.emplace_back(a.x() + t * (b.x() - a.x()), a.z() + t * (b.z() - a.z()));
    }
  }
  return points;
}

void put_in_order(std::vector<Vec2>& points) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : points) mean += p / static_cast<double>(points.size());
  std::ranges::sort(points, {},
                    [&](const Vec2& p) { return std::atan2(p.y() - mean.y(), p.x() - mean.x()); });
  points.erase(std::ranges::unique(points).begin(), points.end());
}

}  // namespace

std::vector<SectionPolygon> section_at(double y, const std::vector<StartBlock>& blocks,
                                       const std::vector<BlockState>& states) {
  std::vector<std::vector<Vec2>> outlines(blocks.size());
  each_in_parallel(blocks.size(), [&](size_t b) {
    if (!reaches(blocks[b], std::abs(states[b].centre.y() - y))) return;
    outlines[b] = crossings(y, moved_vertices(blocks[b], states[b]), blocks[b].shape);
    put_in_order(outlines[b]);
  });
  std::vector<SectionPolygon> section;
  for (size_t b = 0; b < blocks.size(); ++b)
    if (outlines[b].size() >= 3) section.push_back({b, std::move(outlines[b])});
  return section;
}

}  // namespace muckpile
