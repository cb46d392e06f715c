// SPDX-License-Identifier: GPL-2.0-or-later
// A bench whose holes do not all throw to one side: each hole has a direction, along which its rock
// goes, and the face in front of it.
// Scope: the rock of a hole is what it stands behind, half a spacing to a side, and what lies
// between that and the rock of a neighbour, in front of the line from hole to hole; of several such
// holes the nearest. Throw is along its direction. Other places are told by the nearest hole.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "math/types.h"
#include "measure/scan_polygon.h"

namespace muckpile {

// Holes are neighbours, with no hole left out between them, up to so many spacings.
constexpr double kNeighbours = 1.5;

// What lies where normal.p <= bound.
struct HalfPlane {
  Vec2 normal;
  double bound;
  [[nodiscard]] double beyond(const Vec2& p) const { return normal.dot(p) - bound; }
};
using ThreeSides = std::array<HalfPlane, 3>;

// Of two neighbours: the way from the left to the right one goes across the way of both.
struct HolePair {
  size_t left, right;
};

struct HoleFrame {
  std::string name;
  Vec2 foot;               // where its axis meets the height of the floor (x, y) [m]
  Vec2 lean;               // way of the axis along x and y per height
  Vec2 direction;          // unit vector, the normal of its burden in plan
  std::vector<Vec2> face;  // (height, place along the direction) of the face, rising; not empty [m]
  int row = 0;             // how many holes stand in front of it
};

// How the spacing of the holes bounds what is theirs.
struct HolePlan {
  double burden, spacing;  // [m]
};

class HoleFrames {
 public:
  // One hole at least. Throws InputError where a hole has no face.
  HoleFrames(std::vector<HoleFrame> holes, HolePlan plan);

  [[nodiscard]] const std::vector<HoleFrame>& holes() const { return holes_; }
  [[nodiscard]] const HolePlan& plan() const { return plan_; }
  // Where its face is along its direction at a height [m].
  [[nodiscard]] double face_at(size_t hole, double height) const;
  // The nearest one.
  [[nodiscard]] size_t hole_at(const Vec3& p) const;
  // Whose rock a place is: of the nearest of the holes in whose strip it lies; in none of them, of
  // the nearer of two neighbours between which it lies; none for places behind and beside all.
  [[nodiscard]] std::optional<size_t> hole_of(const Vec3& p) const;
  [[nodiscard]] Vec2 axis_at(size_t hole, double height) const;
  // In front of a hole, half a spacing to a side.
  [[nodiscard]] ThreeSides strip(size_t hole, double height) const;
  // Pairs of neighbours with, between their directions, rock that may lie in no strip.
  [[nodiscard]] const std::vector<HolePair>& pairs() const { return pairs_; }
  // In front of the line between two holes and between the ways that they throw.
  [[nodiscard]] ThreeSides between(const HolePair& pair, double height) const;
  // One burden behind it, as a hole of the next row, which may be staggered.
  [[nodiscard]] bool stands_behind(size_t other, size_t hole) const;
  // No hole stands behind it.
  [[nodiscard]] bool is_last(size_t hole) const { return last_[hole] != 0; }
  // Of the last row by BenchPlanes::row_depth [m].
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] int rows() const { return rows_; }
  // Of the foot of a hole to the face, along its direction [m].
  [[nodiscard]] double burden_at_floor(size_t hole) const;
  // The hole that throws most to the side turns by so much from +x [rad].
  [[nodiscard]] double largest_turn() const;

  // As those of BenchPlanes.
  [[nodiscard]] double behind_face(const Vec3& p) const;
  // Less than the plan's burden in front of a hole of the first row, more than depth() behind one
  // of the last.
  [[nodiscard]] double row_depth(const Vec3& p) const;
  // Within half a spacing beside a hole, seen along its direction, or between two neighbours.
  [[nodiscard]] bool abreast(const Vec3& p) const;
  [[nodiscard]] Vec3 outward(const Vec3& start) const;
  [[nodiscard]] bool beyond_toe(const Vec3& start, const Vec3& end) const;

 private:
  [[nodiscard]] Vec2 from_axis(const Vec3& p, size_t hole) const;
  [[nodiscard]] double depth_of_row(size_t hole) const;
  [[nodiscard]] double depth_in_front(size_t hole, double before) const;
  [[nodiscard]] std::optional<size_t> hole_between(const Vec3& p) const;
  [[nodiscard]] bool are_neighbours(size_t one, size_t other) const;
  void find_pairs();

  std::vector<HoleFrame> holes_;
  HolePlan plan_;
  std::vector<HolePair> pairs_;
  std::vector<char> last_;
  std::vector<double> rise_;  // of each face along the direction, per height
  int rows_ = 1;
  double depth_ = 0.0;
};

}  // namespace muckpile
