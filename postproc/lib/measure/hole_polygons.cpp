// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons of rock of holes.
// Scope: see the header.
#include "measure/hole_polygons.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace muckpile {
namespace {

// Keeps what lies where normal.p <= bound.
struct HalfPlane {
  Vec2 normal;
  double bound;
};

std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const HalfPlane& side) {
  std::vector<Vec2> kept;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double here = side.normal.dot(a) - side.bound, there = side.normal.dot(b) - side.bound;
    if (here <= 0.0) kept.push_back(a);
    if (here * there < 0.0) kept.push_back(a + here / (here - there) * (b - a));
  }
  return kept.size() < 3 ? std::vector<Vec2>{} : kept;
}

// A row as it is at one height: its holes' places, by y, and the borders between them.
struct RowCut {
  std::vector<Vec2> axes;
  std::vector<double> borders;  // one less [m]
};

std::vector<RowCut> rows_at(const std::vector<PatternHole>& holes, double height) {
  std::vector<RowCut> rows;
  for (size_t first = 0; first < holes.size(); first = end_of_row(holes, first)) {
    RowCut row;
    for (size_t h = first; h < end_of_row(holes, first); ++h) {
      row.axes.push_back(axis_at(holes[h], height));
      const size_t k = row.axes.size();
      if (k > 1) row.borders.push_back(0.5 * (row.axes[k - 2].y() + row.axes[k - 1].y()));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// Where rock of row `r` ends in front, before a piece of the width within which no border lies.
double front_at(const std::vector<RowCut>& rows, size_t r, double y) {
  double front = HUGE_VAL;
  for (size_t q = 0; q < r; ++q) {
    const auto hole = std::ranges::upper_bound(rows[q].borders, y) - rows[q].borders.begin();
    front = std::min(front, rows[q].axes[static_cast<size_t>(hole)].x());
  }
  return front;
}

// Where its front may turn, rising, both ends included.
std::vector<double> turns_between(const std::vector<RowCut>& rows, size_t r, double low,
                                  double high, bool curved_face) {
  constexpr int kPieces = 24;
  std::vector<double> turns{low, high};
  for (size_t q = 0; q < r; ++q)
    std::ranges::copy_if(rows[q].borders, std::back_inserter(turns),
                         [&](double y) { return y > low && y < high; });
  for (int k = 1; curved_face && k < kPieces; ++k)
    turns.push_back(low + (high - low) * k / kPieces);
  std::ranges::sort(turns);
  return turns;
}

void add_corner(std::vector<Vec2>& corners, const Vec2& p) {
  const size_t n = corners.size();
  if (n > 1 && corners[n - 2].x() == p.x() && corners[n - 1].x() == p.x()) corners.pop_back();
  if (corners.empty() || corners.back() != p) corners.push_back(p);
}

// Of a bench that throws along x: hole `k` of row `r`.
std::vector<Vec2> burden_along_x(const std::vector<RowCut>& rows, size_t r, size_t k,
                                 const BenchPlanes& planes, const PlanCut& cut) {
  const RowCut& row = rows[r];
  const double low = k > 0 ? row.borders[k - 1] : std::max(planes.y_low, cut.low.y());
  const double high =
      k + 1 < row.axes.size() ? row.borders[k] : std::min(planes.y_high, cut.high.y());
  const double rear = std::max(row.axes[k].x(), cut.low.x());
  const auto face = [&](double y) {
    const double x =
        planes.face != nullptr ? planes.face->x(y, cut.height) : -planes.face_back * cut.height;
    return std::min(x, cut.high.x());
  };
  std::vector<Vec2> corners;
  double reach = 0.0;
  const std::vector<double> turns = turns_between(rows, r, low, high, planes.face != nullptr);
  for (size_t t = 0; t + 1 < turns.size(); ++t) {
    const double front = front_at(rows, r, 0.5 * (turns[t] + turns[t + 1]));
    for (const double y : {turns[t], turns[t + 1]}) {
      const double x = std::max(rear, std::min(front, face(y)));
      add_corner(corners, {x, y});
      reach = std::max(reach, x - rear);
    }
  }
  if (low >= high || reach <= 0.0) return {};
  corners.emplace_back(rear, high);
  corners.emplace_back(rear, low);
  return corners;
}

void add_bisectors(std::vector<HalfPlane>& sides, const HoleFrames& frames, size_t own,
                   double height) {
  const auto axis_of = [&](size_t hole) {
    return Vec2(frames.holes()[hole].foot + height * frames.holes()[hole].lean);
  };
  const Vec2 axis = axis_of(own);
  for (size_t other = 0; other < frames.holes().size(); ++other) {
    const Vec2 way = axis_of(other) - axis;
    if (other == own) continue;
    if (frames.stands_behind(own, other)) {  // its rock begins behind the other
      const Vec2& along = frames.holes()[other].direction;
      sides.push_back({along, along.dot(axis_of(other))});
    } else {
      sides.push_back({way, way.dot(axis + 0.5 * way)});
    }
  }
}

// Of a hole with a direction of its own.
std::vector<HalfPlane> sides_of(const HoleFrames& frames, size_t hole, double height) {
  std::vector<HalfPlane> sides;
  add_bisectors(sides, frames, hole, height);
  const HoleFrame& own = frames.holes()[hole];
  const Vec2 along = own.direction, left(-along.y(), along.x());
  const Vec2 axis = own.foot + height * own.lean;
  sides.push_back({along, frames.face_at(hole, height)});
  sides.push_back({-along, -along.dot(axis)});
  for (const Vec2& side : {left, Vec2(-left)})
    sides.push_back({side, side.dot(axis) + 0.5 * frames.plan().spacing});
  return sides;
}

std::vector<HolePolygon> burdens_by_frames(const HoleFrames& frames, const PlanCut& cut) {
  std::vector<HolePolygon> polygons;
  for (size_t h = 0; h < frames.holes().size(); ++h) {
    std::vector<Vec2> corners{
        cut.low, {cut.high.x(), cut.low.y()}, cut.high, {cut.low.x(), cut.high.y()}};
    for (const HalfPlane& side : sides_of(frames, h, cut.height)) corners = clipped(corners, side);
    polygons.push_back({frames.holes()[h].name, std::move(corners)});
  }
  return polygons;
}

}  // namespace

std::vector<HolePolygon> hole_polygons(const std::vector<PatternHole>& holes,
                                       const BenchPlanes& planes, const PlanCut& cut) {
  if (planes.frames != nullptr) return burdens_by_frames(*planes.frames, cut);
  const std::vector<RowCut> rows = rows_at(holes, cut.height);
  std::vector<HolePolygon> polygons;
  for (size_t r = 0; r < rows.size(); ++r)
    for (size_t k = 0; k < rows[r].axes.size(); ++k)
      polygons.push_back({holes[polygons.size()].name, burden_along_x(rows, r, k, planes, cut)});
  return polygons;
}

}  // namespace muckpile
