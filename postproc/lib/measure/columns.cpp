// SPDX-License-Identifier: GPL-2.0-or-later
// Vertical columns through posed blocks: the top surface and the length of rock in each column.
// Scope: each face of a polyhedron adds its height where it looks up and takes it away where it
// looks down.
#include "measure/columns.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "args/input_error.h"
#include "args/numbers.h"
#include "io/muck.h"
#include "io/posed_block.h"
#include "measure/scan_polygon.h"
#include "measure/start_extent.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

// Twice the vector area of a polygon (Newell): exact for plane faces, stable for slivers.
Vec3 face_normal(const std::vector<Vec3>& vertices, std::span<const int> face) {
  const Vec3& origin = vertices[static_cast<size_t>(face[0])];
  Vec3 normal = Vec3::Zero();
  for (size_t k = 1; k + 1 < face.size(); ++k) {
    normal += (vertices[static_cast<size_t>(face[k])] - origin)
                  .cross(vertices[static_cast<size_t>(face[k + 1])] - origin);
  }
  return normal;
}

struct RowRange {
  int begin, end;
};

// Fills the columns of some rows of the grid; lengths only where `columns` has them.
class ColumnFiller {
 public:
  ColumnFiller(Columns& columns, RowRange rows)
      : out_(columns), rows_(rows), tops_only_(columns.length.empty()) {}

  // Whether each column that the ball may reach holds rock above all of it.
  [[nodiscard]] bool hides(const Vec3& centre, double reach) const {
    const ColumnGrid& grid = out_.grid;
    const double top = centre.z() + reach;
    const auto first = [](double place, int limit) {
      return static_cast<int>(std::clamp(std::floor(place), 0.0, static_cast<double>(limit)));
    };
    const int i_end = first((centre.x() + reach - grid.x0) / grid.dx + 1.0, grid.nx);
    const int j_end = first((centre.y() + reach - grid.y0) / grid.dy + 1.0, rows_.end);
    const int i_begin = first((centre.x() - reach - grid.x0) / grid.dx, grid.nx);
    for (int j = std::max(first((centre.y() - reach - grid.y0) / grid.dy, rows_.end), rows_.begin);
         j < j_end; ++j) {
      for (int i = i_begin; i < i_end; ++i)
        if (!(out_.top[grid.at(i, j)] > top)) return false;
    }
    return true;
  }

  void add(const std::vector<Vec3>& vertices, std::span<const int> face, int block) {
    const Vec3 normal = face_normal(vertices, face);
    if (tops_only_ && normal.z() <= 0.0) return;
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
      if (j < rows_.begin || j >= rows_.end) return;
      const double z_row = origin.z() + slope_y * (grid.y(j) - origin.y());
      for (int i = begin; i < end; ++i) {
        set(grid.at(i, j), z_row + slope_x * (grid.x(i) - origin.x()), looks_up, block);
      }
    });
  }

 private:
  void set(size_t cell, double z, bool looks_up, int block) {
    if (!tops_only_) out_.length[cell] += looks_up ? z : -z;
    if (looks_up && z > out_.top[cell]) {
      out_.top[cell] = z;
      out_.top_block[cell] = block;
    }
  }

  Columns& out_;
  RowRange rows_;
  bool tops_only_;
  std::vector<Vec2> outline_;
  std::vector<double> crossings_;
};

constexpr double kMostCells = 5e7;  // 1 GB of columns

// From the centroid to the farthest vertex, with room for rounding as the block moves [m].
double reach_of(const StartBlock& block) {
  double farthest = 0.0;
  for (const Vec3& p : block.shape.vertices)
    farthest = std::max(farthest, (p - block.centroid).squaredNorm());
  return 1.001 * std::sqrt(farthest);
}

// Which blocks a core has to look at: it fills a strip of rows with all that reaches into it, so
// that each column gets its blocks in their order.
class BlockReaches {
 public:
  BlockReaches(const ColumnGrid& grid, const std::vector<StartBlock>& blocks,
               const std::vector<BlockState>& states)
      : grid_(grid), y_(blocks.size()), reach_(blocks.size()) {
    each_in_parallel(blocks.size(), [&](size_t b) {
      y_[b] = states[b].centre.y();
      reach_[b] = reach_of(blocks[b]);
    });
  }
  [[nodiscard]] double of(size_t b) const { return reach_[b]; }
  [[nodiscard]] bool reaches(size_t b, RowRange rows) const {
    return y_[b] + reach_[b] >= grid_.y0 + rows.begin * grid_.dy &&
           y_[b] - reach_[b] <= grid_.y0 + rows.end * grid_.dy;
  }

 private:
  const ColumnGrid& grid_;
  std::vector<double> y_, reach_;
};

