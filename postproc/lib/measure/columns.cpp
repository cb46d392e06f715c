// SPDX-License-Identifier: GPL-2.0-or-later
// Vertical columns through posed blocks: the top surface and the length of rock in each column.
// Scope: each face of a polyhedron adds its height where it looks up and takes it away where it
// looks down.
#include "measure/columns.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "args/input_error.h"
#include "measure/scan_polygon.h"

namespace muckpile {
namespace {

// Twice the vector area of a polygon (Newell): exact for plane faces, stable for slivers.
Vec3 face_normal(const std::vector<Vec3>& vertices, const std::vector<int>& face) {
  const Vec3& origin = vertices[static_cast<size_t>(face[0])];
  Vec3 normal = Vec3::Zero();
  for (size_t k = 1; k + 1 < face.size(); ++k) {
    normal += (vertices[static_cast<size_t>(face[k])] - origin)
                  .cross(vertices[static_cast<size_t>(face[k + 1])] - origin);
  }
  return normal;
}

class ColumnFiller {
 public:
  explicit ColumnFiller(Columns& columns) : out_(columns) {}

  void add(const std::vector<Vec3>& vertices, const std::vector<int>& face, int block) {
    const Vec3 normal = face_normal(vertices, face);
    if (std::abs(normal.z()) <= kUpright * normal.norm()) return;
    const ColumnGrid& grid = out_.grid;
    outline_.clear();
    for (const int v : face) {
      const Vec3& p = vertices[static_cast<size_t>(v)];
      outline_.emplace_back((p.x() - grid.x0) / grid.dx, (p.y() - grid.y0) / grid.dy);
    }
    const Vec3& origin = vertices[static_cast<size_t>(face[0])];
    const double slope_x = -normal.x() / normal.z(), slope_y = -normal.y() / normal.z();
    const bool looks_up = normal.z() > 0.0;
    scan_polygon(outline_, grid.nx, grid.ny, crossings_, [&](int j, int begin, int end) {
      const double z_row = origin.z() + slope_y * (grid.y(j) - origin.y());
      for (int i = begin; i < end; ++i) {
        set(grid.at(i, j), z_row + slope_x * (grid.x(i) - origin.x()), looks_up, block);
      }
    });
  }

 private:
  void set(size_t cell, double z, bool looks_up, int block) {
    out_.length[cell] += looks_up ? z : -z;
    if (looks_up && z > out_.top[cell]) {
      out_.top[cell] = z;
      out_.top_block[cell] = block;
    }
  }

  Columns& out_;
  std::vector<Vec2> outline_;
  std::vector<double> crossings_;
};

constexpr double kMostCells = 5e7;  // 1 GB of columns

}  // namespace

ColumnGrid column_grid(double x_low, double x_high, double y_low, double y_high, double cell) {
  const double first = std::floor(x_low / cell), last = std::ceil(x_high / cell);
  const double rows = std::max(1.0, std::round((y_high - y_low) / cell));
  if (!((last - first) * rows <= kMostCells)) {
    throw InputError("cell must leave at most 5e7 columns [m], got '" + std::to_string(cell) + "'");
  }
  return {
      first * cell,          y_low, cell, (y_high - y_low) / rows, static_cast<int>(last - first),
      static_cast<int>(rows)};
}

Columns columns_through(const ColumnGrid& grid, const std::vector<StartBlock>& blocks,
                        const std::vector<BlockState>& states, const std::vector<char>& keep) {
  Columns columns{grid, std::vector<double>(grid.cells(), kNoRock),
                  std::vector<int>(grid.cells(), -1), std::vector<double>(grid.cells(), 0.0)};
  ColumnFiller filler(columns);
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (keep[b] == 0) continue;
    const std::vector<Vec3> vertices = moved_vertices(blocks[b], states[b]);
    for (const std::vector<int>& face : blocks[b].shape.faces)
      filler.add(vertices, face, static_cast<int>(b));
  }
  return columns;
}

Extent extent_of(const std::vector<StartBlock>& blocks, const std::vector<BlockState>& states) {
  Extent extent{Vec3::Constant(std::numeric_limits<double>::infinity()), Vec3::Constant(kNoRock)};
  for (size_t b = 0; b < blocks.size(); ++b) {
    for (const Vec3& p : moved_vertices(blocks[b], states[b])) {
      extent.low = extent.low.cwiseMin(p);
      extent.high = extent.high.cwiseMax(p);
    }
  }
  return extent;
}

}  // namespace muckpile
