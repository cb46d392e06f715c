// SPDX-License-Identifier: GPL-2.0-or-later
// Two surfaces over one grid of columns: volumes between them, vertical differences, mean profiles.
// Scope: see the header.
#include "measure/surface_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/surface/surface_index.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

std::vector<double> differences(const SurfacePair& pair) {
  std::vector<double> all;
  for (size_t k = 0; k < pair.grid.cells(); ++k)
    if (pair.compared[k] != 0) all.push_back(pair.run[k] - pair.survey[k]);
  return all;
}

// Means of both over the rows abreast, where half of these are known; false where fewer are.
bool means_at(const SurfacePair& pair, int i, const BenchPlanes& planes, Vec2& means) {
  int known = 0, rows = 0;
  means = Vec2::Zero();
  for (int j = 0; j < pair.grid.ny; ++j) {
    if (!planes.abreast({pair.grid.x(i), pair.grid.y(j), 0.0})) continue;
    ++rows;
    const Vec2 heights(pair.run[pair.grid.at(i, j)], pair.survey[pair.grid.at(i, j)]);
    if (heights.hasNaN()) continue;
    ++known;
    means += heights;
  }
  means /= std::max(known, 1);
  return rows > 0 && 2 * known >= rows;
}

double at_share(std::vector<double> sizes, double share) {
  const auto place = sizes.begin() + std::lround(share * static_cast<double>(sizes.size() - 1));
  std::ranges::nth_element(sizes, place);
  return *place;
}

// Two between four neighbouring cells whose heights are known.
std::vector<StlTriangle> triangles_of(const ColumnGrid& grid, const std::vector<double>& heights) {
  const auto point = [&](int i, int j) {
    return Vec3(grid.x(i), grid.y(j), heights[grid.at(i, j)]);
  };
  std::vector<StlTriangle> triangles;
  for (int j = 0; j + 1 < grid.ny; ++j) {
    for (int i = 0; i + 1 < grid.nx; ++i) {
      const Vec3 a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
      if (!std::isnan(a.z() + b.z() + c.z())) triangles.push_back({a, b, c});
      if (!std::isnan(a.z() + c.z() + d.z())) triangles.push_back({a, c, d});
    }
  }
  return triangles;
}

}  // namespace

double difference_at_share(const SurfacePair& pair, double share) {
  std::vector<double> sizes = differences(pair);
  for (double& each : sizes) each = std::abs(each);
  return at_share(std::move(sizes), share);
}

SurfaceDistance distance_of(const SurfacePair& pair) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::vector<StlTriangle> triangles = triangles_of(pair.grid, pair.run);
  std::vector<Vec3> points;
  for (size_t k = 0; k < pair.grid.cells(); ++k) {
    const auto row = static_cast<size_t>(pair.grid.nx);
    if (pair.compared[k] != 0)
      points.emplace_back(pair.grid.x(static_cast<int>(k % row)),
                          pair.grid.y(static_cast<int>(k / row)), pair.survey[k]);
  }
  if (triangles.empty() || points.empty()) return {kNaN, kNaN, kNaN};
  const SurfaceIndex surface(std::move(triangles));
  std::vector<double> distances(points.size());
  each_in_parallel(points.size(),
                   [&](size_t k) { distances[k] = surface.closest(points[k]).distance; });
  SurfaceDistance result{0.0, 0.0, 0.0};
  const auto count = static_cast<double>(distances.size());
  for (const double each : distances) {
    result.mean += each / count;
    result.rms += each * each / count;
  }
  result.rms = std::sqrt(result.rms);
  result.p90 = at_share(std::move(distances), 0.9);
  return result;
}

SurfaceDifference difference_of(const SurfacePair& pair) {
  const double cell = pair.grid.dx * pair.grid.dy;
  const std::vector<double> all = differences(pair);
  const auto count = static_cast<double>(all.size());
  SurfaceDifference result;
  for (const double each : all) {
    (each > 0.0 ? result.above : result.below) += std::abs(each) * cell;
    result.mean += each / count;
    result.rms += each * each / count;
  }
  result.area = count * cell;
  result.rms = std::sqrt(result.rms);
  result.p90 = difference_at_share(pair, 0.9);
  return result;
}

ProfilePair profiles_of(const SurfacePair& pair, const BenchPlanes& planes) {
  ProfilePair profiles;
  profiles.dx = pair.grid.dx;
  size_t known = 0;  // up to the last x that is
  for (int i = 0; i < pair.grid.nx; ++i) {
    Vec2 means;
    const bool enough = means_at(pair, i, planes, means);
    if (!enough && known == 0) continue;
    if (!enough) means = {profiles.run[known - 1], profiles.survey[known - 1]};
    profiles.x.push_back(pair.grid.x(i));
    profiles.run.push_back(means.x());
    profiles.survey.push_back(means.y());
    if (enough) known = profiles.x.size();
  }
  for (std::vector<double>* each : {&profiles.x, &profiles.run, &profiles.survey})
    each->resize(known);
  return profiles;
}

PileShape shape_of_profile(const std::vector<double>& x, const std::vector<double>& heights,
                           double dx, double depth, double block_size) {
  if (x.empty()) return PileShape::none();
  PileProfile profile{};
  profile.x = x;
  profile.pile = heights;
  profile.pile_length.assign(x.size(), 0.0);
  profile.dx = dx;
  PileShape shape = pile_shape(profile, depth, block_size);
  if (heights.back() >= block_size) shape.toe = std::numeric_limits<double>::quiet_NaN();
  return shape;
}

}  // namespace muckpile