// The blocks to keep by how high they may reach; of equal ones in their order.
std::vector<size_t> from_highest(const BlockReaches& reach, const std::vector<BlockState>& states,
                                 const std::vector<char>& keep) {
  std::vector<std::pair<double, size_t>> tops;
  for (size_t b = 0; b < states.size(); ++b)
    if (keep[b] != 0) tops.emplace_back(-states[b].centre.z() - reach.of(b), b);
  std::ranges::sort(tops);
  std::vector<size_t> blocks;
  for (const auto& top : tops) blocks.push_back(top.second);
  return blocks;
}

// Calls work(rows) for strips of the grid, some to each core, as they differ in rock.
template <class Work>
void each_strip(const ColumnGrid& grid, Work&& work) {
  const int strips = std::min(4 * static_cast<int>(cores()), grid.ny);
  in_parallel(static_cast<size_t>(strips), [&](size_t part) {
    const int strip = static_cast<int>(part);
    work(RowRange{strip * grid.ny / strips, (strip + 1) * grid.ny / strips});
  });
}

Extent nothing() {
  return {Vec3::Constant(std::numeric_limits<double>::infinity()), Vec3::Constant(kNoRock)};
}

// Of the vertices that vertices_of(b) tells, in memory of its own or the blocks'.
template <class Vertices>
Extent extent_where(size_t count, Vertices&& vertices_of) {
  constexpr size_t kTogether = 4096;
  std::vector<Extent> parts((count + kTogether - 1) / kTogether, nothing());
  in_parallel(parts.size(), [&](size_t part) {
    for (size_t b = part * kTogether; b < std::min(count, (part + 1) * kTogether); ++b) {
      for (const Vec3& p : vertices_of(b)) {
        parts[part].low = parts[part].low.cwiseMin(p);
        parts[part].high = parts[part].high.cwiseMax(p);
      }
    }
  });
  Extent extent = nothing();
  for (const Extent& part : parts) {
    extent.low = extent.low.cwiseMin(part.low);
    extent.high = extent.high.cwiseMax(part.high);
  }
  return extent;
}

}  // namespace

ColumnGrid column_grid(double x_low, double x_high, double y_low, double y_high, double cell) {
  const double first = std::floor(x_low / cell), last = std::ceil(x_high / cell);
  const double rows = std::max(1.0, std::round((y_high - y_low) / cell));
  if (!((last - first) * rows <= kMostCells)) {
    throw InputError("cell must leave at most 5e7 columns [m], got '" + number_text(cell) + "'");
  }
  return {
      first * cell,          y_low, cell, (y_high - y_low) / rows, static_cast<int>(last - first),
      static_cast<int>(rows)};
}

Columns columns_through(const ColumnGrid& grid, const std::vector<StartBlock>& blocks,
                        const std::vector<BlockState>& states, const std::vector<char>& keep) {
  Columns columns{grid, std::vector<double>(grid.cells(), kNoRock),
                  std::vector<int>(grid.cells(), -1), std::vector<double>(grid.cells(), 0.0)};
  const BlockReaches reach(grid, blocks, states);
  each_strip(grid, [&](RowRange rows) {
    ColumnFiller filler(columns, rows);
    std::vector<Vec3> vertices;
    for (size_t b = 0; b < blocks.size(); ++b) {
      if (keep[b] == 0 || !reach.reaches(b, rows)) continue;
      move_vertices(blocks[b], states[b], vertices);
      for (const std::span<const int> face : blocks[b].shape.faces)
        filler.add(vertices, face, static_cast<int>(b));
    }
  });
  return columns;
}

Columns tops_through(const ColumnGrid& grid, const std::vector<StartBlock>& blocks,
                     const std::vector<BlockState>& states, const std::vector<char>& keep) {
  Columns columns{
      grid, std::vector<double>(grid.cells(), kNoRock), std::vector<int>(grid.cells(), -1), {}};
  const BlockReaches reach(grid, blocks, states);
  const std::vector<size_t> from_above = from_highest(reach, states, keep);
  each_strip(grid, [&](RowRange rows) {
    ColumnFiller filler(columns, rows);
    std::vector<Vec3> vertices;
    for (const size_t b : from_above) {
      if (!reach.reaches(b, rows) || filler.hides(states[b].centre, reach.of(b))) continue;
      move_vertices(blocks[b], states[b], vertices);
      for (const std::span<const int> face : blocks[b].shape.faces)
        filler.add(vertices, face, static_cast<int>(b));
    }
  });
  return columns;
}

Extent extent_of(const std::vector<StartBlock>& blocks, const std::vector<BlockState>& states) {
  return extent_where(blocks.size(), [&](size_t b) -> const std::vector<Vec3>& {
    thread_local std::vector<Vec3> vertices;
    move_vertices(blocks[b], states[b], vertices);
    return vertices;
  });
}

Extent extent_at_start(const std::vector<StartBlock>& blocks) {
  if (rock_blocks(blocks) < blocks.size()) {
    std::vector<StartBlock> rock = blocks;
    (void)split_muck(rock);
    return extent_at_start(rock);
  }
  return extent_where(blocks.size(), [&](size_t b) { return std::span(blocks[b].shape.vertices); });
}

}  // namespace muckpile
