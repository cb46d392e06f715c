// SPDX-License-Identifier: GPL-2.0-or-later
// From divided cells to blocks that know their neighbours.
// Scope: see the header.
#include "geometry/cut/cell_partition.h"

#include <algorithm>
#include <utility>

#include "geometry/cut/shared_faces.h"

namespace muckpile {
namespace {

struct PlaneSides {
  std::vector<PlaneFace> below, above;
};

/// What is behind a face, in the numbers of the finished blocks: faces against one void, in however
/// many cells it was cut, stay whole.
void name_neighbours(const std::vector<int>& name, Pieces& pieces, std::vector<Block>& blocks) {
  for (auto at = pieces.begin(); at != pieces.end();) {
    auto& [place, parts] = *at;
    for (Piece& part : parts) part.behind = name[static_cast<std::size_t>(part.behind)];
    const int first = parts.front().behind;
    const bool one_void =
        first < 0 && std::all_of(parts.begin(), parts.end(),
                                 [&](const Piece& part) { return part.behind == first; });
    if (one_void) blocks[place.first].neighbour[place.second] = first;
    at = one_void ? pieces.erase(at) : std::next(at);
  }
}

}  // namespace

std::optional<HalfCells> CellPartition::divide(const ConvexCell& cell, const CutPlane& plane) {
  const auto halves = divided(cell, plane.point, plane.normal, static_cast<int>(planes_.size()));
  if (halves) planes_.push_back(plane);
  return halves;
}

void CellPartition::finish(ConvexCell cell, int filling) {
  cells_.push_back({std::move(cell), filling});
}

double CellPartition::volume_filled_with(int filling) const {
  double volume = 0.0;
  for (const Finished& one : cells_) volume += one.filling == filling ? volume_of(one.cell) : 0.0;
  return volume;
}

std::vector<Block> CellPartition::blocks() const {
  std::vector<Block> all;
  std::vector<int> name;
  int rock = 0;
  for (const Finished& one : cells_) {
    Block block;
    block.shape = one.cell.shape;
    block.mass = mass_properties(block.shape);
    block.neighbour.assign(block.shape.faces.size(), kFreeFace);
    all.push_back(std::move(block));
    name.push_back(one.filling == kRock ? rock++ : one.filling);
  }
  std::vector<PlaneSides> sides(planes_.size());
  std::vector<PlaneFrame> frames;
  for (const CutPlane& plane : planes_) frames.emplace_back(plane.point, plane.normal);
  for (std::size_t b = 0; b < all.size(); ++b) {
    const std::vector<int>& made_by = cells_[b].cell.made_by;
    for (std::size_t f = 0; f < made_by.size(); ++f) {
      if (made_by[f] < 0) continue;
      const auto plane = static_cast<std::size_t>(made_by[f]);
      const double side = frames[plane].normal.dot(all[b].mass.centroid - frames[plane].origin);
      (side < 0.0 ? sides[plane].below : sides[plane].above)
          .push_back(plane_face(frames[plane], all, b, f, side < 0.0 ? 1.0 : -1.0));
    }
  }
  Pieces pieces;
  for (std::size_t p = 0; p < sides.size(); ++p)
    share_faces(frames[p], sides[p].below, sides[p].above, pieces);
  name_neighbours(name, pieces, all);
  divide_faces(pieces, all);
  std::vector<Block> kept;
  for (std::size_t b = 0; b < all.size(); ++b) {
    if (name[b] >= 0) kept.push_back(std::move(all[b]));
  }
  return kept;
}

}  // namespace muckpile
