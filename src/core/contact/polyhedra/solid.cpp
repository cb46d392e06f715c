// SPDX-License-Identifier: GPL-2.0-or-later
// A convex polyhedron as contacts need it: planes of its faces, checks, and
// where it is seen. Scope: see the header.
#include "contact/polyhedra/solid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "args/require.h"

namespace muckpile {
namespace {

constexpr double kShape = 1e-6;        // of the radius: a corner so far outside a plane is none
constexpr double kNoDirection = 1e-9;  // of the radius squared: area of a face without a normal
constexpr double kSamePlane = 1e-9;
/// "contact of polyhedra: a block may have 64 faces at most; ..."
std::string too_many(std::size_t most, const char* what) {
  return "contact of polyhedra: a block may have " + std::to_string(most) + ' ' + what +
         " at most; take spheres for blocks that natural joints or the cut give more";
}

}  // namespace

Solid::Solid(const Polyhedron& shape, const Pose& pose) {
  require(shape.vertices.size() <= kMostCorners, too_many(kMostCorners, "corners"),
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
  sort_faces();
  fill_rows();
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
  require(planes_.size() <= kMostPlanes, too_many(kMostPlanes, "faces"),
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

/// Plane by plane.
void Solid::sort_faces() {
  std::stable_sort(faces_.begin(), faces_.end(),
                   [](const Face& a, const Face& b) { return a.plane < b.plane; });
  face_begin_.assign(planes_.size() + 1, 0);
  for (const Face& face : faces_) ++face_begin_[static_cast<std::size_t>(face.plane) + 1];
  for (std::size_t p = 0; p < planes_.size(); ++p) face_begin_[p + 1] += face_begin_[p];
}

void Solid::fill_rows() {
  count_ = (corners_.size() + kRow - 1) / kRow * kRow;
  planes_of_corner_.assign(count_, 0);
  for (const Face& face : faces_)
    for (int k = face.begin; k < face.begin + face.count; ++k)
      planes_of_corner_[static_cast<std::size_t>(loop_[static_cast<std::size_t>(k)])] |=
          std::uint64_t{1} << face.plane;
  rows_.resize(3 * count_);
  for (std::size_t k = 0; k < count_; ++k) {
    const Vec3& corner = corners_[std::min(k, corners_.size() - 1)];
    for (std::size_t axis = 0; axis < 3; ++axis)
      rows_[axis * count_ + k] = corner[static_cast<Eigen::Index>(axis)];
  }
}

double Solid::reach(const Vec3& n) const {
  std::array<double, kRow> high;
  high.fill(-std::numeric_limits<double>::infinity());
  const double *x = row(0), *y = row(1), *z = row(2);
  for (std::size_t k = 0; k < count_; k += kRow)
    for (std::size_t j = 0; j < kRow; ++j)
      high[j] = std::max(high[j], n.x() * x[k + j] + n.y() * y[k + j] + n.z() * z[k + j]);
  return *std::max_element(high.begin(), high.end());
}

double Solid::bytes() const {
  return static_cast<double>(corners_.capacity() * sizeof(Vec3) +
                             planes_.capacity() * sizeof(Plane) + faces_.capacity() * sizeof(Face) +
                             loop_.capacity() * sizeof(int) + rows_.capacity() * sizeof(double) +
                             planes_of_corner_.capacity() * sizeof(std::uint64_t) +
                             face_begin_.capacity() * sizeof(std::size_t));
}

void PlacedSolid::place(const Solid& what, const Mat3& turn, const Vec3& at, double size) {
  solid = &what;
  centre = at;
  scale = size;
  rows = what.rows();
  const Mat3 m = size * turn;
  const double *from_x = what.row(0), *from_y = what.row(1), *from_z = what.row(2);
  for (std::size_t k = 0; k < rows; k += kRow)
    for (std::size_t j = k; j < k + kRow; ++j) {
      x[j] = m(0, 0) * from_x[j] + m(0, 1) * from_y[j] + m(0, 2) * from_z[j] + at.x();
      y[j] = m(1, 0) * from_x[j] + m(1, 1) * from_y[j] + m(1, 2) * from_z[j] + at.y();
      z[j] = m(2, 0) * from_x[j] + m(2, 1) * from_y[j] + m(2, 2) * from_z[j] + at.z();
    }
}

void PlacedSolid::place_planes(const Mat3& turn, std::uint64_t which) {
  constexpr double kFar = 1e30;
  planes = 0;
  for (; which != 0; which &= which - 1) {
    const auto p = static_cast<std::size_t>(std::countr_zero(which));
    const Solid::Plane& own = solid->planes()[p];
    const Vec3 n = turn * own.normal;
    plane[planes] = p;
    nx[planes] = n.x();
    ny[planes] = n.y();
    nz[planes] = n.z();
    offset[planes] = scale * own.depth + n.dot(centre);
    inverse_depth[planes++] = 1.0 / own.depth;
  }
  plane_rows = (planes + kRow - 1) / kRow * kRow;
  for (std::size_t p = planes; p < plane_rows; ++p) {
    nx[p] = ny[p] = nz[p] = 0.0;
    offset[p] = kFar;
    inverse_depth[p] = 1.0;
  }
}

void PlacedSolid::lead(const Vec3& n) {
  std::size_t best = 0;
  for (std::size_t p = 1; p < planes; ++p)
    if (normal(p).dot(n) > normal(best).dot(n)) best = p;
  for (auto* const values : {&nx, &ny, &nz, &offset, &inverse_depth})
    std::swap((*values)[0], (*values)[best]);
  std::swap(plane[0], plane[best]);
}

}  // namespace muckpile
