// SPDX-License-Identifier: GPL-2.0-or-later
// A straight line drawn in plan, and rock as it is seen along it.
// Scope: the line goes on beyond its two points; heights stay as they are.
#pragma once

#include <cmath>
#include <vector>

#include "io/snapshot.h"
#include "measure/scan_polygon.h"

namespace muckpile {

struct PlanLine {
  Vec2 from, to;  // (x, y) [m]

  [[nodiscard]] double length() const { return (to - from).norm(); }
  // (distance along the line from `from`, distance to its left) [m].
  [[nodiscard]] Vec2 along_and_left(const Vec2& p) const {
    const Vec2 way = (to - from) / length(), d = p - from;
    return {way.dot(d), way.x() * d.y() - way.y() * d.x()};
  }
  [[nodiscard]] Vec2 at(double distance) const { return from + distance / length() * (to - from); }
  // Unit vector to its left.
  [[nodiscard]] Vec2 left() const { return Vec2(from.y() - to.y(), to.x() - from.x()) / length(); }
};

// In axes whose x runs along the line and whose y is to its left: poses, velocities and spins.
std::vector<BlockState> seen_along(const PlanLine& line, const std::vector<BlockState>& states);

// What went over a line: rock that started on one side of it and lies on the other.
struct OverLine {
  struct Piece {
    double distance;      // beyond the line [m]
    double volume, mass;  // [m3], [kg]
    Vec3 place;           // of its centroid [m]
  };
  std::vector<Piece> pieces;        // the farthest first
  double volume = 0.0, mass = 0.0;  // of all of them [m3], [kg]
  double sign = 1.0;                // 1: beyond is to the left of the line, -1: to its right
};

// Beyond is the side on which the smaller part of the rock's mass stood before the blast. Counted
// are blocks by their centroids, those that `lies` leaves out not.
OverLine over_line(const PlanLine& line, const std::vector<StartBlock>& blocks,
                   const Snapshot& last, const std::vector<char>& lies);

}  // namespace muckpile
