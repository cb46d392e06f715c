// SPDX-License-Identifier: GPL-2.0-or-later
// A convex polyhedron about its centre, and the same turned and moved, as
// contacts need them. Scope: body axes and lengths in metres; a shape that
// cannot be a convex body is refused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

/// Where a solid is in space.
struct Pose {
  Vec3 centre;  ///< [m]
  Mat3 axes;    ///< columns: the body's axes
};

/// Numbers that loops take in one go: arrays are filled up to full rows.
inline constexpr std::size_t kRow = 8;

class Solid {
 public:
  static constexpr std::size_t kMostPlanes = 64, kMostCorners = 256;

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
  /// Faces of plane p: from face face_begin(p) to before face_begin(p + 1).
  [[nodiscard]] std::size_t face_begin(std::size_t p) const { return face_begin_[p]; }
  /// Per corner, bit p: it is a corner of a face of plane p. Padded as rows() is.
  [[nodiscard]] const std::vector<std::uint64_t>& planes_of_corner() const {
    return planes_of_corner_;
  }
  /// Corners by coordinate, x, y or z, in full rows that end with repeats of the last one.
  [[nodiscard]] const double* row(std::size_t axis) const { return rows_.data() + axis * count_; }
  [[nodiscard]] std::size_t rows() const { return count_; }
  /// How far it reaches along n, in its own axes [m].
  [[nodiscard]] double reach(const Vec3& n) const;
  [[nodiscard]] double radius() const { return radius_; }            ///< of its farthest corner [m]
  [[nodiscard]] double least_depth() const { return least_depth_; }  ///< of its planes [m]
  /// Greatest area of a face over its depth [m]: stiffness of a contact all
  /// over it, per modulus.
  [[nodiscard]] double stiffest() const { return stiffest_; }
  [[nodiscard]] double bytes() const;

 private:
  int plane_of(const FaceGeometry& face, const Vec3& inside, const Mat3& axes);
  void sort_faces();
  void fill_rows();
  void check() const;

  std::vector<Vec3> corners_;
  std::vector<Plane> planes_;  // those of faces in one plane are one
  std::vector<Face> faces_;
  std::vector<int> loop_;
  std::vector<std::size_t> face_begin_;
  std::vector<std::uint64_t> planes_of_corner_;
  std::vector<double> rows_;
  std::size_t count_ = 0;
  double radius_ = 0.0, least_depth_ = 0.0, stiffest_ = 0.0;
};

/// A solid where another sees it, drawn in about its centre; of its planes only those that count
/// there. Rows of corners end with repeats of the last one, rows of planes with planes that nothing
/// is near to, so that loops over them need no rest.
struct PlacedSolid {
  const Solid* solid = nullptr;
  Vec3 centre = Vec3::Zero();                                   ///< [m]
  double scale = 1.0;                                           ///< of its size [-]
  std::size_t rows = 0;                                         ///< corners, with the repeats
  alignas(64) std::array<double, Solid::kMostCorners> x, y, z;  ///< [m]
  /// Planes: normal . x = offset [m]; inverse depths [1/m] of the whole size.
  alignas(64) std::array<double, Solid::kMostPlanes> nx, ny, nz, offset, inverse_depth;
  std::array<std::size_t, Solid::kMostPlanes> plane;  ///< the solid's number of each
  std::size_t planes = 0, plane_rows = 0;

  /// Corners only. `turn` takes the solid's axes to those that it is seen in.
  void place(const Solid& what, const Mat3& turn, const Vec3& at, double size);
  /// Those of its planes whose bit is set.
  void place_planes(const Mat3& turn, std::uint64_t which);
  /// Puts the plane first that faces n most: it cuts away most of what faces it.
  void lead(const Vec3& n);
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
};

}  // namespace muckpile
