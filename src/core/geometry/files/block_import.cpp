// SPDX-License-Identifier: GPL-2.0-or-later
// Cells of a VTK file joined to blocks: checks, shared faces, faces on crushed zones.
// Scope: see the header.
#include "geometry/files/block_import.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include "args/csv_table.h"
#include "geometry/cut/ground.h"
#include "geometry/cut/shared_faces.h"
#include "geometry/files/cell_file.h"
#include "geometry/files/import_fault.h"
#include "geometry/holes/hole_surface.h"
#include "geometry/index/axis_index.h"
#include "geometry/shape/shape_fault.h"
#include "geometry/shape/shared_volume.h"

namespace muckpile {
namespace {

constexpr double kShape = kShapeRounding;  // of the cell's size

Block checked_block(Polyhedron shape, std::size_t cell) {
  Block block;
  block.shape = std::move(shape);
  block.mass = mass_properties(block.shape);
  const std::string fault = shape_fault(block.shape, block.mass);
  if (!fault.empty()) fail_import("cell ", cell, ' ', fault);
  block.neighbour.assign(block.shape.faces.size(), kFreeFace);
  return block;
}

/// Pairs of blocks whose bounding boxes touch, first number smaller.
std::vector<std::pair<std::size_t, std::size_t>> touching(const std::vector<Block>& blocks) {
  struct Bounds {
    std::size_t block;
    Vec3 lo, hi;
  };
  std::vector<Bounds> bounds;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Bounds box{b, Vec3::Constant(1e300), Vec3::Constant(-1e300)};
    for (const Vec3& v : blocks[b].shape.vertices) {
      box.lo = box.lo.cwiseMin(v);
      box.hi = box.hi.cwiseMax(v);
    }
    const double around = kShape * std::cbrt(blocks[b].mass.volume);
    box.lo.array() -= around;
    box.hi.array() += around;
    bounds.push_back(box);
  }
  std::sort(bounds.begin(), bounds.end(),
            [](const Bounds& a, const Bounds& b) { return a.lo.x() < b.lo.x(); });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    for (std::size_t j = i + 1; j < bounds.size() && bounds[j].lo.x() < bounds[i].hi.x(); ++j) {
      if ((bounds[i].lo.array() > bounds[j].hi.array()).any() ||
          (bounds[j].lo.array() > bounds[i].hi.array()).any())
        continue;
      pairs.push_back(std::minmax(bounds[i].block, bounds[j].block));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

using Faces = std::vector<FaceGeometry>;

void refuse_overlap(const std::vector<Block>& blocks, const std::vector<Faces>& faces,
                    std::size_t a, std::size_t b) {
  constexpr double kLargest = 1e-6;  // of the smaller block
  const double shared = shared_volume(blocks[a].shape, std::cbrt(blocks[b].mass.volume), faces[b]);
  if (shared > kLargest * std::min(blocks[a].mass.volume, blocks[b].mass.volume))
    fail_import("cells ", a + 1, " and ", b + 1, " overlap by ", shared, " m3");
}

/// Whether all corners of a face are in the plane of another.
bool lies_in(const Block& block, std::size_t face, const FaceGeometry& plane, double size) {
  const auto& corners = block.shape.faces[face];
  return std::all_of(corners.begin(), corners.end(), [&](int v) {
    const Vec3& at = block.shape.vertices[static_cast<std::size_t>(v)];
    return std::abs(plane.normal.dot(at - plane.centroid)) < kShape * size;
  });
}

void join(const std::vector<Block>& blocks, const std::vector<Faces>& faces, std::size_t a,
          std::size_t b, Pieces& pieces) {
  const double size = std::cbrt(std::min(blocks[a].mass.volume, blocks[b].mass.volume));
  constexpr double kOpposite = -0.9;  // cosine; what is in one plane decides, this is the side
  for (std::size_t f = 0; f < blocks[a].shape.faces.size(); ++f) {
    const FaceGeometry& mine = faces[a][f];
    for (std::size_t g = 0; g < blocks[b].shape.faces.size(); ++g) {
      const FaceGeometry& theirs = faces[b][g];
      if (mine.normal.dot(theirs.normal) > kOpposite) continue;
      const bool mine_larger = mine.area > theirs.area;
      if (mine_larger ? !lies_in(blocks[b], g, mine, size) : !lies_in(blocks[a], f, theirs, size))
        continue;
      const PlaneFrame frame(mine.centroid, mine.normal);
      std::vector<PlaneFace> below{plane_face(frame, blocks, a, f, 1.0)},
          above{plane_face(frame, blocks, b, g, -1.0)};
      share_faces(frame, below, above, pieces);
    }
  }
}

/// Gives the faces that look into a void of the region, not out of it, to the nearest hole.
void find_hole_faces(const TessellationOptions& rock, const Ground& ground, Block& block) {
  constexpr double kLook = 1e-3;  // ahead, of the block's size
  constexpr double kFar = 4.0;    // [radii]; a void farther from all axes is none of a charge
  for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
    if (block.neighbour[f] != kFreeFace) continue;
    const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
    if (!ground.in_region(face.centroid + kLook * std::cbrt(block.mass.volume) * face.normal))
      continue;
    double nearest = kFar;
    for (std::size_t h = 0; h < rock.holes.size(); ++h) {
      const Hole& hole = rock.holes[h];
      const double away = Axis(hole.toe, hole.collar).distance(face.centroid) / hole.radius;
      if (away < nearest) block.neighbour[f] = hole_face(static_cast<int>(h));
      nearest = std::min(nearest, away);
    }
  }
}

}  // namespace

std::vector<Block> joined_blocks(std::vector<Polyhedron> cells) {
  std::vector<Block> blocks;
  for (std::size_t c = 0; c < cells.size(); ++c)
    blocks.push_back(checked_block(std::move(cells[c]), c + 1));
  std::vector<Faces> faces;
  for (const Block& block : blocks) faces.push_back(face_geometries(block.shape));
  Pieces pieces;
  for (const auto& [a, b] : touching(blocks)) {
    refuse_overlap(blocks, faces, a, b);
    join(blocks, faces, a, b, pieces);
  }
  divide_faces(pieces, blocks);
  return blocks;
}

Tessellation import_blocks(const std::string& path, const TessellationOptions& rock) {
  if (!std::ifstream(path)) fail_import("cannot read '", path, "'");
  TextWords text(whole_file(path));
  Tessellation result;
  std::vector<Polyhedron> cells = read_cells(text, path);
  if (cells.size() > rock.max_blocks)
    fail_import("'", path, "' holds ", cells.size(), " cells, more than max_blocks ",
                rock.max_blocks);
  result.blocks = joined_blocks(std::move(cells));
  const Ground ground(rock);
  for (std::size_t b = 0; b < result.blocks.size(); ++b) {
    Block& block = result.blocks[b];
    const Vec3& at = block.mass.centroid;
    if (!ground.in_region(at)) {
      fail_import("cell ", b + 1, " must lie in the region, got its centroid at '", at.x(), ' ',
                  at.y(), ' ', at.z(), "'");
    }
    block.target_size = std::cbrt(block.mass.volume);
    const SizeLimits& limits = rock.size.limits();
    if (block.target_size < limits.smallest || block.target_size > limits.largest) {
      fail_import("the size V^(1/3) of cell ", b + 1, " must be >= ", limits.smallest,
                  " and <= ", limits.largest, " m, got '", block.target_size, "'");
    }
    find_hole_faces(rock, ground, block);
  }
  for (const Hole& hole : rock.holes)
    result.statistics.cylinder_volume.push_back(
        cylinder_volume_where(hole, [&](const Vec3& p) { return ground.in_region(p); }));
  add_statistics(rock, result);
  return result;
}

}  // namespace muckpile
