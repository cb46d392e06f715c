// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts single Voronoi cells out of a box: our k-d tree finds the neighbours, voro++ cuts the cells
// that become blocks, LaneCell those of sweeps.
// Scope: the only file that knows voro++. Its own container is a uniform grid, which is slow when
// seeds are 1000 times denser near a charge than far from it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "geometry/cut/lane_cell.h"
#include "geometry/cut/tessellation.h"
#include "geometry/shape/polyhedron.h"

namespace muckpile {

// Behind the face of a cell at its own wall; -1 to -7 are the box's walls and the bounds.
inline constexpr int kOwnWall = -8;

class CellCutter {
 public:
  // The points must outlive the cutter. Box corners in metres. Cells end at the bounds,
  // planes whose unit normals look out.
  CellCutter(const std::vector<Vec3>& points, const Vec3& lo, const Vec3& hi,
             std::vector<CutPlane> bounds = {});
  ~CellCutter();

  // Makes the cell of one point the present cell. `reach` [m] > 0 is a guess of how far its
  // neighbours are; it changes the speed, not the result. `wall`: a plane at which this cell alone
  // ends; its unit normal looks to the point. False if nothing is left: of a point outside the
  // bounds, and of one that coincides with another.
  [[nodiscard]] bool cut(int point, double reach, const CutPlane* wall = nullptr);

  // As cut() without a wall, but for rounding, in a quarter of its time. Faces and corners come in
  // another order.
  [[nodiscard]] bool cut_fast(int point, double reach);

  [[nodiscard]] LaneCell::Measure measure() const;  // of the present cell
  // The present cell in space, and per face the point behind it, negative for a box wall.
  void extract(Polyhedron& shape, std::vector<int>& neighbours) const;
  // Whether the number of the point behind one of the faces of the present cell fulfils this.
  [[nodiscard]] bool any_face(const std::function<bool(int)>& condition) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace muckpile
