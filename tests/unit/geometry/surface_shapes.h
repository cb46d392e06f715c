// SPDX-License-Identifier: GPL-2.0-or-later
// Closed surfaces and terrains as triangles, for tests.
// Scope: lengths in metres; triangles look outward.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/surface/rock_body.h"

namespace muckpile::test {

using Triangles = std::vector<StlTriangle>;

inline Triangles halved(const Triangles& coarse) {
  Triangles fine;
  for (const StlTriangle& t : coarse) {
    const Vec3 a = 0.5 * (t[0] + t[1]), b = 0.5 * (t[1] + t[2]), c = 0.5 * (t[2] + t[0]);
    for (const StlTriangle& part : {StlTriangle{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}})
      fine.push_back(part);
  }
  return fine;
}

inline Triangles closed_box(const Vec3& lo, const Vec3& hi) {
  const auto corner = [&](int k) {
    return Vec3((k & 1) != 0 ? hi.x() : lo.x(), (k & 2) != 0 ? hi.y() : lo.y(),
                (k & 4) != 0 ? hi.z() : lo.z());
  };
  Triangles triangles;
  for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{
           {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
    triangles.push_back({corner(a), corner(b), corner(c)});
    triangles.push_back({corner(a), corner(c), corner(d)});
  }
  return triangles;
}

template <class Map>
Triangles mapped(Triangles triangles, const Map& map) {
  for (StlTriangle& t : triangles)
    for (Vec3& corner : t) corner = map(corner);
  return triangles;
}

/// A ball, each face of a cube divided by 4^rounds.
inline Triangles ball(double radius, int rounds) {
  Triangles triangles = closed_box(Vec3::Constant(-1.0), Vec3::Constant(1.0));
  for (int k = 0; k < rounds; ++k) triangles = halved(triangles);
  return mapped(triangles, [&](const Vec3& p) { return Vec3(radius * p.normalized()); });
}

/// Heights over a grid of squares, two triangles each.
inline Triangles heights(const Vec3& lo, const Vec3& hi, int cells,
                         const std::function<double(double, double)>& height) {
  const auto at = [&](int i, int j) {
    const double x = lo.x() + (hi.x() - lo.x()) * i / cells;
    const double y = lo.y() + (hi.y() - lo.y()) * j / cells;
    return Vec3(x, y, height(x, y));
  };
  Triangles triangles;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return triangles;
}

inline RockSurface surface_of(Triangles triangles, SurfaceIs kind = SurfaceIs::body) {
  return {"test", kind, std::make_shared<const SurfaceIndex>(std::move(triangles))};
}

}  // namespace muckpile::test
