// SPDX-License-Identifier: GPL-2.0-or-later
// Takes the crushed zone of a charge out of convex cells so that convex cells remain.
// Scope: the zone is a prism with an even number of sides. A cell that meets several sides is
// divided along radii through the prism's edges, as radial cracks would, until each part meets one
// side.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "geometry/cut/cell_partition.h"
#include "geometry/index/axis_index.h"

namespace muckpile {

class HoleCarving {
 public:
  /// `wall_size` [m]: block size at the wall, which sets the number of sides. `scale`: of the
  /// radius of the circle that has the prism's cross section.
  HoleCarving(const Hole& hole, int number, double wall_size, double scale);

  /// How a cell lies.
  enum class Place { outside, across, inside };
  [[nodiscard]] Place place_of(const ConvexCell& cell) const;

  /// Of a cell across the wall: the volume outside [m3], its centroid, and into how many parts it
  /// will be divided at most.
  struct Rock {
    double volume;
    Vec3 centroid;
    std::size_t parts;
  };
  [[nodiscard]] Rock rock_of(const ConvexCell& cell) const;

  /// Finishes the parts of the cell that lie in the prism as void, and gives back the others.
  /// Thin parts are not made: they go with the void.
  using Thin = std::function<bool(const ConvexCell&)>;
  [[nodiscard]] std::vector<ConvexCell> carve(const ConvexCell& cell, const Thin& thin,
                                              CellPartition& partition) const;

 private:
  struct Inside {
    ConvexCell cell;
    std::vector<std::size_t> sides;  // that it has faces on
  };
  [[nodiscard]] std::optional<Inside> part_inside(const ConvexCell& cell) const;
  [[nodiscard]] bool is_mostly_rock(const ConvexCell& cell) const;
  [[nodiscard]] bool near(const ConvexCell& cell) const;
  [[nodiscard]] CutPlane radius_between(std::size_t side, std::size_t next) const;
  [[nodiscard]] std::optional<HalfCells> part_by_radius(const ConvexCell& cell,
                                                        const std::vector<std::size_t>& sides,
                                                        const Thin& thin,
                                                        CellPartition& partition) const;
  void carve_part(const ConvexCell& cell, const Thin& thin, CellPartition& partition,
                  std::vector<ConvexCell>& rock) const;
  void carve_sides(ConvexCell cell, const std::vector<std::size_t>& sides, const Thin& thin,
                   CellPartition& partition, std::vector<ConvexCell>& rock) const;

  Hole hole_;
  Axis axis_;
  int code_;
  std::vector<CutPlane> sides_, ends_;  // normals look away from the zone
};

}  // namespace muckpile
