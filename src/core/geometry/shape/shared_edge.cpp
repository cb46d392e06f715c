// SPDX-License-Identifier: GPL-2.0-or-later
// Whether two plane polygons in space meet along an edge or in a point only.
// Scope: see the header.
#include "geometry/shape/shared_edge.h"

#include <algorithm>
#include <utility>

namespace muckpile {
namespace {

struct Edge {
  Vec3 from, to;
  [[nodiscard]] double length() const { return (to - from).norm(); }
};

Edge edge_of(std::span<const Vec3> polygon, std::size_t k) {
  return {polygon[k], polygon[(k + 1) % polygon.size()]};
}

/// The longer edge gives the line, whose direction is known best.
double overlap(Edge longer, Edge shorter, double apart) {
  if (shorter.length() > longer.length()) std::swap(longer, shorter);
  const double length = longer.length();
  if (!(length > apart)) return 0.0;
  const Vec3 along = (longer.to - longer.from) / length;
  const auto on_line = [&](const Vec3& p) { return along.dot(p - longer.from); };
  const auto off_line = [&](const Vec3& p) {
    return (p - longer.from - on_line(p) * along).norm();
  };
  if (off_line(shorter.from) > apart || off_line(shorter.to) > apart) return 0.0;
  const auto [low, high] = std::minmax({on_line(shorter.from), on_line(shorter.to)});
  return std::max(0.0, std::min(high, length) - std::max(low, 0.0));
}

}  // namespace

double shared_edge_length(std::span<const Vec3> a, std::span<const Vec3> b, double size) {
  constexpr double kApart = 1e-4;  // of the size
  double length = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (std::size_t m = 0; m < b.size(); ++m)
      length += overlap(edge_of(a, k), edge_of(b, m), kApart * size);
  }
  return length;
}

bool share_an_edge(std::span<const Vec3> a, std::span<const Vec3> b, double size) {
  constexpr double kEdge = 1e-2;  // of the size
  return shared_edge_length(a, b, size) > kEdge * size;
}

}  // namespace muckpile
