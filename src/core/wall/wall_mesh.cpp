// SPDX-License-Identifier: GPL-2.0-or-later
// Touches of spheres and triangles.
// Scope: see the header.
#include "wall/wall_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace muckpile {
namespace {

constexpr double kSlack = 1e-6;  // of the radius: points as near as that are one
constexpr double kAlong = 1e4;   // slacks, a hundredth of the radius: where along an edge is looked

}  // namespace

double WallMesh::distance(const Vec3& place, double reach, std::vector<std::size_t>& parts) const {
  double least = std::numeric_limits<double>::infinity();
  parts.clear();
  const Vec3 outside = (index_.lo() - place).cwiseMax(place - index_.hi());
  if (outside.maxCoeff() > reach) return least;
  index_.near(place, reach, parts);
  for (const std::size_t number : parts)
    least = std::min(least, (closest_on(index_.triangles()[number], place).at - place).norm());
  return least;
}

/// A point on an edge or corner is no touch if it belongs to another triangle that comes nearer.
/// Hits before k are as near or nearer.
bool WallMesh::is_nearest_around(std::span<const Hit> hits, std::size_t k, double slack) const {
  if (hits[k].point.on == TrianglePoint::On::face) return true;
  const Vec3& at = hits[k].point.at;
  return std::ranges::none_of(hits.first(k), [&](const Hit& nearer) {
    return (closest_on(index_.triangles()[nearer.triangle], at).at - at).norm() <= slack;
  });
}

/// Whether the surface ends at an edge: no other triangle has it too, nor lies along it, as a large
/// one does where a corner of smaller ones is on its edge.
bool WallMesh::ends_at(const RimEdge& edge, const Vec3& at, std::span<const Hit> hits,
                       std::span<const RimEdge> rim, double slack) const {
  const auto is_same = [&](const RimEdge& e) { return (e.end - edge.end).norm() <= slack; };
  if (std::ranges::count_if(rim, is_same) > 1) return false;
  const Vec3 way = edge.end - at;
  const Vec3 along = at + std::min(0.5, kAlong * slack / way.norm()) * way;
  return std::ranges::none_of(hits, [&](const Hit& other) {
    if (other.triangle == edge.triangle) return false;
    return (closest_on(index_.triangles()[other.triangle], along).at - along).norm() <= slack;
  });
}

/// Mean of the normals around a touch by their angles there: it tells the front from the back
/// (Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243).
WallMesh::Place WallMesh::place_of(std::span<const Hit> hits, const Hit& hit, double slack) const {
  if (hit.point.on == TrianglePoint::On::face) return {index_.unit_normal(hit.triangle)};
  Place place;
  std::vector<RimEdge> rim;
  int triangles = 0;
  for (const Hit& other : hits) {
    if ((other.point.at - hit.point.at).norm() > 2.0 * slack) continue;
    const StlTriangle& triangle = index_.triangles()[other.triangle];
    place.outward += angle_around(triangle, other.point) * index_.unit_normal(other.triangle);
    ++triangles;
    if (hit.point.on != TrianglePoint::On::corner) continue;
    if (other.point.on != TrianglePoint::On::corner) continue;
    for (const std::size_t step : {1, 2})
      rim.push_back({other.triangle, triangle[(other.point.corner + step) % 3]});
  }
  place.border = triangles < 2 || std::ranges::any_of(rim, [&](const RimEdge& edge) {
                   return ends_at(edge, hit.point.at, hits, rim, slack);
                 });
  return place;
}

void WallMesh::find_touches(const Vec3& centre, double radius, std::span<const std::size_t> parts,
                            WallTouches& touches) const {
  touches.clear();
  thread_local std::vector<Hit> hits;
  hits.clear();
  for (const std::size_t number : parts) {
    const TrianglePoint point = closest_on(index_.triangles()[number], centre);
    const double squared = (centre - point.at).squaredNorm();
    if (squared < radius * radius) hits.push_back({std::sqrt(squared), number, point});
  }
  if (hits.empty()) return;
  if (hits.size() == 1 && hits[0].point.on == TrianglePoint::On::face) {
    const Vec3& normal = index_.unit_normal(hits[0].triangle);
    touches.add({normal, radius - normal.dot(centre - hits[0].point.at)});
    return;
  }
  sift(hits, centre, radius, touches);
}

/// Leaves those hits that are touches.
void WallMesh::sift(std::vector<Hit>& hits, const Vec3& centre, double radius,
                    WallTouches& touches) const {
  const double slack = kSlack * radius;
  for (Hit& hit : hits)  // neighbours must agree on what is an edge or a corner
    hit.point = snapped(index_.triangles()[hit.triangle], hit.point.at, slack);
  std::ranges::sort(hits, {}, [](const Hit& h) { return std::pair(h.distance, h.triangle); });
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const Hit& hit = hits[k];
    if (!is_nearest_around(hits, k, slack)) continue;
    const Place place = place_of(hits, hit, slack);
    const Vec3 away = centre - hit.point.at;
    const bool behind = !place.border && away.dot(place.outward) < 0.0;
    if (behind && !touches.all().empty()) continue;  // seen through the ground
    const double side = behind ? -1.0 : 1.0;
    const bool on_face = hit.point.on == TrianglePoint::On::face || hit.distance <= slack;
    const Vec3 normal = on_face ? place.outward : Vec3(side * away);
    touches.add({normal.normalized(), radius - side * hit.distance});
    if (behind) return;  // the nearest point is the way out
  }
}

double WallMesh::depth(const Vec3& place) const {
  const SurfaceIndex::Closest closest = index_.closest(place);
  if (closest.distance == 0.0) return 0.0;
  const double slack = kSlack * closest.distance;
  std::vector<std::size_t> around;
  index_.near(closest.point, 2.0 * kAlong * slack, around);
  std::vector<Hit> hits;
  std::size_t nearest = 0;
  for (const std::size_t number : around) {
    const StlTriangle& triangle = index_.triangles()[number];
    const Vec3 at = closest_on(triangle, place).at;
    if (number == closest.triangle) nearest = hits.size();
    hits.push_back({(place - at).norm(), number, snapped(triangle, at, slack)});
  }
  const Place there = place_of(hits, hits[nearest], slack);
  const bool behind = !there.border && (place - closest.point).dot(there.outward) < 0.0;
  return behind ? closest.distance : 0.0;
}

}  // namespace muckpile
