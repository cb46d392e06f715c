// SPDX-License-Identifier: GPL-2.0-or-later
// What the seeds must know of the scene: where there is rock, and how large blocks should be there.
// Scope: read-only view of validated TessellationOptions; lengths in metres.
#pragma once

#include <vector>

#include "geometry/cut/hole_rings.h"
#include "geometry/cut/tessellation.h"
#include "geometry/index/axis_index.h"

namespace muckpile {

class Ground {
 public:
  // Around a hole that has rings there is rock for other seeds from its reach on.
  explicit Ground(const TessellationOptions& options, HoleRings rings = {});

  // In the box and in the region, holes or not.
  [[nodiscard]] bool in_region(const Vec3& point) const;
  // In the region and in no hole, nor within reach of its rings.
  [[nodiscard]] bool is_rock(const Vec3& point) const;
  // Distance from the nearest charge or fine axis; infinity without any [m].
  [[nodiscard]] double charge_distance(const Vec3& point) const;
  // Replaces `found` by the numbers of the holes whose wall is within a distance [m] of a point,
  // and perhaps of some farther ones, in rising order.
  void holes_near(const Vec3& point, double distance, std::vector<int>& found) const;
  // Block size asked for at a point [m].
  [[nodiscard]] double size(const Vec3& point) const;
  // Lower bound of the size within `reach` [m] of a point: the law never falls with distance, and
  // factors change slowly.
  [[nodiscard]] double smallest_size_near(const Vec3& point, double reach) const;
  // Gradient of ln(size) by central differences over a tenth of a block [1/m].
  [[nodiscard]] Vec3 log_size_gradient(const Vec3& point) const;

 private:
  // The law alone at the distances of a point, each less `nearer` [m].
  [[nodiscard]] double law_nearer(const Vec3& point, double nearer) const;

  const TessellationOptions& options_;
  AxisIndex axes_;  // of the holes, then the fine axes
  HoleRings rings_;
  double largest_radius_ = 0.0;  // of the holes, or reach of their rings [m]
};

// For a Voronoi cut.
[[nodiscard]] Ground voronoi_ground(const TessellationOptions& options);

}  // namespace muckpile
