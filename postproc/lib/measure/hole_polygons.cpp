// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons of rock of holes.
// Scope: see the header.
#include "measure/hole_polygons.h"

#include <algorithm>
#include <cmath>

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

Vec2 axis_at(const PatternHole& hole, double height) { return hole.foot + height * hole.lean; }

void add_bisectors(std::vector<HalfPlane>& sides, const std::vector<PatternHole>& holes, size_t own,
                   double height) {
  const Vec2 axis = axis_at(holes[own], height);
  for (size_t other = 0; other < holes.size(); ++other) {
    const Vec2 way = axis_at(holes[other], height) - axis;
    if (other != own) sides.push_back({way, way.dot(axis + 0.5 * way)});
  }
}

// Face, rear and ends of a bench that throws along x; a face that is no plane is cut by its line.
void add_bench(std::vector<HalfPlane>& sides, const BenchPlanes& planes, const PlanCut& cut) {
  const double rear = cut.depth + 0.5 * cut.burden + planes.hole_back * cut.height;
  sides.push_back({-Vec2::UnitX(), rear});
  sides.push_back({-Vec2::UnitY(), -planes.y_low});
  sides.push_back({Vec2::UnitY(), planes.y_high});
  if (planes.face == nullptr) sides.push_back({Vec2::UnitX(), -planes.face_back * cut.height});
}

// Of a hole with a direction of its own; half a spacing to a side where no hole stands.
void add_frame(std::vector<HalfPlane>& sides, const HoleFrames& frames, const std::string& name,
               const PlanCut& cut) {
  const auto own = std::ranges::find(frames.holes(), name, &HoleFrame::name);
  if (own == frames.holes().end()) return;
  const Vec2 along = own->direction, left(-along.y(), along.x());
  const Vec2 axis = own->foot + cut.height * own->lean;
  const auto hole = static_cast<size_t>(own - frames.holes().begin());
  sides.push_back({along, frames.face_at(hole, cut.height)});
  const double row = frames.is_last(hole) ? frames.depth() : (own->row + 1) * frames.plan().burden;
  const double rear =
      frames.depth() + 0.5 * cut.burden - row;  // behind the axis, as row_depth has it
  sides.push_back({-along, rear - along.dot(axis)});
  const double half = 0.5 * frames.plan().spacing;
  for (const Vec2& side : {left, Vec2(-left)}) {
    const bool bounded = std::ranges::any_of(frames.holes(), [&](const HoleFrame& other) {
      const Vec2 way = other.foot - own->foot;
      return side.dot(way) > 0.5 * half && std::abs(along.dot(way)) < 1.75 * cut.burden;
    });
    if (!bounded) sides.push_back({side, side.dot(axis) + half});
  }
}

// Where a line of constant y runs through a convex polygon: least and greatest x; false beside it.
bool across(const std::vector<Vec2>& polygon, double y, Vec2& ends) {
  ends = {HUGE_VAL, -HUGE_VAL};
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if (std::min(a.y(), b.y()) > y || std::max(a.y(), b.y()) < y) continue;
    const double share = a.y() == b.y() ? 0.0 : (y - a.y()) / (b.y() - a.y());
    for (const double x : {a.x() + share * (b.x() - a.x()), a.y() == b.y() ? b.x() : HUGE_VAL}) {
      if (x == HUGE_VAL) continue;
      ends = {std::min(ends.x(), x), std::max(ends.y(), x)};
    }
  }
  return ends.x() <= ends.y();
}

// Its front as the face is there.
std::vector<Vec2> behind_face(const std::vector<Vec2>& polygon, const FaceMap& face,
                              double height) {
  constexpr int kPieces = 24;
  if (polygon.empty()) return {};
  const auto by_y = [](const Vec2& p) { return p.y(); };
  const double low = std::ranges::min(polygon, {}, by_y).y(),
               high = std::ranges::max(polygon, {}, by_y).y();
  std::vector<Vec2> front, rear;
  for (int k = 0; k <= kPieces; ++k) {
    const double y = low + (high - low) * k / kPieces;
    Vec2 ends;
    if (!across(polygon, y, ends)) continue;
    const double x = std::min(ends.y(), face.x(y, height));
    if (x <= ends.x()) continue;
    front.emplace_back(x, y);
    rear.emplace_back(ends.x(), y);
  }
  front.insert(front.end(), rear.rbegin(), rear.rend());
  return front.size() < 4 ? std::vector<Vec2>{} : front;
}

}  // namespace

std::vector<HolePolygon> hole_polygons(const std::vector<PatternHole>& holes,
                                       const BenchPlanes& planes, const PlanCut& cut) {
  const bool by_x = planes.frames == nullptr;
  std::vector<HolePolygon> polygons;
  for (size_t h = 0; h < holes.size(); ++h) {
    std::vector<HalfPlane> sides;
    add_bisectors(sides, holes, h, cut.height);
    if (by_x)
      add_bench(sides, planes, cut);
    else
      add_frame(sides, *planes.frames, holes[h].name, cut);
    std::vector<Vec2> corners{
        cut.low, {cut.high.x(), cut.low.y()}, cut.high, {cut.low.x(), cut.high.y()}};
    for (const HalfPlane& side : sides) corners = clipped(corners, side);
    if (by_x && planes.face != nullptr) corners = behind_face(corners, *planes.face, cut.height);
    polygons.push_back({holes[h].name, std::move(corners)});
  }
  return polygons;
}

}  // namespace muckpile
