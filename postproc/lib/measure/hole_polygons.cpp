// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons of rock of holes.
// Scope: see the header.
#include "measure/hole_polygons.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "measure/outlines.h"

namespace muckpile {
namespace {

std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const HalfPlane& side) {
  std::vector<Vec2> kept;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double here = side.beyond(a), there = side.beyond(b);
    if (here <= 0.0) kept.push_back(a);
    if (here * there < 0.0) kept.push_back(a + here / (here - there) * (b - a));
  }
  return kept.size() < 3 ? std::vector<Vec2>{} : kept;
}

// A row as it is at one height: its holes' places, by y, how far along y each breaks the rock, and
// the borders between them.
struct RowCut {
  std::vector<Vec2> axes;
  std::vector<double> from, to;  // [m]
  std::vector<double> borders;   // one less [m]
  [[nodiscard]] size_t beside(double y) const {
    return static_cast<size_t>(std::ranges::upper_bound(borders, y) - borders.begin());
  }
  [[nodiscard]] bool reaches(double y) const { return y >= from[beside(y)] && y <= to[beside(y)]; }
};

void set_reach(RowCut& row, double spacing) {
  for (size_t k = 0; k < row.axes.size(); ++k) {
    const auto half_way = [&](size_t other) {
      const bool neighbour =
          other < row.axes.size() &&
          std::abs(row.axes[other].y() - row.axes[k].y()) <= kNeighbours * spacing;
      return neighbour ? std::abs(row.axes[other].y() - row.axes[k].y()) / 2 : 0.5 * spacing;
    };
    row.from.push_back(row.axes[k].y() - half_way(k - 1));
    row.to.push_back(row.axes[k].y() + half_way(k + 1));
  }
}

std::vector<RowCut> rows_at(const std::vector<PatternHole>& holes, double height, double spacing) {
  std::vector<RowCut> rows;
  for (size_t first = 0; first < holes.size(); first = end_of_row(holes, first)) {
    RowCut row;
    for (size_t h = first; h < end_of_row(holes, first); ++h) {
      row.axes.push_back(axis_at(holes[h], height));
      const size_t k = row.axes.size();
      if (k > 1) row.borders.push_back(0.5 * (row.axes[k - 2].y() + row.axes[k - 1].y()));
    }
    set_reach(row, spacing);
    rows.push_back(std::move(row));
  }
  return rows;
}

// Where rock of row `r` ends in front, before a piece of the width within which nothing turns:
// rows in front bound what they reach, and each row what none reaches.
double front_at(const std::vector<RowCut>& rows, size_t r, double y) {
  double front = HUGE_VAL;
  const bool own = rows[r].reaches(y);
  for (size_t q = 0; q < rows.size(); ++q) {
    const bool bounds = rows[q].reaches(y) ? q < r || !own : q < r && !own;
    if (bounds) front = std::min(front, rows[q].axes[rows[q].beside(y)].x());
  }
  return front;
}

