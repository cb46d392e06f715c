// SPDX-License-Identifier: GPL-2.0-or-later
// A surveyed surface in the coordinates of a run, and its heights over a grid of columns.
// Scope: see the header.
#include "measure/survey_heights.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "measure/contours.h"
#include "measure/scan_polygon.h"

namespace muckpile {
namespace {

constexpr double kMargin = 8.0;  // cells around the grid whose points count, too
constexpr double kGapOverSpacing = 5.0;

// The highest triangle above each cell's middle.
class HeightRaster {
 public:
  explicit HeightRaster(const ColumnGrid& grid)
      : grid_(grid), heights_(grid.cells(), std::numeric_limits<double>::quiet_NaN()) {}

  void add(const StlTriangle& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    if (std::abs(normal.z()) <= kUpright * normal.norm()) return;
    const double bottom = std::min({t[0].z(), t[1].z(), t[2].z()});
    const double top = std::max({t[0].z(), t[1].z(), t[2].z()});
    std::array<Vec2, 3> outline;
    for (size_t k = 0; k < 3; ++k)
      outline.at(k) = {(t.at(k).x() - grid_.x0) / grid_.dx, (t.at(k).y() - grid_.y0) / grid_.dy};
    const Vec2 slope = -normal.head<2>() / normal.z();
    scan_polygon(outline, grid_.nx, grid_.ny, crossings_, [&](int j, int begin, int end) {
      for (int i = begin; i < end; ++i) {
        const Vec2 from(grid_.x(i) - t[0].x(), grid_.y(j) - t[0].y());
        double& height = heights_[grid_.at(i, j)];
        // Of a steep one rounding in plan is large in height.
        height = std::fmax(height, std::clamp(t[0].z() + slope.dot(from), bottom, top));
      }
    });
  }

  std::vector<double> take() { return std::move(heights_); }

 private:
  const ColumnGrid& grid_;
  std::vector<double> heights_;
  std::vector<double> crossings_;
};

// Those over the grid and a margin around it [m].
std::vector<Vec3> points_near(const ColumnGrid& grid, const std::vector<Vec3>& points,
                              double margin) {
  const double x_high = grid.x0 + grid.nx * grid.dx, y_high = grid.y0 + grid.ny * grid.dy;
  std::vector<Vec3> near;
  for (const Vec3& p : points) {
    if (p.x() < grid.x0 - margin || p.x() > x_high + margin) continue;
    if (p.y() < grid.y0 - margin || p.y() > y_high + margin) continue;
    near.push_back(p);
  }
  return near;
}

// The mean of the points of each cell.
std::vector<Vec3> thinned(const ColumnGrid& grid, const std::vector<Vec3>& points) {
  std::map<std::pair<long, long>, std::pair<Vec3, int>> sums;
  for (const Vec3& p : points) {
    const double i = (p.x() - grid.x0) / grid.dx, j = (p.y() - grid.y0) / grid.dy;
    const auto cell = std::pair(std::lround(std::floor(j)), std::lround(std::floor(i)));
    auto& [sum, count] = sums.try_emplace(cell, Vec3::Zero(), 0).first->second;
    sum += p;
    ++count;
  }
  std::vector<Vec3> means;
  for (const auto& [cell, of] : sums) means.emplace_back(of.first / of.second);
  return means;
}

// Mean distance of neighbours of points that cover their box in plan evenly [m]; 0 of none.
double spacing_of(const std::vector<Vec3>& points) {
  if (points.empty()) return 0.0;
  Vec3 low = points.front(), high = points.front();
  for (const Vec3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Vec2 size = (high - low).head<2>();
  return std::sqrt(size.x() * size.y() / static_cast<double>(points.size()));
}

std::vector<StlTriangle> joined_to_triangles(const std::vector<Vec3>& points, double gap) {
  std::vector<Vec2> plan;
  for (const Vec3& p : points) plan.emplace_back(p.head<2>());
  std::vector<StlTriangle> triangles;
  for (const Triangle& t : triangulate(plan)) {
    double longest = 0.0;
    for (size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (plan[t.at(k)] - plan[t.at((k + 1) % 3)]).norm());
    if (longest <= gap) triangles.push_back({points[t[0]], points[t[1]], points[t[2]]});
  }
  return triangles;
}

// Calls use(point) for each point and corner.
template <class Use>
void each_place(const SurveyedSurface& surface, Use&& use) {
  for (const Vec3& point : surface.points) use(point);
  for (const StlTriangle& triangle : surface.triangles)
    for (const Vec3& corner : triangle) use(corner);
}

}  // namespace

SurveyedSurface placed(SurveyedSurface surface, const SurveyPose& pose) {
  for (Vec3& point : surface.points) point = pose.of(point);
  for (StlTriangle& triangle : surface.triangles)
    for (Vec3& corner : triangle) corner = pose.of(corner);
  return surface;
}

Extent extent_of(const SurveyedSurface& surface) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Extent extent{Vec3::Constant(kFar), Vec3::Constant(-kFar)};
  each_place(surface, [&](const Vec3& p) {
    extent.low = extent.low.cwiseMin(p);
    extent.high = extent.high.cwiseMax(p);
  });
  return extent;
}

bool has_height_between(const SurveyedSurface& surface, double low, double high) {
  bool any = false;
  each_place(surface, [&](const Vec3& p) { any = any || (p.z() >= low && p.z() <= high); });
  return any;
}

Extent extent_of_most(const SurveyedSurface& surface, double farthest) {
  Extent extent = extent_of(surface);
  if (extent.high.z() - extent.low.z() <= farthest) return extent;
  std::vector<double> heights;
  each_place(surface, [&](const Vec3& p) { heights.push_back(p.z()); });
  std::ranges::sort(heights);
  heights.erase(std::ranges::unique(heights).begin(), heights.end());
  const double middle = heights[heights.size() / 2];
  extent.low.z() = *std::ranges::lower_bound(heights, middle - farthest);
  extent.high.z() = *std::prev(std::ranges::upper_bound(heights, middle + farthest));
  return extent;
}

std::vector<double> heights_over(const ColumnGrid& grid, const SurveyedSurface& surface,
                                 std::optional<double> gap) {
  HeightRaster raster(grid);
  for (const StlTriangle& triangle : surface.triangles) raster.add(triangle);
  if (surface.points.empty()) return raster.take();
  const double margin = kMargin * std::max(grid.dx, grid.dy);
  // A point that strays far off would make the spacing of all too wide.
  const double spacing = spacing_of(points_near(grid, surface.points, margin));
  const double reach = gap.value_or(kGapOverSpacing * std::max(spacing, grid.dx));
  const std::vector<Vec3> few =
      thinned(grid, points_near(grid, surface.points, std::max(reach, margin)));
  for (const StlTriangle& triangle : joined_to_triangles(few, reach)) raster.add(triangle);
  return raster.take();
}

}  // namespace muckpile
