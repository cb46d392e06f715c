// SPDX-License-Identifier: GPL-2.0-or-later
// What the seeds must know of the scene: where there is rock, and how large blocks should be there.
// Scope: read-only view of validated TessellationOptions; lengths in metres.
#include "geometry/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/hole_surface.h"

namespace muckpile {

bool Ground::in_region(const Vec3& point) const {
  const bool in_box =
      (point.array() >= options_.lo.array()).all() && (point.array() <= options_.hi.array()).all();
  return in_box && (!options_.region.inside || options_.region.inside(point));
}

bool Ground::is_rock(const Vec3& point) const {
  const auto holds = [&](const Hole& hole) { return inside_hole(hole, point); };
  return in_region(point) && std::none_of(options_.holes.begin(), options_.holes.end(), holds);
}

double Ground::charge_distance(const Vec3& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Hole& hole : options_.holes)
    nearest = std::min(nearest, distance_to_axis(hole, point));
  for (const auto& [from, to] : options_.fine_axes)
    nearest = std::min(nearest, distance_to_axis({from, to, 0.0}, point));
  return nearest;
}

double Ground::size_nearer(const Vec3& point, double nearer) const {
  if (!options_.superpose || options_.holes.empty()) {
    return options_.size.at(std::max(0.0, charge_distance(point) - nearer));
  }
  std::vector<double> distances;
  for (const Hole& hole : options_.holes) {
    distances.push_back(std::max(0.0, distance_to_axis(hole, point) - nearer));
  }
  return options_.size.superposed(distances);
}

double Ground::size(const Vec3& point) const { return size_nearer(point, 0.0); }

double Ground::smallest_size_near(const Vec3& point, double reach) const {
  return size_nearer(point, reach);
}

Vec3 Ground::log_size_gradient(const Vec3& point) const {
  const double step = 0.05 * size(point);
  Vec3 gradient;
  for (int i = 0; i < 3; ++i) {
    const Vec3 shift = step * Vec3::Unit(i);
    gradient[i] = std::log(size(point + shift) / size(point - shift)) / (2.0 * step);
  }
  return gradient;
}

}  // namespace muckpile
