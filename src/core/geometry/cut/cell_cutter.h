// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts single Voronoi cells out of a box: voro++ cuts planes, our k-d tree finds the neighbours.
// Scope: the only file that knows voro++. Its own container is a uniform grid, which is slow when
// seeds are 1000 times denser near a charge than far from it.
#pragma once

#include <memory>
#include <vector>

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

  [[nodiscard]] double volume() const;  // of the present cell [m3]
  [[nodiscard]] Vec3 centroid() const;  // of the present cell [m]
  // Whether a plane of a point numbered `first` or above was offered to the present cell.
  [[nodiscard]] bool met_point_from(int first) const;
  // The present cell in space, and per face the point behind it, negative for a box wall.
  void extract(Polyhedron& shape, std::vector<int>& neighbours) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace muckpile
