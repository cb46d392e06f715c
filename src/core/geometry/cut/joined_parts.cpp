// SPDX-License-Identifier: GPL-2.0-or-later
// Parts of rock joined again in the planes between them.
// Scope: see the header.
#include "geometry/cut/joined_parts.h"

#include <cmath>

#include "geometry/cut/shared_faces.h"

namespace muckpile {
namespace {

/// A face with nothing behind it.
struct BareFace {
  std::size_t block, face;
  Vec3 centroid, normal;
  double rounding;  // [m]
};

std::vector<BareFace> bare_faces(const std::vector<Block>& blocks) {
  constexpr double kRounding = 1e-7;  // of the block size
  std::vector<BareFace> found;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::size_t f = 0; f < blocks[b].neighbour.size(); ++f) {
      if (blocks[b].neighbour[f] != kFreeFace) continue;
      const FaceGeometry face = face_geometry(blocks[b].shape, static_cast<int>(f));
      found.push_back(
          {b, f, face.centroid, face.normal, kRounding * std::cbrt(blocks[b].mass.volume)});
    }
  }
  return found;
}

/// Those in the plane, of blocks below (`side` 1) or above it (-1).
std::vector<PlaneFace> faces_in(const PlaneFrame& frame, const std::vector<BareFace>& faces,
                                const std::vector<Block>& blocks, double side) {
  constexpr double kRounding = 1e-7;  // radians
  std::vector<PlaneFace> found;
  for (const BareFace& face : faces) {
    if (std::abs(frame.normal.dot(face.centroid - frame.origin)) > face.rounding) continue;
    if ((face.normal - side * frame.normal).norm() > kRounding) continue;
    found.push_back(plane_face(frame, blocks, face.block, face.face, side));
  }
  return found;
}

}  // namespace

void join_in_planes(const std::vector<CutPlane>& planes, std::vector<Block>& blocks) {
  const std::vector<BareFace> bare = bare_faces(blocks);
  for (const CutPlane& plane : planes) {
    const PlaneFrame frame(plane.point, plane.normal);
    std::vector<PlaneFace> below = faces_in(frame, bare, blocks, 1.0),
                           above = faces_in(frame, bare, blocks, -1.0);
    Pieces pieces;
    share_faces(frame, below, above, pieces);
    divide_faces(pieces, blocks);
  }
}

}  // namespace muckpile
