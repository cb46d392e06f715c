// SPDX-License-Identifier: GPL-2.0-or-later
// Divides the faces of blocks that look partly into the void of a hole with rings.
// Scope: open_to_voids() and open_planes_to_voids() of hole_rings.h.
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/cut/ground.h"
#include "geometry/cut/hole_rings.h"
#include "geometry/cut/unit_planes.h"
#include "geometry/holes/hole_surface.h"

namespace muckpile {
namespace {

/// Divides a face where the plane crosses it. Returns the corners beyond the plane, against its
/// normal; the face keeps the others. None, if it lies on one side.
std::vector<int> cut_off(Polyhedron& shape, std::vector<int>& face, const CutPlane& plane,
                         double rounding) {
  std::vector<int> kept, gone;
  const auto height = [&](int v) {
    return plane.normal.dot(shape.vertices[static_cast<std::size_t>(v)] - plane.point);
  };
  for (std::size_t k = 0; k < face.size(); ++k) {
    const int v = face[k], next = face[(k + 1) % face.size()];
    const double here = height(v), there = height(next);
    if (here >= -rounding) kept.push_back(v);
    if (here <= rounding) gone.push_back(v);
    if (std::min(here, there) >= -rounding || std::max(here, there) <= rounding) continue;
    const Vec3 &from = shape.vertices[static_cast<std::size_t>(v)],
               &to = shape.vertices[static_cast<std::size_t>(next)];
    shape.vertices.push_back(from + here / (here - there) * (to - from));
    kept.push_back(static_cast<int>(shape.vertices.size()) - 1);
    gone.push_back(kept.back());
  }
  const auto is_deep = [&](int v) { return height(v) < -rounding; };
  if (std::none_of(gone.begin(), gone.end(), is_deep)) return {};
  face = std::move(kept);
  return gone;
}

}  // namespace

void open_to_voids(std::span<const VoidWall> walls, int number, Block& block) {
  constexpr double kRounding = 1e-7;  // of the block size
  const double rounding = kRounding * std::cbrt(block.mass.volume);
  const std::size_t count = block.neighbour.size();
  for (std::size_t f = 0; f < count; ++f) {
    if (block.neighbour[f] < 0 || block.neighbour[f] == number) continue;
    const VoidWall& behind = walls[static_cast<std::size_t>(block.neighbour[f])];
    if (behind.hole < 0) continue;
    std::vector<int> face = block.shape.faces[f];
    const std::vector<int> gone = cut_off(block.shape, face, behind.plane, rounding);
    if (gone.size() < 3) continue;
    if (face.size() < 3) {
      block.neighbour[f] = hole_face(behind.hole);
      continue;
    }
    block.shape.faces[f] = face;
    block.shape.faces.push_back(gone);
    block.neighbour.push_back(hole_face(behind.hole));
  }
}

void open_planes_to_voids(const TessellationOptions& options, std::vector<Block>& blocks) {
  // The latter of the block size: how far a void may reach beside its hole.
  constexpr double kRounding = 1e-7, kOut = 1e-3, kFarthest = 2.0;
  const Ground ground = voronoi_ground(options);
  std::vector<int> near;
  const UnitPlanes planes(options.planes);
  const auto hole_at = [&](const Vec3& point, double size) {
    ground.holes_near(point, size, near);
    int nearest = -1;
    double least = size;
    for (const int h : near) {
      const Vec3 wall = closest_on_hole(options.holes[static_cast<std::size_t>(h)], point);
      if (const double away = (point - wall).norm(); away < least) {
        least = away;
        nearest = h;
      }
    }
    return nearest;
  };
  for (Block& block : blocks) {
    const double size = std::cbrt(block.mass.volume);
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] != kFreeFace) continue;
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      if (!planes.hold(face, kRounding * size)) continue;
      if (!ground.in_region(face.centroid + kOut * size * face.normal)) continue;
      const int hole = hole_at(face.centroid, kFarthest * block.target_size);
      if (hole >= 0) block.neighbour[f] = hole_face(hole);
    }
  }
}

}  // namespace muckpile
