// SPDX-License-Identifier: GPL-2.0-or-later
// What the seeds must know of the scene: where there is rock, and how large blocks should be there.
// Scope: read-only view of validated TessellationOptions; lengths in metres.
#include "geometry/cut/ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/holes/hole_surface.h"
#include "geometry/size/size_factor.h"

namespace muckpile {

namespace {

AxisIndex axes_of(const TessellationOptions& options) {
  std::vector<Axis> axes;
  for (const Hole& hole : options.holes) axes.emplace_back(hole.toe, hole.collar);
  for (const auto& [from, to] : options.fine_axes) axes.emplace_back(from, to);
  return AxisIndex(std::move(axes));
}

}  // namespace

Ground::Ground(const TessellationOptions& options, HoleRings rings)
    : options_(options),
      axes_(axes_of(options)),
      rings_(std::move(rings)),
      largest_radius_(rings_.largest_reach()) {
  for (const Hole& hole : options.holes) largest_radius_ = std::max(largest_radius_, hole.radius);
}

bool Ground::in_region(const Vec3& point) const {
  const bool in_box =
      (point.array() >= options_.lo.array()).all() && (point.array() <= options_.hi.array()).all();
  return in_box && (!options_.region.inside || options_.region.inside(point));
}

bool Ground::is_rock(const Vec3& point) const {
  if (!in_region(point)) return false;
  return !axes_.any_within(point, largest_radius_, [&](int axis) {
    const auto h = static_cast<std::size_t>(axis);
    if (rings_.around(h)) return axes_[axis].distance(point) < rings_.reach(h);
    return h < options_.holes.size() && inside_hole(options_.holes[h], point);
  });
}

double Ground::charge_distance(const Vec3& point) const { return axes_.nearest(point); }

void Ground::holes_near(const Vec3& point, double distance, std::vector<int>& found) const {
  found.clear();
  axes_.any_within(point, distance + largest_radius_, [&](int axis) {
    if (static_cast<std::size_t>(axis) < options_.holes.size()) found.push_back(axis);
    return false;
  });
  std::sort(found.begin(), found.end());
}

double Ground::law_nearer(const Vec3& point, double nearer) const {
  if (!options_.superpose || options_.holes.empty()) {
    return options_.size.at(std::max(0.0, charge_distance(point) - nearer));
  }
  std::vector<double> distances;
  for (int h = 0; h < static_cast<int>(options_.holes.size()); ++h) {
    distances.push_back(std::max(0.0, axes_[h].distance(point) - nearer));
  }
  return options_.size.superposed(distances);
}

double Ground::size(const Vec3& point) const {
  const double law = law_nearer(point, 0.0);
  return options_.factor ? options_.factor->size(point, law, charge_distance(point)) : law;
}

double Ground::smallest_size_near(const Vec3& point, double reach) const {
  const double law = law_nearer(point, reach);
  if (!options_.factor) return law;
  const double beyond = law_nearer(point, reach + options_.factor->cell_diagonal());
  return options_.factor->least_size(point, reach, law, beyond);
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

Ground voronoi_ground(const TessellationOptions& options) {
  return Ground(options, HoleRings(options));
}

}  // namespace muckpile
