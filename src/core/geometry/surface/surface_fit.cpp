// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks against the surfaces of their rock.
// Scope: see the header.
#include "geometry/surface/surface_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/shape/face_samples.h"

namespace muckpile {
namespace {

bool lies_on_box(const FaceGeometry& face, const Vec3& lo, const Vec3& hi, double size) {
  constexpr double kRounding = 1e-6;
  const Vec3 away = (face.centroid - lo).cwiseAbs().cwiseMin((face.centroid - hi).cwiseAbs());
  Eigen::Index axis = 0;
  const double nearest = away.minCoeff(&axis);
  return nearest < kRounding * size && std::abs(face.normal[axis]) > 1.0 - kRounding;
}

/// Of the rock that all surfaces bound: of one outside none, the depth below the nearest.
double height_of(const std::vector<RockSurface>& surfaces, const Vec3& p) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const RockSurface& surface : surfaces) highest = std::max(highest, surface.height(p));
  return highest;
}

}  // namespace

SurfaceFit surface_fit(const std::vector<Block>& blocks, const std::vector<RockSurface>& surfaces,
                       const Vec3& lo, const Vec3& hi) {
  SurfaceFit fit;
  for (const Block& block : blocks) {
    const double size = std::cbrt(block.mass.volume);
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] != kFreeFace) continue;
      if (lies_on_box(face_geometry(block.shape, static_cast<int>(f)), lo, hi, size)) continue;
      sample_face(block.shape, f, [&](const Vec3& at, double area) {
        const double off = height_of(surfaces, at) / size;
        fit.area += area;
        fit.mean_offset += area * off;
        fit.mean_distance += area * std::abs(off);
        fit.largest_distance = std::max(fit.largest_distance, std::abs(off));
        fit.within_a_quarter += std::abs(off) <= 0.25 ? area : 0.0;
      });
    }
  }
  if (!(fit.area > 0.0)) return fit;
  for (double* mean : {&fit.mean_offset, &fit.mean_distance, &fit.within_a_quarter})
    *mean /= fit.area;
  return fit;
}

double rock_volume(const std::vector<RockSurface>& surfaces, const RegionQuery& region,
                   const Vec3& lo, const Vec3& hi, int columns) {
  constexpr int kPieces = 32;  // of what a region is asked in
  const double dx = (hi.x() - lo.x()) / columns, dy = (hi.y() - lo.y()) / columns;
  double height = 0.0;
  std::vector<double> ends;
  std::vector<SurfaceIndex::Crossing> met;
  for (int k = 0; k < columns * columns; ++k) {
    const double x = lo.x() + (k % columns + 0.5) * dx, y = lo.y() + (k / columns + 0.5) * dy;
    ends = {lo.z(), hi.z()};
    for (const RockSurface& surface : surfaces) {
      surface.index->crossings_at(x, y, met);
      for (const auto& crossing : met)
        if (crossing.height > lo.z() && crossing.height < hi.z()) ends.push_back(crossing.height);
    }
    std::ranges::sort(ends);
    for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
      const Vec3 middle(x, y, 0.5 * (ends[e] + ends[e + 1]));
      if (!std::ranges::all_of(surfaces, [&](const auto& s) { return s.inside(middle); })) continue;
      const double step = (ends[e + 1] - ends[e]) / kPieces;
      for (int piece = 0; piece < kPieces; ++piece) {
        const Vec3 at(x, y, ends[e] + (piece + 0.5) * step);
        if (!region.inside || region.inside(at)) height += step;
      }
    }
  }
  return height * dx * dy;
}

}  // namespace muckpile
