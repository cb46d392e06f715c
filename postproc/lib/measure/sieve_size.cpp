// SPDX-License-Identifier: GPL-2.0-or-later
// Sieve size of a piece.
// Scope: see the header.
#include "measure/sieve_size.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "measure/scan_polygon.h"

namespace muckpile {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Corners of the convex hull in order (Andrew's monotone chain).
std::vector<Vec2> hull_of(std::vector<Vec2> points) {
  std::ranges::sort(points, [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vec2> hull;
  for (int half = 0; half < 2; ++half) {
    const size_t first = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= first + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull[hull.size() - 2]) <= 0.0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the other half begins with it
    std::ranges::reverse(points);
  }
  return hull;
}

struct Width {
  double width = std::numeric_limits<double>::max();
  Vec3 along = Vec3::Zero();
};

// The least width at right angles to u: that of a polygon lies across one of its edges.
Width least_width_across(const std::vector<Vec3>& points, const Vec3& u) {
  const Vec3 e1 = u.unitOrthogonal(), e2 = u.cross(e1);
  std::vector<Vec2> flat;
  flat.reserve(points.size());
  for (const Vec3& p : points) flat.emplace_back(p.dot(e1), p.dot(e2));
  const std::vector<Vec2> hull = hull_of(std::move(flat));
  Width least;
  for (size_t k = 0; k < hull.size(); ++k) {
    const Vec2 edge = (hull[(k + 1) % hull.size()] - hull[k]).normalized();
    double width = 0.0;
    for (const Vec2& p : hull) {
      width = std::max(width, cross(edge, p - hull[k]));
      if (width >= least.width) break;
    }
    if (width < least.width) least = {width, -edge.y() * e1 + edge.x() * e2};
  }
  return least;
}

double width_along(const std::vector<Vec3>& points, const Vec3& u) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const Vec3& p : points) {
    low = std::min(low, p.dot(u));
    high = std::max(high, p.dot(u));
  }
  return high - low;
}

struct Opening {
  double side = std::numeric_limits<double>::max();
  Vec3 u = Vec3::UnitX(), v = Vec3::UnitY();
};

// With u for one of its directions. One that is not below `limit` may be left out: the default
// opening, which is larger than all.
Opening opening_at(const std::vector<Vec3>& points, const Vec3& u,
                   double limit = std::numeric_limits<double>::infinity()) {
  const double along = width_along(points, u);
  if (along >= limit) return {};
  const Width across = least_width_across(points, u);
  return {std::max(along, across.width), u, across.along};
}

// Tilts u by ever smaller angles while that makes the opening smaller.
Opening refined(const std::vector<Vec3>& points, Opening best) {
  constexpr int kRounds = 5;
  double tilt = 0.2;  // [rad]
  for (int round = 0; round < kRounds; ++round, tilt *= 0.5) {
    const Vec3 u = best.u, v = best.v, w = u.cross(v);
    for (const Vec3& towards : {v, Vec3(-v), w, Vec3(-w)}) {
      const Opening tried = opening_at(points, (u + tilt * towards).normalized(), best.side);
      if (tried.side < best.side) best = tried;
    }
  }
  return best;
}

}  // namespace

double sieve_size(const std::vector<Vec3>& points, const std::vector<Vec3>& starts) {
  Opening best;
  for (const Vec3& u : starts) {
    const Opening straight = opening_at(points, u);
    // A thin plate passes along the diagonal of the opening.
    if (straight.side < best.side) best = straight;
    const Opening diagonal = opening_at(points, (straight.u + straight.v).normalized(), best.side);
    if (diagonal.side < best.side) best = diagonal;
  }
  return refined(points, best).side;
}

double sieve_size(const StartBlock& block) {
  const Polyhedron shape = polyhedron_of(block.shape);
  std::vector<Vec3> normals;
  for (int face = 0; face < static_cast<int>(shape.faces.size()); ++face)
    normals.push_back(face_geometry(shape, face).normal);
  return sieve_size(shape.vertices, normals);
}

std::vector<Vec3> spread_directions(int count) {
  std::vector<Vec3> directions;
  const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));  // golden angle [rad]
  for (int k = 0; k < count; ++k) {
    const double z = (k + 0.5) / count, r = std::sqrt(1.0 - z * z);
    directions.emplace_back(r * std::cos(turn * k), r * std::sin(turn * k), z);
  }
  return directions;
}

std::vector<Vec3> outermost(const std::vector<Vec3>& points, int directions) {
  std::set<size_t> chosen;
  for (const Vec3& u : spread_directions(directions)) {
    const auto [low, high] =
        std::ranges::minmax_element(points, {}, [&](const Vec3& p) { return p.dot(u); });
    chosen.insert(static_cast<size_t>(low - points.begin()));
    chosen.insert(static_cast<size_t>(high - points.begin()));
  }
  std::vector<Vec3> outer;
  for (const size_t k : chosen) outer.push_back(points[k]);
  return outer;
}

}  // namespace muckpile
