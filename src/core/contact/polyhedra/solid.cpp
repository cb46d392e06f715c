// SPDX-License-Identifier: GPL-2.0-or-later
// A convex polyhedron as contacts need it: planes of its faces, checks, and
// where it is seen. Scope: see the header.
#include "contact/polyhedra/solid.h"

#include <algorithm>
#include <cmath>

#include "args/require.h"

namespace muckpile {
namespace {

constexpr double kShape = 1e-6;        // of the radius: a corner so far outside a plane is none
constexpr double kNoDirection = 1e-9;  // of the radius squared: area of a face without a normal
constexpr double kSamePlane = 1e-9;

}  // namespace

Solid::Solid(const Polyhedron& shape, const Pose& pose) {
  require(shape.vertices.size() <= kMostCorners,
          "contact of polyhedra: a block has too many corners",
          static_cast<double>(shape.vertices.size()));
  for (const Vec3& vertex : shape.vertices) {
    corners_.emplace_back(pose.axes.transpose() * (vertex - pose.centre));
    radius_ = std::max(radius_, corners_.back().norm());
  }
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const FaceGeometry face = face_geometry(shape, static_cast<int>(f));
    if (face.area < kNoDirection * radius_ * radius_) continue;
    const int plane = plane_of(face, pose.centre, pose.axes);
    stiffest_ = std::max(stiffest_, face.area / planes_[static_cast<std::size_t>(plane)].depth);
    const std::vector<int>& corners = shape.faces[f];
    faces_.push_back({plane, static_cast<int>(loop_.size()), static_cast<int>(corners.size())});
    loop_.insert(loop_.end(), corners.begin(), corners.end());
  }
  check();
  least_depth_ = planes_[0].depth;
  for (const Plane& plane : planes_) least_depth_ = std::min(least_depth_, plane.depth);
}

int Solid::plane_of(const FaceGeometry& face, const Vec3& inside, const Mat3& axes) {
  const Vec3 normal = axes.transpose() * face.normal;
  const double depth = face.normal.dot(face.centroid - inside);
  for (std::size_t p = 0; p < planes_.size(); ++p)
    if ((planes_[p].normal - normal).norm() < kSamePlane &&
        std::abs(planes_[p].depth - depth) < kSamePlane * radius_)
      return static_cast<int>(p);
  planes_.push_back({normal, depth});
  return static_cast<int>(planes_.size()) - 1;
}

void Solid::check() const {
  require(planes_.size() <= kMostPlanes, "contact of polyhedra: a block has too many faces",
          static_cast<double>(planes_.size()));
  require(planes_.size() >= 4, "contact of polyhedra: a block must have at least 4 faces",
          static_cast<double>(planes_.size()));
  for (const Plane& plane : planes_) {
    require(plane.depth > 0.0, "contact of polyhedra: a block's centre must lie inside it",
            plane.depth);
    for (const Vec3& corner : corners_)
      require(plane.normal.dot(corner) - plane.depth <= kShape * radius_,
              "contact of polyhedra: a block must be convex, a corner is "
              "outside a face by [m]",
              plane.normal.dot(corner) - plane.depth);
  }
}

double Solid::bytes() const {
  return static_cast<double>(corners_.capacity() * sizeof(Vec3) +
                             planes_.capacity() * sizeof(Plane) + faces_.capacity() * sizeof(Face) +
                             loop_.capacity() * sizeof(int));
}

void PlacedSolid::place(const Solid& what, const Mat3& turn, const Vec3& at, double size) {
  solid = &what;
  centre = at;
  scale = size;
  const std::size_t corners = what.corners().size();
  const Mat3 stretched = size * turn;
  for (std::size_t k = 0; k < corners; ++k) {
    const Vec3 corner = stretched * what.corners()[k] + at;
    x[k] = corner.x();
    y[k] = corner.y();
    z[k] = corner.z();
  }
  rows = (corners + kRow - 1) / kRow * kRow;
  std::fill(x.begin() + static_cast<std::ptrdiff_t>(corners),
            x.begin() + static_cast<std::ptrdiff_t>(rows), x[corners - 1]);
  std::fill(y.begin() + static_cast<std::ptrdiff_t>(corners),
            y.begin() + static_cast<std::ptrdiff_t>(rows), y[corners - 1]);
  std::fill(z.begin() + static_cast<std::ptrdiff_t>(corners),
            z.begin() + static_cast<std::ptrdiff_t>(rows), z[corners - 1]);
  place_planes(turn);
}

void PlacedSolid::place_planes(const Mat3& turn) {
  constexpr double kFar = 1e30;
  plane_rows = (planes() + kRow - 1) / kRow * kRow;
  for (std::size_t p = 0; p < planes(); ++p) {
    const Solid::Plane& plane = solid->planes()[p];
    const Vec3 n = turn * plane.normal;
    nx[p] = n.x();
    ny[p] = n.y();
    nz[p] = n.z();
    offset[p] = scale * plane.depth + n.dot(centre);
    inverse_depth[p] = 1.0 / plane.depth;
  }
  for (std::size_t p = planes(); p < plane_rows; ++p) {
    nx[p] = ny[p] = nz[p] = 0.0;
    offset[p] = kFar;
    inverse_depth[p] = 1.0;
  }
}

}  // namespace muckpile
