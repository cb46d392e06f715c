// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles of a surface in a tree of boxes: which are near a point, how far the nearest is, and
// how many lie above a point.
// Scope: built once; queries are const. A triangle's normal follows the turn of its corners.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/files/stl_file.h"
#include "geometry/index/box_tree.h"
#include "math/types.h"

namespace muckpile {

class SurfaceIndex {
 public:
  explicit SurfaceIndex(std::vector<StlTriangle> triangles);

  [[nodiscard]] const std::vector<StlTriangle>& triangles() const { return triangles_; }
  [[nodiscard]] const Vec3& unit_normal(std::size_t triangle) const { return normals_[triangle]; }
  [[nodiscard]] double area() const;  // [m2]
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] const Vec3& lo() const { return tree_.node(0).lo; }  // of the box around all [m]
  [[nodiscard]] const Vec3& hi() const { return tree_.node(0).hi; }

  struct Closest {
    Vec3 point = Vec3::Zero();  // [m]
    double distance = 0.0;      // [m]
    std::size_t triangle = 0;
  };
  [[nodiscard]] Closest closest(const Vec3& from) const;

  // Triangles with a point within a distance [m] of a place, in a fixed order.
  void near(const Vec3& place, double distance, std::vector<std::size_t>& found) const;

  struct Crossing {
    double height = 0.0;  // [m]
    bool up = true;       // the triangle looks up
  };
  // Where a vertical line meets the surface, rising. Of triangles that share an edge on the line
  // one is met.
  void crossings_at(double x, double y, std::vector<Crossing>& crossings) const;

  // Whether an odd number of triangles lies above: inside of a closed surface, below a terrain.
  [[nodiscard]] bool inside(const Vec3& point) const;

  // Whether the way between two points meets an odd number of triangles: they lie on two sides.
  [[nodiscard]] bool parts(const Vec3& from, const Vec3& to) const;

 private:
  void look_for_closest(std::size_t node, const Vec3& from, Closest& best) const;
  template <class Visit>
  void visit_column(double x, double y, double from_z, const Visit& visit) const;

  std::vector<StlTriangle> triangles_;
  std::vector<Vec3> normals_;
  BoxTree tree_;
};

}  // namespace muckpile
