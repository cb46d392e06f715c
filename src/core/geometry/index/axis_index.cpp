// SPDX-License-Identifier: GPL-2.0-or-later
// Nearest of many charge axes, and those near a point: a tree of boxes around the axes.
// Scope: median splits by the middles of the axes; nearer boxes are looked into first.
#include "geometry/index/axis_index.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace muckpile {
namespace {

constexpr int kLeafSize = 2;

}  // namespace

Axis::Axis(const Vec3& from, const Vec3& to)
    : from_(from), to_(to), direction_((to - from).normalized()), length_((to - from).norm()) {}

double Axis::distance(const Vec3& point) const {
  const double along = (point - from_).dot(direction_);
  const double across = (point - from_ - along * direction_).norm();
  const double beyond = along - std::clamp(along, 0.0, length_);
  return beyond == 0.0 ? across : std::hypot(beyond, across);
}

AxisIndex::AxisIndex(std::vector<Axis> axes) : axes_(std::move(axes)), order_(axes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!axes_.empty()) build(0, static_cast<int>(axes_.size()));
}

int AxisIndex::build(int first, int last) {
  Node node;
  node.first = first;
  node.last = last;
  node.lo.setConstant(std::numeric_limits<double>::infinity());
  node.hi = -node.lo;
  for (int k = first; k < last; ++k) {
    const Axis& one = (*this)[order_[static_cast<std::size_t>(k)]];
    node.lo = node.lo.cwiseMin(one.from().cwiseMin(one.to()));
    node.hi = node.hi.cwiseMax(one.from().cwiseMax(one.to()));
  }
  const std::size_t self = nodes_.size();
  nodes_.push_back(node);
  if (last - first > kLeafSize) {
    Eigen::Index along = 0;
    (node.hi - node.lo).maxCoeff(&along);
    const int middle = first + (last - first) / 2;
    const auto place = [&](int n) { return (*this)[n].from()[along] + (*this)[n].to()[along]; };
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int a, int b) { return std::pair(place(a), a) < std::pair(place(b), b); });
    build(first, middle);
    nodes_[self].right = build(middle, last);
  }
  return static_cast<int>(self);
}

double AxisIndex::Node::distance2(const Vec3& point) const {
  return (point - point.cwiseMax(lo).cwiseMin(hi)).squaredNorm();
}

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
