// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles with ground behind them, in a tree of boxes.
// Scope: a wall_surface.h. Each triangle's front is where its normal points by the turn of its
// corners. A centre up to its radius behind a face is pushed out through the nearest one. Where the
// surface ends nothing is behind: its border pushes away from itself.
#pragma once

#include "geometry/surface/surface_index.h"
#include "geometry/surface/triangle_point.h"
#include "wall/wall_surface.h"

namespace muckpile {

class WallMesh : public WallSurface {
 public:
  explicit WallMesh(std::vector<StlTriangle> triangles) : index_(std::move(triangles)) {}

  [[nodiscard]] const SurfaceIndex& surface() const { return index_; }

  [[nodiscard]] double distance(const Vec3& place, double reach,
                                std::vector<std::size_t>& parts) const override;
  void find_touches(const Vec3& centre, double radius, std::span<const std::size_t> parts,
                    WallTouches& touches) const override;
  [[nodiscard]] bool lets_go() const override { return true; }
  [[nodiscard]] double depth(const Vec3& place) const override;

 private:
  /// Closest point of a triangle to the centre.
  struct Hit {
    double distance;  ///< [m]
    std::size_t triangle;
    TrianglePoint point;
  };
  /// What the surface is like at a hit.
  struct Place {
    Vec3 outward = Vec3::Zero();  ///< out of the ground, not of unit length
    bool border = false;          ///< the surface ends here
  };
  void sift(std::vector<Hit>& hits, const Vec3& centre, double radius, WallTouches& touches) const;
  [[nodiscard]] bool is_nearest_around(std::span<const Hit> hits, std::size_t k,
                                       double slack) const;
  /// An edge of the triangle of a hit that meets the hit's point, which is its corner.
  struct RimEdge {
    std::size_t triangle;
    Vec3 end;  ///< the far one [m]
  };
  [[nodiscard]] bool ends_at(const RimEdge& edge, const Vec3& at, std::span<const Hit> hits,
                             std::span<const RimEdge> rim, double slack) const;
  [[nodiscard]] Place place_of(std::span<const Hit> hits, const Hit& hit, double slack) const;

  SurfaceIndex index_;
};

}  // namespace muckpile
