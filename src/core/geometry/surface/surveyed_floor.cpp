// SPDX-License-Identifier: GPL-2.0-or-later
// Surveyed ground as a floor of panels.
// Scope: see the header.
#include "geometry/surface/surveyed_floor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "args/input_error.h"

namespace muckpile {
namespace {

constexpr double kUpright = 1e-6;  // of a triangle's area in plan: it covers no place
constexpr double kMostCells = 4e4;

double area_in_plan(const StlTriangle& t) { return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).z(); }

std::vector<StlTriangle> looking_up(const std::vector<StlTriangle>& triangles,
                                    const std::string& where) {
  std::vector<StlTriangle> found;
  std::ranges::copy_if(triangles, std::back_inserter(found), [](const StlTriangle& t) {
    return area_in_plan(t) > kUpright * 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
  });
  if (found.empty()) refuse(where, "must have ground that looks up, on more than one line in plan");
  return found;
}

std::vector<StlTriangle> laid_flat(std::vector<StlTriangle> triangles) {
  for (StlTriangle& triangle : triangles)
    for (Vec3& corner : triangle) corner.z() = 0.0;
  return triangles;
}

/// From `from` towards `to`, both left out: steps that grow from `step` on, the last one not short.
std::vector<double> growing(double from, double to, double step) {
  constexpr double kGrowth = 1.5;
  std::vector<double> lines;
  const double way = std::abs(to - from), sign = to < from ? -1.0 : 1.0;
  for (double at = kGrowth * step, next = at; at + 0.5 * next < way;) {
    lines.push_back(from + sign * at);
    next *= kGrowth;
    at += next;
  }
  return lines;
}

/// Borders of panels from `lo` to `hi`: even between `dense_lo` and `dense_hi`, wider beyond.
std::vector<double> borders(double lo, double hi, double dense_lo, double dense_hi, double cell) {
  const double from = std::clamp(dense_lo, lo, hi), to = std::clamp(dense_hi, lo, hi);
  std::vector<double> lines = growing(from, lo, cell);
  std::ranges::reverse(lines);
  if (from > lo) lines.insert(lines.begin(), lo);
  const int count = std::max(1, static_cast<int>(std::ceil((to - from) / cell - 1e-9)));
  for (int k = 0; k <= count; ++k)
    if (k == 0 || to > from) lines.push_back(k < count ? from + k * (to - from) / count : to);
  const std::vector<double> beyond = growing(to, hi, cell);
  lines.insert(lines.end(), beyond.begin(), beyond.end());
  if (hi > to) lines.push_back(hi);
  return lines;
}

void add_panel(std::vector<StlTriangle>& triangles, const Vec3& a, const Vec3& b, const Vec3& c,
               const Vec3& d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

double overlap(double lo, double hi, double a, double b) {
  return std::max(0.0, std::min(hi, b) - std::max(lo, a));
}

}  // namespace

GroundHeights::GroundHeights(const std::vector<StlTriangle>& triangles, const std::string& where)
    : triangles_(looking_up(triangles, where)), plan_(laid_flat(triangles_)) {}

double GroundHeights::at(double x, double y) const {
  const SurfaceIndex::Closest place = plan_.closest({x, y, 0.0});
  const StlTriangle& t = triangles_[place.triangle];
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]), way = place.point - t[0];
  return t[0].z() - (normal.x() * way.x() + normal.y() * way.y()) / normal.z();
}

bool GroundHeights::covers(double x, double y) const {
  constexpr double kBorder = 1e-9;  // [m]
  return plan_.closest({x, y, 0.0}).distance <= kBorder;
}

double panel_width(const GroundHeights& ground, const FloorExtent& extent) {
  const Vec3 &lo = ground.lo(), &hi = ground.hi();
  const double surveyed = overlap(extent.x_lo, extent.x_hi, lo.x(), hi.x()) *
                          overlap(extent.y_lo, extent.y_hi, lo.y(), hi.y());
  return std::max(extent.cell, std::sqrt(surveyed / kMostCells));
}

SurveyedFloor surveyed_floor(const GroundHeights& ground, FloorExtent extent) {
  const Vec3 &lo = ground.lo(), &hi = ground.hi();
  const double width = panel_width(ground, extent);
  const std::vector<double> x = borders(extent.x_lo, extent.x_hi, lo.x(), hi.x(), width),
                            y = borders(extent.y_lo, extent.y_hi, lo.y(), hi.y(), width);
  SurveyedFloor floor{{}, {}, HUGE_VAL, -HUGE_VAL, width};
  std::vector<std::vector<Vec3>> corner(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (const double at : y) {
      corner[i].emplace_back(x[i], at, ground.at(x[i], at));
      floor.lowest = std::min(floor.lowest, corner[i].back().z());
      floor.highest = std::max(floor.highest, corner[i].back().z());
    }
  }
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      add_panel(floor.triangles, corner[i][j], corner[i + 1][j], corner[i + 1][j + 1],
                corner[i][j + 1]);
  floor.edge = std::move(corner.front());
  return floor;
}

void add_wall(std::vector<StlTriangle>& triangles, const Vec3& a, const Vec3& b, double foot) {
  constexpr double kFlat = 1e-9;  // of the edge's length: a lower wall is none
  const double flat = kFlat * (b - a).norm(), at_a = a.z() - foot, at_b = b.z() - foot;
  const bool rises_a = std::abs(at_a) > flat, rises_b = std::abs(at_b) > flat;
  if (rises_a && rises_b && at_a * at_b < 0.0) {
    Vec3 level = a + at_a / (at_a - at_b) * (b - a);
    level.z() = foot;
    add_wall(triangles, a, level, foot);
    return add_wall(triangles, level, b, foot);
  }
  const Vec3 under_a(a.x(), a.y(), foot), under_b(b.x(), b.y(), foot);
  if (rises_a) triangles.push_back({b, a, under_a});
  if (rises_b) triangles.push_back({b, under_a, under_b});
}

}  // namespace muckpile
