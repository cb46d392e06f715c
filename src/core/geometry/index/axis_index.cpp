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

AxisIndex::AxisIndex(std::vector<Axis> axes) : axes_(std::move(axes)), tree_(boxes_of(axes_), 2) {}

double AxisIndex::nearest(const Vec3& point) const {
  double least2 = std::numeric_limits<double>::infinity();
  walk(
      point, [&] { return least2; },
      [&](int k) {
        least2 = std::min(least2, (*this)[k].distance2(point));
        return false;
      });
  return std::sqrt(least2);
}

}  // namespace muckpile
