// SPDX-License-Identifier: GPL-2.0-or-later
// Neighbour search among points of strongly varying density: a k-d tree.
// Scope: built once for fixed points. Queries near the one before are answered without the tree.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "math/types.h"

namespace muckpile {

// Points as numbers side by side.
class PackedPoints {
 public:
  void clear() { count_ = 0; }
  void add(double x, double y, double z, int number);
  void add(const PackedPoints& other, std::size_t k) {
    add(other.x_[k], other.y_[k], other.z_[k], other.number_[k]);
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] int number(std::size_t k) const { return number_[k]; }
  // Calls visit(place, distance2) for those of a range of places whose squared distance [m2] from
  // `centre` is at least inner2 and less than outer2.
  template <class Visit>
  void each_between(std::size_t first, std::size_t last, const Vec3& centre, double inner2,
                    double outer2, const Visit& visit) const;

 private:
  std::size_t count_ = 0;
  std::vector<double> x_, y_, z_;  // [m]; room for some lanes more than there are points
  std::vector<int> number_;
};

class PointIndex {
 public:
  explicit PointIndex(const std::vector<Vec3>& points);
  // Replaces `within` by the points nearer than `radius` [m] to `centre`, in an order that is
  // fixed.
  void gather(const Vec3& centre, double radius, PackedPoints& within) const;

 private:
  struct Node {
    Vec3 lo, hi;              // bounding box of its points [m]
    int first = 0, last = 0;  // range in points_
    int right = 0;            // the left child is the next node; 0 for a leaf
  };
  int build(const std::vector<Vec3>& points, int first, int last, std::vector<int>& order);

  PackedPoints points_;
  std::vector<Node> nodes_;
};

// Queries that follow one another in space: the points of a ball are kept for those inside it. What
// they find does not depend on what was asked before.
class PointSearch {
 public:
  // The index must outlive this object.
  explicit PointSearch(const PointIndex& index) : index_(index) {}

  // For queries as far as `outer` [m], and a little farther, around these places: those that follow
  // one another near the first.
  void prepare(std::span<const Vec3> places, double outer);

  using Found = std::vector<std::pair<double, int>>;  // squared distance [m2], point number
  // The points with inner <= distance < outer [m] from `centre`, nearest first, then by number.
  // They stay until the next query.
  [[nodiscard]] const Found& shell(const Vec3& centre, double inner, double outer);

 private:
  [[nodiscard]] bool holds(const Vec3& centre, double outer) const;
  void hold(const Vec3& middle, double radius);
  void sort(double inner2, double outer2);

  const PointIndex& index_;
  PackedPoints held_;           // those in a ball
  Vec3 middle_ = Vec3::Zero();  // of the ball [m]
  double radius_ = 0.0;         // of the ball [m]
  Found unsorted_, found_;
};

}  // namespace muckpile
