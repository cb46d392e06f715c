// SPDX-License-Identifier: GPL-2.0-or-later
// Crushed zones that would lie in one another.
// Scope: see the header.
#include "geometry/holes/hole_overlap.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "args/input_error.h"

namespace muckpile {
namespace {

constexpr double kTouching = 1e-9;      // share of a radius
constexpr double kParallelSine = 1e-6;  // axes at a smaller angle count as parallel

/// Sine of the angle between two vectors, the second of unit length.
double sine(const Vec3& vector, const Vec3& unit) { return vector.normalized().cross(unit).norm(); }

bool parallel_overlap(const Hole& a, const Hole& b, const Vec3& axis) {
  const double touching = kTouching * (a.radius + b.radius);
  const Vec3 between = b.toe - a.toe;
  if ((between - between.dot(axis) * axis).norm() >= a.radius + b.radius - touching) return false;
  const double from = (b.toe - a.toe).dot(axis), to = (b.collar - a.toe).dot(axis);
  const double end = (a.collar - a.toe).norm();
  return std::min(std::max(from, to), end) - std::max(std::min(from, to), 0.0) > touching;
}

/// From the point of axis a nearest to axis b to that point of b (Ericson 2005, Real-time collision
/// detection, 5.1.9).
Vec3 nearest_line(const Hole& a, const Hole& b) {
  const Vec3 along_a = a.collar - a.toe, along_b = b.collar - b.toe, between = a.toe - b.toe;
  const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), ab = along_a.dot(along_b);
  const double on_a = along_a.dot(between), on_b = along_b.dot(between);
  double s = std::clamp((ab * on_b - on_a * bb) / (aa * bb - ab * ab), 0.0, 1.0);
  const double t = std::clamp((ab * s + on_b) / bb, 0.0, 1.0);
  s = std::clamp((ab * t - on_a) / aa, 0.0, 1.0);
  return (b.toe + t * along_b) - (a.toe + s * along_a);
}

double lowest_x(const Hole& hole) { return std::min(hole.toe.x(), hole.collar.x()) - hole.radius; }
double highest_x(const Hole& hole) { return std::max(hole.toe.x(), hole.collar.x()) + hole.radius; }

[[noreturn]] void refuse(std::size_t i, std::size_t k) {
  throw InputError("the crushed zones of holes " + std::to_string(std::min(i, k) + 1) + " and " +
                   std::to_string(std::max(i, k) + 1) +
                   " overlap: move the holes apart, or make their radii smaller");
}

}  // namespace

bool overlap(const Hole& a, const Hole& b) {
  const Vec3 axis_a = (a.collar - a.toe).normalized(), axis_b = (b.collar - b.toe).normalized();
  if (sine(axis_a, axis_b) < kParallelSine) return parallel_overlap(a, b, axis_a);
  const Vec3 line = nearest_line(a, b);
  const double apart = line.norm();
  if (apart <= kTouching * (a.radius + b.radius)) return true;
  // A radius counts by as much as the line leaves its axis sideways: not at all from end to end.
  return apart <
         (1.0 - kTouching) * (a.radius * sine(line, axis_a) + b.radius * sine(line, axis_b));
}

void refuse_overlapping_holes(const std::vector<Hole>& holes) {
  std::vector<std::size_t> order(holes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&holes](std::size_t i, std::size_t k) {
    return lowest_x(holes[i]) < lowest_x(holes[k]);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Hole& hole = holes[order[i]];
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      if (lowest_x(holes[order[k]]) > highest_x(hole)) break;
      if (overlap(hole, holes[order[k]])) refuse(order[i], order[k]);
    }
  }
}

}  // namespace muckpile
