// SPDX-License-Identifier: GPL-2.0-or-later
// Polyhedra that the geometry tests share: box, tetrahedron, one random Voronoi cell.
// Scope: tests only; lengths in metres.
#pragma once

#include <algorithm>

#include "geometry/cut/tessellation.h"

namespace muckpile::test {

inline Polyhedron box(const Vec3& lo, const Vec3& hi) {
  Polyhedron shape;
  for (int k = 0; k < 8; ++k) {
    shape.vertices.emplace_back((k & 1) ? hi.x() : lo.x(), (k & 2) ? hi.y() : lo.y(),
                                (k & 4) ? hi.z() : lo.z());
  }
  shape.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                 {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return shape;
}

inline Polyhedron corner_tetrahedron() {
  return {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

// Air where x > 0 and z > 0, so a vertical face meets a horizontal floor.
inline RegionQuery bench_profile() {
  RegionQuery region;
  region.inside = [](const Vec3& p) { return p.x() <= 0.0 || p.z() <= 0.0; };
  region.surface_points = [](const Vec3& p, double cutoff) {
    const Vec3 on_face(0.0, p.y(), std::max(p.z(), 0.0));
    const Vec3 on_floor(std::max(p.x(), 0.0), p.y(), 0.0);
    std::vector<Vec3> points;
    if ((on_face - p).norm() < cutoff) points.push_back(on_face);
    if ((on_floor - p).norm() < cutoff && on_floor != on_face) points.push_back(on_floor);
    return points;
  };
  return region;
}

// A cube of the given edge [m] cut into blocks of about 1 m.
inline Tessellation cube_of_blocks(double edge, int sweeps, unsigned long seed) {
  TessellationOptions options;
  options.lo = Vec3::Constant(-0.5 * edge);
  options.hi = Vec3::Constant(0.5 * edge);
  options.seed = seed;
  options.sweeps = sweeps;
  return tessellate(options);
}

// One unrelaxed (irregular) block of about 1 m.
inline Polyhedron voronoi_cell(unsigned long seed) {
  const Tessellation cells = cube_of_blocks(3.0, 0, seed);
  return cells.blocks[cells.blocks.size() / 2].shape;
}

}  // namespace muckpile::test
