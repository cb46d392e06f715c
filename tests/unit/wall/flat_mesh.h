// SPDX-License-Identifier: GPL-2.0-or-later
// Meshes for tests of walls: a flat floor of uneven triangles, and panels.
// Scope: walls of a test.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "geometry/files/stl_file.h"

namespace muckpile::test {

/// Two triangles between four corners that turn anticlockwise seen from the front.
inline void add_panel(std::vector<StlTriangle>& mesh, const Vec3& a, const Vec3& b, const Vec3& c,
                      const Vec3& d) {
  mesh.push_back({a, b, c});
  mesh.push_back({a, c, d});
}

/// The square |x|, |y| <= half of the plane z = 0 [m], in cells x cells panels whose inner corners
/// are shifted by up to 0.2 of a cell, with every other diagonal turned.
inline std::vector<StlTriangle> uneven_floor(double half, int cells, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  const double cell = 2.0 * half / cells;
  std::vector<Vec3> corner;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const bool inner = i > 0 && j > 0 && i < cells && j < cells;
      const double dx = inner ? shift(random) : 0.0, dy = inner ? shift(random) : 0.0;
      corner.emplace_back(-half + (i + dx) * cell, -half + (j + dy) * cell, 0.0);
    }
  }
  const auto at = [&](int i, int j) {
    return corner[static_cast<std::size_t>(i * (cells + 1) + j)];
  };
  std::vector<StlTriangle> mesh;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      if ((i + j) % 2 == 0)
        add_panel(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      else
        add_panel(mesh, at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), at(i, j));
    }
  }
  return mesh;
}

}  // namespace muckpile::test
