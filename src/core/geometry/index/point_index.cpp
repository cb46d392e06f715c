// SPDX-License-Identifier: GPL-2.0-or-later
// Neighbour search among points of strongly varying density: a k-d tree.
// Scope: median splits along the longest edge of each node's bounding box; ties go by number.
#include "geometry/index/point_index.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <experimental/simd>
#include <numeric>

#include "math/lanes.h"

namespace muckpile {
namespace {
using Native = std::experimental::native_simd<double>;
Native native(const double* from) { return {from, std::experimental::element_aligned}; }

constexpr int kLeafSize = 32;
constexpr std::size_t kDeepest = 64;  // levels of halves of 2^31 points, and more
constexpr double kRounding = 1e-14;   // of a square that is summed in another order
}  // namespace

void PackedPoints::add(double x, double y, double z, int number) {
  if (count_ + kNativeLanes > number_.size()) {
    constexpr std::size_t kLeast = 64;
    const std::size_t room = std::max(kLeast, 2 * number_.size());
    for (std::vector<double>* one : {&x_, &y_, &z_}) one->resize(room, 0.0);
    number_.resize(room);
  }
  x_[count_] = x;
  y_[count_] = y;
  z_[count_] = z;
  number_[count_++] = number;
}

// The last lanes may hold anything; bits of theirs are taken away.
template <class Visit>
void PackedPoints::each_between(std::size_t first, std::size_t last, const Vec3& centre,
                                double inner2, double outer2, const Visit& visit) const {
  const Native cx = centre.x(), cy = centre.y(), cz = centre.z();
  std::array<double, kNativeLanes> squared;
  for (std::size_t k = first; k < last; k += kNativeLanes) {
    const Native dx = native(&x_[k]) - cx, dy = native(&y_[k]) - cy, dz = native(&z_[k]) - cz;
    const Native distance2 = dx * dx + dy * dy + dz * dz;
    unsigned in = bits_of<Native>(distance2 >= inner2 && distance2 < outer2);
    if (last - k < kNativeLanes) in &= (1u << (last - k)) - 1u;
    distance2.copy_to(squared.data(), std::experimental::element_aligned);
    for (; in != 0; in &= in - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(in));
      visit(k + lane, squared[lane]);
    }
  }
}

PointIndex::PointIndex(const std::vector<Vec3>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  if (!points.empty()) build(points, 0, static_cast<int>(points.size()), order);
  for (const int k : order) {
    const Vec3& p = points[static_cast<std::size_t>(k)];
    points_.add(p.x(), p.y(), p.z(), k);
  }
}

int PointIndex::build(const std::vector<Vec3>& points, int first, int last,
                      std::vector<int>& order) {
  const auto point = [&](int k) -> const Vec3& { return points[static_cast<std::size_t>(k)]; };
  Node node;
  node.first = first;
  node.last = last;
  node.lo = node.hi = point(order[static_cast<std::size_t>(first)]);
  for (int k = first; k < last; ++k) {
    const Vec3& p = point(order[static_cast<std::size_t>(k)]);
    node.lo = node.lo.cwiseMin(p);
    node.hi = node.hi.cwiseMax(p);
  }
  const std::size_t self = nodes_.size();
  nodes_.push_back(node);
  if (last - first > kLeafSize) {
    Eigen::Index axis = 0;
    (node.hi - node.lo).maxCoeff(&axis);
    const int middle = first + (last - first) / 2;
    std::nth_element(
        order.begin() + first, order.begin() + middle, order.begin() + last,
        [&](int a, int b) { return std::pair(point(a)[axis], a) < std::pair(point(b)[axis], b); });
    build(points, first, middle, order);
    nodes_[self].right = build(points, middle, last, order);
  }
  return static_cast<int>(self);
}

void PointIndex::gather(const Vec3& centre, double radius, PackedPoints& within) const {
  const double radius2 = radius * radius;
  within.clear();
  std::array<int, kDeepest> waiting;  // one node per level at most
  std::size_t count = 0;
  if (!nodes_.empty()) waiting[count++] = 0;
  while (count > 0) {
    const int number = waiting[--count];
    const Node& node = nodes_[static_cast<std::size_t>(number)];
    const Vec3 nearest = centre.cwiseMax(node.lo).cwiseMin(node.hi);
    if ((nearest - centre).squaredNorm() >= radius2) continue;
    if (node.right != 0) {
      waiting[count++] = node.right;
      waiting[count++] = number + 1;
      continue;
    }
    points_.each_between(static_cast<std::size_t>(node.first), static_cast<std::size_t>(node.last),
                         centre, 0.0, radius2,
                         [&](std::size_t k, double) { within.add(points_, k); });
  }
}

// A ball much larger than is needed makes queries slow.
bool PointSearch::holds(const Vec3& centre, double outer) const {
  constexpr double kTooLarge = 4.8;
  const bool inside = (centre - middle_).norm() + outer <= (1.0 - kRounding) * radius_;
  return inside && radius_ <= kTooLarge * outer;
}

void PointSearch::hold(const Vec3& middle, double radius) {
  middle_ = middle;
  radius_ = radius;
  index_.gather(middle_, radius_, held_);
}

void PointSearch::prepare(std::span<const Vec3> places, double outer) {
  constexpr double kNear = 2.0, kFarther = 1.2;  // of `outer`
  if (holds(places.front(), outer)) return;
  Vec3 lo = places.front(), hi = lo;
  for (const Vec3& place : places) {
    if ((place - places.front()).norm() > kNear * outer) break;
    lo = lo.cwiseMin(place);
    hi = hi.cwiseMax(place);
  }
  hold(0.5 * (lo + hi), 0.5 * (hi - lo).norm() + kFarther * outer);
}

const PointSearch::Found& PointSearch::shell(const Vec3& centre, double inner, double outer) {
  constexpr double kRoom = 1.5;
  if (!holds(centre, outer)) hold(centre, kRoom * outer);
  const double inner2 = inner * inner, outer2 = outer * outer;
  unsorted_.clear();
  held_.each_between(
      0, held_.count(), centre, inner2, outer2,
      [&](std::size_t k, double distance2) { unsorted_.emplace_back(distance2, held_.number(k)); });
  sort(inner2, outer2);
  return found_;
}

// Into bins of like distance, which hold about one each, then past the few that are out of order.
void PointSearch::sort(double inner2, double outer2) {
  constexpr std::size_t kBins = 64;
  found_.resize(unsorted_.size());
  if (unsorted_.size() < 2) {
    std::ranges::copy(unsorted_, found_.begin());
    return;
  }
  const double scale = static_cast<double>(kBins) / (outer2 - inner2);
  const auto bin = [&](double distance2) {
    return std::min(kBins - 1, static_cast<std::size_t>((distance2 - inner2) * scale));
  };
  std::array<std::uint32_t, kBins + 1> start{};
  for (const auto& one : unsorted_) ++start[bin(one.first) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  for (const auto& one : unsorted_) found_[start[bin(one.first)]++] = one;
  for (std::size_t k = 1; k < found_.size(); ++k) {
    const auto one = found_[k];
    std::size_t place = k;
    for (; place > 0 && one < found_[place - 1]; --place) found_[place] = found_[place - 1];
    found_[place] = one;
  }
}

}  // namespace muckpile
