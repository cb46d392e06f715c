// SPDX-License-Identifier: GPL-2.0-or-later
// A convex cell around the origin as corners between three planes each.
// Scope: see the header.
#include "geometry/cut/lane_cell.h"

#include <algorithm>
#include <bit>
#include <experimental/simd>

#include "math/lanes.h"

namespace muckpile {
namespace {

using Native = std::experimental::native_simd<double>;
constexpr std::size_t kWidth = kNativeLanes;

Native native(const double* from) { return {from, std::experimental::vector_aligned}; }

}  // namespace

void LaneCell::place(std::size_t corner, const Vec3& at, Number a, Number b, Number c) {
  x_[corner] = at.x();
  y_[corner] = at.y();
  z_[corner] = at.z();
  around_[corner] = {a, b, c};
  corner_[a][b] = corner_[b][c] = corner_[c][a] = static_cast<Number>(corner);
}

void LaneCell::start(const Vec3& lo, const Vec3& hi) {
  std::fill(x_.begin(), x_.begin() + static_cast<std::ptrdiff_t>(corners_), 0.0);
  std::fill(y_.begin(), y_.begin() + static_cast<std::ptrdiff_t>(corners_), 0.0);
  std::fill(z_.begin(), z_.begin() + static_cast<std::ptrdiff_t>(corners_), 0.0);
  planes_ = kWalls;  // those across x, y, z at lo, and at hi
  for (int axis = 0; axis < 3; ++axis) {
    foot_[static_cast<std::size_t>(axis)] = lo[axis] * Vec3::Unit(axis);
    foot_[static_cast<std::size_t>(axis + 3)] = hi[axis] * Vec3::Unit(axis);
    numbers_[static_cast<std::size_t>(axis)] = -1 - 2 * axis;
    numbers_[static_cast<std::size_t>(axis + 3)] = -2 - 2 * axis;
  }
  corners_ = 0;
  for (unsigned k = 0; k < 8; ++k) {
    const bool right = (k & 1u) != 0, behind = (k & 2u) != 0, above = (k & 4u) != 0;
    const Vec3 at(right ? hi.x() : lo.x(), behind ? hi.y() : lo.y(), above ? hi.z() : lo.z());
    Number a = right ? 3 : 0, b = behind ? 4 : 1;
    const Number c = above ? 5 : 2;
    if (right ^ behind ^ above ^ true) std::swap(a, b);  // a mirrored corner turns the other way
    place(corners_++, at, a, b, c);
  }
}

std::uint64_t LaneCell::corners_beyond(const Vec3& normal, double offset) {
  const Native nx = normal.x(), ny = normal.y(), nz = normal.z();
  std::uint64_t beyond = 0;
  for (std::size_t k = 0; k < corners_; k += kWidth) {
    const Native height = nx * native(&x_[k]) + ny * native(&y_[k]) + nz * native(&z_[k]) - offset;
    height.copy_to(&height_[k], std::experimental::vector_aligned);
    beyond |= static_cast<std::uint64_t>(bits_of<Native>(height > 0.0)) << k;
  }
  return beyond;
}

bool LaneCell::find_rim(std::uint64_t beyond) {
  std::array<Number, kMost> after;
  std::uint64_t met = 0;
  rim_edges_ = 0;
  for (std::uint64_t left = beyond; left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    for (std::size_t e = 0; e < 3; ++e) {
      const Number a = around_[k][e], b = around_[k][e == 2 ? 0 : e + 1];
      const Number other = corner_[b][a];
      if ((beyond >> other & 1u) != 0) continue;
      if ((met >> a & 1u) != 0) return false;
      met |= std::uint64_t{1} << a;
      after[a] = b;
      rim_[rim_edges_++] = {a, b, static_cast<Number>(k), other};
    }
  }
  if (rim_edges_ < 3) return false;
  Number plane = rim_[0].a;
  for (std::size_t k = 1; k < rim_edges_; ++k) {
    plane = after[plane];
    if ((met >> plane & 1u) == 0 || plane == rim_[0].a) return false;
  }
  return after[plane] == rim_[0].a;
}

void LaneCell::move_last_to(std::size_t corner) {
  const std::size_t last = --corners_;
  const auto [a, b, c] = around_[last];
  if (corner != last) place(corner, Vec3(x_[last], y_[last], z_[last]), a, b, c);
  x_[last] = y_[last] = z_[last] = 0.0;
}

bool LaneCell::cut(const Vec3& normal, double offset, int number) {
  if (!(offset > 0.0)) return false;
  const std::uint64_t beyond = corners_beyond(normal, offset);
  if (beyond == 0) return true;
  const auto going = static_cast<std::size_t>(std::popcount(beyond));
  if (planes_ == kMost || !find_rim(beyond) || corners_ + rim_edges_ - going > kMost) return false;
  std::array<Vec3, kMost> at;
  for (std::size_t k = 0; k < rim_edges_; ++k) {
    const std::size_t from = rim_[k].goes, to = rim_[k].stays;
    const double t = height_[from] / (height_[from] - height_[to]);
    at[k] = Vec3(x_[from] + t * (x_[to] - x_[from]), y_[from] + t * (y_[to] - y_[from]),
                 z_[from] + t * (z_[to] - z_[from]));
  }
  const auto plane = static_cast<Number>(planes_);
  foot_[planes_] = offset / normal.squaredNorm() * normal;
  numbers_[planes_++] = number;
  std::uint64_t free = beyond;
  for (std::size_t k = 0; k < rim_edges_; ++k) {
    const std::size_t slot =
        free != 0 ? static_cast<std::size_t>(std::countr_zero(free)) : corners_++;
    free &= free - 1;
    place(slot, at[k], rim_[k].a, rim_[k].b, plane);
  }
  while (free != 0) {
    const auto slot = kMost - 1 - static_cast<std::size_t>(std::countl_zero(free));
    free &= ~(std::uint64_t{1} << slot);
    move_last_to(slot);
  }
  return true;
}

std::uint64_t LaneCell::planes_with_faces() const {
  std::uint64_t seen = 0;
  for (std::size_t k = 0; k < corners_; ++k)
    for (const Number plane : around_[k]) seen |= std::uint64_t{1} << plane;
  return seen;
}

void LaneCell::extract(const Vec3& centre, Polyhedron& shape, std::vector<int>& behind) const {
  shape.vertices.clear();
  shape.faces.clear();
  behind.clear();
  std::array<Number, kMost> corner_at;  // one of each plane
  for (std::size_t k = 0; k < corners_; ++k) {
    shape.vertices.push_back(centre + Vec3(x_[k], y_[k], z_[k]));
    for (const Number plane : around_[k]) corner_at[plane] = static_cast<Number>(k);
  }
  for (std::uint64_t left = planes_with_faces(); left != 0; left &= left - 1) {
    const auto plane = static_cast<std::size_t>(std::countr_zero(left));
    behind.push_back(numbers_[plane]);
    std::vector<int>& face = shape.faces.emplace_back();
    Number corner = corner_at[plane];
    do {  // the next corner is over the plane that comes before this one
      face.push_back(corner);
      const auto [a, b, c] = around_[corner];
      corner = corner_[plane][plane == a ? c : plane == b ? a : b];
    } while (corner != corner_at[plane]);
  }
}

double LaneCell::farthest2() const {
  Native most = 0.0;
  for (std::size_t k = 0; k < corners_; k += kWidth) {
    const Native x = native(&x_[k]), y = native(&y_[k]), z = native(&z_[k]);
    most = max(most, x * x + y * y + z * z);
  }
  return hmax(most);
}

// The cell in tetrahedra of the origin, the foot of the perpendicular to a face, and an edge of it:
// two for each edge, of volumes that may be negative.
LaneCell::Measure LaneCell::measure() const {
  double volume = 0.0;
  Vec3 moment = Vec3::Zero();
  for (std::size_t k = 0; k < corners_; ++k) {
    const Vec3 from(x_[k], y_[k], z_[k]);
    for (std::size_t e = 0; e < 3; ++e) {
      const Number a = around_[k][e], b = around_[k][e == 2 ? 0 : e + 1];
      const std::size_t other = corner_[b][a];
      if (other < k) continue;
      const Vec3 to(x_[other], y_[other], z_[other]);
      const Vec3 across = from.cross(to), ends = from + to;
      const double of_a = -foot_[a].dot(across), of_b = foot_[b].dot(across);
      volume += of_a + of_b;
      moment += of_a * foot_[a] + of_b * foot_[b] + (of_a + of_b) * ends;
    }
  }
  return {volume / 6.0, moment / (4.0 * volume)};
}

}  // namespace muckpile
