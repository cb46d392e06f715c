// SPDX-License-Identifier: GPL-2.0-or-later
// Faces of blocks in one plane, divided into what they share.
// Scope: see the header.
#include "geometry/cut/shared_faces.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "args/input_error.h"

namespace muckpile {
namespace {

/// A corner of the block that is there already, or a new one.
int corner(Polyhedron& shape, const std::vector<int>& old_face, const Vec3& at, double size) {
  for (const int v : old_face) {
    if ((shape.vertices[static_cast<std::size_t>(v)] - at).norm() < 1e-9 * size) return v;
  }
  shape.vertices.push_back(at);
  return static_cast<int>(shape.vertices.size()) - 1;
}

/// Area that is lost in the rounding of coordinates: of small faces relatively more [m2].
double rounding_of(const Block& block, double face_area) {
  constexpr double kRounding = 1e-9, kSmallFace = 1e-2;  // of the face, of V^(2/3)
  return kRounding * std::max(face_area, kSmallFace * std::pow(block.mass.volume, 2.0 / 3.0));
}

double area_in_space(const Piece& piece) {
  Vec3 area = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < piece.polygon.size(); ++k) {
    area +=
        0.5 * (piece.polygon[k] - piece.polygon[0]).cross(piece.polygon[k + 1] - piece.polygon[0]);
  }
  return area.norm();
}

void refuse_overlap(const std::vector<Piece>& pieces, double covered, double whole,
                    double rounding) {
  constexpr double kRounding = 1e3;  // times what coordinates' rounding makes
  if (covered <= whole + kRounding * rounding) return;
  throw InputError("blocks " + std::to_string(pieces.front().behind + 1) + " and " +
                   std::to_string(pieces.back().behind + 1) + " overlap");
}

/// What of a face no piece covers, as pieces with nothing behind.
std::vector<Piece> bare_pieces(const Block& block, std::size_t face,
                               const std::vector<Piece>& pieces) {
  const FaceGeometry plane = face_geometry(block.shape, static_cast<int>(face));
  const PlaneFrame frame(plane.centroid, plane.normal);
  Polygon whole;
  for (const int v : block.shape.faces[face])
    whole.push_back(frame.flat(block.shape.vertices[static_cast<std::size_t>(v)]));
  std::vector<Polygon> bare{whole};
  for (const Piece& piece : pieces) {
    Polygon covered;
    for (const Vec3& p : piece.polygon) covered.push_back(frame.flat(p));
    std::vector<Polygon> left;
    for (const Polygon& polygon : bare) {
      for (Polygon& part : without(polygon, covered)) {
        if (area_of(part) > rounding_of(block, plane.area)) left.push_back(std::move(part));
      }
    }
    bare = std::move(left);
  }
  std::vector<Piece> found;
  for (const Polygon& polygon : bare) {
    found.push_back({{}, kFreeFace});
    for (const Vec2& p : polygon) found.back().polygon.push_back(frame.space(p));
  }
  return found;
}

/// The first piece takes the face's place, the others follow all faces.
void divide_face(Block& block, std::size_t face, std::vector<Piece> pieces) {
  const double area = face_geometry(block.shape, static_cast<int>(face)).area;
  double covered = 0.0;
  for (const Piece& piece : pieces) covered += area_in_space(piece);
  refuse_overlap(pieces, covered, area, rounding_of(block, area));
  if (pieces.size() == 1 && covered > area - rounding_of(block, area)) {
    block.neighbour[face] = pieces.front().behind;
    return;
  }
  const std::vector<Piece> bare = bare_pieces(block, face, pieces);
  pieces.insert(pieces.end(), bare.begin(), bare.end());
  const std::vector<int> whole = block.shape.faces[face];
  const double size = std::cbrt(block.mass.volume);
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    std::vector<int> part;
    for (const Vec3& p : pieces[n].polygon) part.push_back(corner(block.shape, whole, p, size));
    if (n == 0) {
      block.shape.faces[face] = std::move(part);
      block.neighbour[face] = pieces[n].behind;
    } else {
      block.shape.faces.push_back(std::move(part));
      block.neighbour.push_back(pieces[n].behind);
    }
  }
}

}  // namespace

PlaneFace plane_face(const PlaneFrame& frame, const std::vector<Block>& blocks, std::size_t block,
                     std::size_t face, double side) {
  const Polyhedron& shape = blocks[block].shape;
  PlaneFace in{block, face, {}, Vec2::Constant(1e300), Vec2::Constant(-1e300), 0.0};
  for (const int v : shape.faces[face]) {
    in.polygon.push_back(frame.flat(shape.vertices[static_cast<std::size_t>(v)]));
    in.lo = in.lo.cwiseMin(in.polygon.back());
    in.hi = in.hi.cwiseMax(in.polygon.back());
  }
  if (side < 0.0) std::reverse(in.polygon.begin(), in.polygon.end());
  in.area = area_of(in.polygon);
  return in;
}

void share_faces(const PlaneFrame& frame, std::vector<PlaneFace>& below,
                 std::vector<PlaneFace>& above, Pieces& pieces) {
  constexpr double kSmallest = 1e-9;  // of the smaller face: below it is rounding
  std::stable_sort(above.begin(), above.end(),
                   [](const PlaneFace& a, const PlaneFace& b) { return a.lo.x() < b.lo.x(); });
  double widest = 0.0;
  for (const PlaneFace& b : above) widest = std::max(widest, b.hi.x() - b.lo.x());
  for (const PlaneFace& a : below) {
    auto b = std::lower_bound(above.begin(), above.end(), a.lo.x() - widest,
                              [](const PlaneFace& f, double x) { return f.lo.x() < x; });
    for (; b != above.end() && b->lo.x() < a.hi.x(); ++b) {
      if ((a.lo.array() > b->hi.array()).any() || (b->lo.array() > a.hi.array()).any()) continue;
      const Polygon common = overlap(a.polygon, b->polygon);
      if (common.size() < 3 || area_of(common) < kSmallest * std::min(a.area, b->area)) continue;
      std::vector<Vec3> seen;
      for (const Vec2& p : common) seen.push_back(frame.space(p));
      pieces[{a.block, a.face}].push_back({seen, static_cast<int>(b->block)});
      std::reverse(seen.begin(), seen.end());
      pieces[{b->block, b->face}].push_back({std::move(seen), static_cast<int>(a.block)});
    }
  }
}

void divide_faces(const Pieces& pieces, std::vector<Block>& blocks) {
  for (const auto& [place, parts] : pieces) divide_face(blocks[place.first], place.second, parts);
}

}  // namespace muckpile
