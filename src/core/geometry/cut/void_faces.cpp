// SPDX-License-Identifier: GPL-2.0-or-later
// Divides the faces of blocks that look partly into the void of a hole with rings.
// Scope: open_to_voids() of hole_rings.h.
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/cut/hole_rings.h"

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

void open_to_voids(std::span<const RingSeed> rings, int first_ring, int number, Block& block) {
  constexpr double kRounding = 1e-7;  // of the block size
  const double rounding = kRounding * std::cbrt(block.mass.volume);
  const std::size_t count = block.neighbour.size();
  for (std::size_t f = 0; f < count; ++f) {
    const int ring = block.neighbour[f] - first_ring;
    if (ring < 0 || ring >= static_cast<int>(rings.size()) || block.neighbour[f] == number)
      continue;
    const RingSeed& behind = rings[static_cast<std::size_t>(ring)];
    if (behind.hole < 0) continue;
    std::vector<int> face = block.shape.faces[f];
    const std::vector<int> gone = cut_off(block.shape, face, behind.wall, rounding);
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

}  // namespace muckpile
