// SPDX-License-Identifier: GPL-2.0-or-later
// Rock bounded by surfaces from files.
// Scope: see the header.
#include "geometry/surface/rock_body.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "geometry/surface/delaunay.h"
#include "geometry/surface/surface_planes.h"

namespace muckpile {
namespace {

/// Whether the rock's other surfaces leave a wall there: it may lie behind them by a little, where
/// two of them meet at an acute edge.
bool bounds_rock(const Vec3& seed, const Vec3& foot,
                 const std::function<bool(const Vec3&)>& in_others) {
  constexpr double kWay = 0.6;  // from the seed to the wall
  return in_others(seed + kWay * (foot - seed));
}

using Inside = std::function<bool(const Vec3& point)>;

std::vector<Vec3> kept(std::vector<Vec3> feet, const Vec3& seed, const Inside& in_others) {
  std::erase_if(feet, [&](const Vec3& foot) { return !bounds_rock(seed, foot, in_others); });
  return feet;
}

}  // namespace

Vec3 MineFrame::to_run(const Vec3& mine) const {
  const Vec3 from = mine - origin;
  const double s = std::sin(bearing), c = std::cos(bearing);
  return {s * from.x() + c * from.y(), -c * from.x() + s * from.y(), from.z()};
}

Vec3 MineFrame::to_mine(const Vec3& run) const {
  const double s = std::sin(bearing), c = std::cos(bearing);
  return origin + Vec3(s * run.x() - c * run.y(), c * run.x() + s * run.y(), run.z());
}

double RockSurface::height(const Vec3& point) const {
  const double distance = index->closest(point).distance;
  return inside(point) ? -distance : distance;
}

DoubledPlaces doubled_places(std::vector<Vec3> points, double apart) {
  std::ranges::sort(points, {}, [](const Vec3& p) { return std::tuple(p.x(), p.y(), p.z()); });
  DoubledPlaces found;
  for (auto first = points.begin(); first != points.end();) {
    const auto last = std::find_if(first, points.end(), [&](const Vec3& p) {
      return p.x() != first->x() || p.y() != first->y();
    });
    const double here = std::prev(last)->z() - first->z();
    if (here > apart) ++found.places;
    if (here > std::max(apart, found.apart)) found.apart = here, found.lowest = *first;
    first = last;
  }
  return found;
}

std::vector<StlTriangle> terrain_triangles(const SurveyedSurface& survey) {
  std::vector<StlTriangle> triangles = survey.triangles;
  std::vector<Vec2> plan;
  for (const Vec3& p : survey.points) plan.emplace_back(p.head<2>());
  for (const auto& [a, b, c] : delaunay(plan))
    triangles.push_back({survey.points[a], survey.points[b], survey.points[c]});
  for (StlTriangle& t : triangles)
    if ((t[1] - t[0]).cross(t[2] - t[0]).z() < 0.0) std::swap(t[1], t[2]);
  return triangles;
}

RegionQuery within(const RegionQuery& region, const std::vector<RockSurface>& surfaces) {
  RegionQuery rock;
  const Inside in_region = region.inside ? region.inside : Inside([](const Vec3&) { return true; });
  const auto in_all_but = [=](std::size_t which) {
    return Inside([=](const Vec3& p) {
      for (std::size_t s = 0; s < surfaces.size(); ++s)
        if (s != which && !surfaces[s].inside(p)) return false;
      return in_region(p);
    });
  };
  rock.inside = in_all_but(surfaces.size());
  rock.surface_points = [=](const Vec3& p, double cutoff) {
    if (!region.surface_points) return std::vector<Vec3>();
    return kept(region.surface_points(p, cutoff), p, [&](const Vec3& at) {
      return std::ranges::all_of(surfaces, [&](const RockSurface& s) { return s.inside(at); });
    });
  };
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const RockSurface& one = surfaces[s];
    rock.fitted.push_back({[one, others = in_all_but(s)](const Vec3& p, double cutoff) {
                             return kept(feet_on_planes(*one.index, p, cutoff), p, others);
                           },
                           [one](const Vec3& p) { return one.height(p); },
                           [one](const Vec3& p) { return one.index->closest(p).point; }});
  }
  return rock;
}

}  // namespace muckpile
