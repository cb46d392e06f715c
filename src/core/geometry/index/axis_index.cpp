// SPDX-License-Identifier: GPL-2.0-or-later
// Nearest of many charge axes, and those near a point: a tree of boxes around the axes.
// Scope: see the header.
#include "geometry/index/axis_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace muckpile {
namespace {

std::vector<BoxTree::Item> boxes_of(const std::vector<Axis>& axes) {
  std::vector<BoxTree::Item> items;
  for (const Axis& axis : axes)
    items.push_back({axis.from().cwiseMin(axis.to()), axis.from().cwiseMax(axis.to()),
                     axis.from() + axis.to()});
  return items;
}

}  // namespace

Axis::Axis(const Vec3& from, const Vec3& to)
    : from_(from), to_(to), direction_((to - from).normalized()), length_((to - from).norm()) {}

double Axis::distance(const Vec3& point) const {
  const double along = (point - from_).dot(direction_);
  const double across = (point - from_ - along * direction_).norm();
  const double beyond = along - std::clamp(along, 0.0, length_);
  return beyond == 0.0 ? across : std::hypot(beyond, across);
}

AxisIndex::AxisIndex(std::vector<Axis> axes) : axes_(std::move(axes)), tree_(boxes_of(axes_), 2) {}

double AxisIndex::nearest(const Vec3& point) const {
  double least = std::numeric_limits<double>::infinity();
  walk(
      point, [&] { return least * least; },
      [&](int k) {
        least = std::min(least, (*this)[k].distance(point));
        return false;
      });
  return least;
}

}  // namespace muckpile