// Where its front may turn, rising, both ends included.
std::vector<double> turns_between(const std::vector<RowCut>& rows, double low, double high,
                                  bool curved_face) {
  constexpr int kPieces = 24;
  std::vector<double> turns{low, high};
  for (const RowCut& row : rows) {
    for (const auto* places : {&row.borders, &row.from, &row.to})
      std::ranges::copy_if(*places, std::back_inserter(turns),
                           [&](double y) { return y > low && y < high; });
  }
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
  const std::vector<double> turns = turns_between(rows, low, high, planes.face != nullptr);
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

// Rock that a hole claims; what lies in a strip is not shared out among neighbours.
struct Claim {
  size_t hole;
  bool strip;
  Polygon region;                // whole
  std::vector<HalfPlane> faces;  // in front of it
};

template <class Sides>
Polygon clipped_by(Polygon polygon, const Sides& sides) {
  for (const HalfPlane& side : sides) polygon = clipped(polygon, side);
  return polygon;
}

HalfPlane face_of(const HoleFrames& frames, size_t hole, double height) {
  return {frames.holes()[hole].direction, frames.face_at(hole, height)};
}

// Nearer to a hole than to another.
HalfPlane nearer_to(const HoleFrames& frames, size_t hole, size_t other, double height) {
  const Vec2 axis = frames.axis_at(hole, height), way = frames.axis_at(other, height) - axis;
  return {way, way.dot(axis + 0.5 * way)};
}

std::vector<Claim> claims_of(const HoleFrames& frames, const PlanCut& cut) {
  const Polygon rock{cut.low, {cut.high.x(), cut.low.y()}, cut.high, {cut.low.x(), cut.high.y()}};
  const double height = cut.height;
  std::vector<Claim> claims;
  for (size_t h = 0; h < frames.holes().size(); ++h)
    claims.push_back(
        {h, true, clipped_by(rock, frames.strip(h, height)), {face_of(frames, h, height)}});
  for (const HolePair& pair : frames.pairs()) {
    const Polygon between = clipped_by(rock, frames.between(pair, height));
    const std::vector<HalfPlane> faces{face_of(frames, pair.left, height),
                                       face_of(frames, pair.right, height)};
    for (const auto& [own, other] : {std::pair(pair.left, pair.right), {pair.right, pair.left}})
      claims.push_back(
          {own, false, clipped(between, nearer_to(frames, own, other, height)), faces});
  }
  std::erase_if(claims, [](const Claim& claim) { return claim.region.empty(); });
  return claims;
}

// What another claim takes away from one.
Polygon taken_by(const std::vector<Claim>& claims, size_t other, size_t own,
                 const HoleFrames& frames, double height) {
  const Claim &theirs = claims[other], &ours = claims[own];
  if (theirs.strip != ours.strip) return theirs.strip ? theirs.region : Polygon{};
  if (theirs.hole == ours.hole) return other < own ? theirs.region : Polygon{};
  return clipped(theirs.region, nearer_to(frames, theirs.hole, ours.hole, height));
}

std::vector<Polygon> pieces_of(const std::vector<Claim>& claims, size_t own,
                               const HoleFrames& frames, double height) {
  constexpr double kNone = 1e-9;  // [m2]
  std::vector<Polygon> pieces{clipped_by(claims[own].region, claims[own].faces)};
  for (size_t other = 0; other < claims.size(); ++other) {
    if (other == own) continue;
    const Polygon taken = taken_by(claims, other, own, frames, height);
    if (taken.empty()) continue;
    std::vector<Polygon> left;
    for (const Polygon& piece : pieces) {
      if (area_of(overlap(piece, taken)) < kNone)
        left.push_back(piece);
      else
        std::ranges::copy(without(piece, taken), std::back_inserter(left));
    }
    pieces = std::move(left);
  }
  return pieces;
}

std::vector<HolePolygon> burdens_by_frames(const HoleFrames& frames, const PlanCut& cut) {
  const std::vector<Claim> claims = claims_of(frames, cut);
  std::vector<HolePolygon> polygons;
  for (size_t h = 0; h < frames.holes().size(); ++h) {
    std::vector<Polygon> rock;
    for (size_t own = 0; own < claims.size(); ++own) {
      if (claims[own].hole == h)
        std::ranges::copy(pieces_of(claims, own, frames, cut.height), std::back_inserter(rock));
    }
    std::vector<Polygon> rings = outlines_of(rock);
    if (rings.empty()) rings.emplace_back();
    for (Polygon& ring : rings) polygons.push_back({frames.holes()[h].name, std::move(ring)});
  }
  return polygons;
}

}  // namespace

std::vector<HolePolygon> hole_polygons(const std::vector<PatternHole>& holes,
                                       const BenchPlanes& planes, const PlanCut& cut) {
  if (planes.frames != nullptr) return burdens_by_frames(*planes.frames, cut);
  const std::vector<RowCut> rows = rows_at(holes, cut.height, planes.spacing);
  std::vector<HolePolygon> polygons;
  for (size_t r = 0; r < rows.size(); ++r)
    for (size_t k = 0; k < rows[r].axes.size(); ++k)
      polygons.push_back({holes[polygons.size()].name, burden_along_x(rows, r, k, planes, cut)});
  return polygons;
}

}  // namespace muckpile
