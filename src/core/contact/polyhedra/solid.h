// SPDX-License-Identifier: GPL-2.0-or-later
// A convex polyhedron about its centre, and the same turned and moved, as
// contacts need them. Scope: body axes and lengths in metres; a shape that
// cannot be a convex body is refused.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

/// Where a solid is in space.
struct Pose {
  Vec3 centre;  ///< [m]
  Mat3 axes;    ///< columns: the body's axes
};

class Solid {
 public:
  static constexpr std::size_t kMostPlanes = 64, kMostCorners = 128;

  struct Plane {
    Vec3 normal;   ///< unit, outward
    double depth;  ///< of the centre below it [m], > 0
  };
  struct Face {
    int plane, begin,
        count;  ///< corners loop[begin .. begin + count), counter-clockwise
  };

  /// Throws InputError where the shape is not convex, its centre is not inside,
  /// or it has more planes or corners than there is room for.
  Solid(const Polyhedron& shape, const Pose& pose);

  [[nodiscard]] const std::vector<Vec3>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<Plane>& planes() const { return planes_; }
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  [[nodiscard]] const std::vector<int>& loop() const { return loop_; }
  [[nodiscard]] double radius() const { return radius_; }            ///< of its farthest corner [m]
  [[nodiscard]] double least_depth() const { return least_depth_; }  ///< of its planes [m]
  /// Greatest area of a face over its depth [m]: stiffness of a contact all
  /// over it, per modulus.
  [[nodiscard]] double stiffest() const { return stiffest_; }
  [[nodiscard]] double bytes() const;

 private:
  int plane_of(const FaceGeometry& face, const Vec3& inside, const Mat3& axes);
  void check() const;

  std::vector<Vec3> corners_;
  std::vector<Plane> planes_;  // those of faces in one plane are one
  std::vector<Face> faces_;
  std::vector<int> loop_;
  double radius_ = 0.0, least_depth_ = 0.0, stiffest_ = 0.0;
};

/// A solid where another sees it, drawn in about its centre: corner rows end
/// with repeats of the last one, so that loops over them need no rest.
struct PlacedSolid {
  static constexpr std::size_t kRow = 8;
  const Solid* solid = nullptr;
  Vec3 centre = Vec3::Zero();                                   ///< [m]
  double scale = 1.0;                                           ///< of its size [-]
  std::size_t rows = 0;                                         ///< corners, with the repeats
  alignas(64) std::array<double, Solid::kMostCorners> x, y, z;  ///< [m]
  /// Planes: normal . x = offset [m]; inverse depths [1/m] of the whole size.
  /// Rows end with planes that nothing is near to.
  alignas(64) std::array<double, Solid::kMostPlanes> nx, ny, nz, offset, inverse_depth;
  std::size_t plane_rows = 0;

  /// `turn` takes the solid's axes to those that it is seen in.
  void place(const Solid& what, const Mat3& turn, const Vec3& at, double size);
  [[nodiscard]] std::size_t planes() const { return solid->planes().size(); }
  [[nodiscard]] Vec3 corner(int k) const {
    const auto c = static_cast<std::size_t>(k);
    return {x[c], y[c], z[c]};
  }
  [[nodiscard]] Vec3 normal(std::size_t p) const { return {nx[p], ny[p], nz[p]}; }
  /// Strain of the solid at a point: 1 at its centre, 0 on its surface (plane
  /// p's part) [-].
  [[nodiscard]] double strain(std::size_t p, const Vec3& at) const {
    return (offset[p] - nx[p] * at.x() - ny[p] * at.y() - nz[p] * at.z()) * inverse_depth[p];
  }

 private:
  void place_planes(const Mat3& turn);
};

}  // namespace muckpile
