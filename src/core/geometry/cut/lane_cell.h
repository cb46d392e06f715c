// SPDX-License-Identifier: GPL-2.0-or-later
// A convex cell around the origin as corners between three planes each, for its volume and
// centroid: planes are held against all corners at once.
// Scope: what a Lloyd sweep needs of a Voronoi cell. A cell that rounding or its number of corners
// make doubtful is given up, for voro++ to cut.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/shape/polyhedron.h"
#include "math/types.h"

namespace muckpile {

class LaneCell {
 public:
  /// A box that holds the origin [m].
  void start(const Vec3& lo, const Vec3& hi);
  /// Takes away what lies beyond normal . x = offset. False if the cell is given up: the origin
  /// lies beyond, nothing would be left, the rim of what goes is no simple line, or there is no
  /// room. `number` is for those who ask for its face.
  [[nodiscard]] bool cut(const Vec3& normal, double offset, int number);

  [[nodiscard]] double farthest2() const;  ///< square of the distance of the farthest corner [m2]
  /// Whether a plane has a face whose number, negative for the walls of the box, fulfils this.
  template <class Condition>
  [[nodiscard]] bool any_face(const Condition& condition) const {
    for (std::uint64_t left = planes_with_faces(); left != 0; left &= left - 1)
      if (condition(numbers_[static_cast<std::size_t>(std::countr_zero(left))])) return true;
    return false;
  }
  struct Measure {
    double volume = 0.0;           // [m3]
    Vec3 centroid = Vec3::Zero();  // [m]
  };
  [[nodiscard]] Measure measure() const;
  /// The cell around a place, and per face the number of its plane.
  void extract(const Vec3& centre, Polyhedron& shape, std::vector<int>& behind) const;

 private:
  static constexpr std::size_t kMost = 64;  // corners and planes: a bit each
  static constexpr std::size_t kWalls = 6;
  using Number = std::uint8_t;  // of a plane or a corner
  /// An edge on the rim of what goes: of planes a and b, from a corner that goes to one that stays.
  struct RimEdge {
    Number a, b, goes, stays;
  };

  [[nodiscard]] std::uint64_t planes_with_faces() const;
  [[nodiscard]] std::uint64_t corners_beyond(const Vec3& normal, double offset);
  /// False if they are not one closed line.
  [[nodiscard]] bool find_rim(std::uint64_t beyond);
  void place(std::size_t corner, const Vec3& at, Number a, Number b, Number c);
  void move_last_to(std::size_t corner);

  std::size_t corners_ = 0, planes_ = 0, rim_edges_ = 0;
  // Of the corners [m]; the origin from corners_ on, which no plane cuts off.
  alignas(64) std::array<double, kMost> x_{}, y_{}, z_{};
  alignas(64) std::array<double, kMost> height_{};         // over the last plane
  std::array<std::array<Number, 3>, kMost> around_{};      // planes of a corner, counter-clockwise
  std::array<std::array<Number, kMost>, kMost> corner_{};  // [a][b]: at which b follows a
  std::array<Vec3, kMost> foot_;                           // of the perpendicular to a plane [m]
  std::array<int, kMost> numbers_{};
  std::array<RimEdge, kMost> rim_{};
};

}  // namespace muckpile
