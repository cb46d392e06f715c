// SPDX-License-Identifier: GPL-2.0-or-later
// Overlap of two convex solids: faces of one are cut by the planes of the
// other, and what is left is pressed by the strain of that one. Scope: see the
// header.
#include "contact/polyhedra/solid_overlap.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace muckpile {
namespace {

/// What lies where `value` is not below 0, or, where `strictly`, above it.
/// Edges are cut where the value, linear along them, is 0.
template <class Outline>
void cut(const Outline& from, const double* value, bool strictly, Outline& to) {
  to.count = 0;
  const auto inside = [strictly](double v) { return strictly ? v > 0.0 : v >= 0.0; };
  for (std::size_t k = 0; k < from.count; ++k) {
    const std::size_t next = k + 1 == from.count ? 0 : k + 1;
    const bool here = inside(value[k]), there = inside(value[next]);
    if (here) to.corner[to.count++] = from.corner[k];
    if (here != there) {
      const double along = value[k] / (value[k] - value[next]);
      to.corner[to.count++] = from.corner[k] + along * (from.corner[next] - from.corner[k]);
    }
  }
}

}  // namespace

void OverlapFinder::place(const Solid& first, const Solid& second, const Mat3& turn,
                          const Vec3& between, double size) {
  first_.place(first, Mat3::Identity(), Vec3::Zero(), size);
  second_.place(second, turn, between, size);
}

double OverlapFinder::work(Vec3& n) {
  overlap_ = {};
  has_origin_ = false;
  weight_ = weight_square_ = 0.0;
  pressed_at_.setZero();
  pressed_square_.setZero();
  weight_at_.setZero();
  Vec3 above_second, above_first;
  const double second_gap = outside_bits(first_, second_, false, bits_first_, above_second);
  const double first_gap = outside_bits(second_, first_, true, bits_second_, above_first);
  const double gap = std::max(first_gap, second_gap);
  if (gap > 0.0) {
    n = first_gap > second_gap ? above_first : Vec3(-above_second);
    return gap;
  }
  const Sums of_first = press_faces({first_, second_, bits_first_, -1.0, false});
  const Sums of_second = press_faces({second_, first_, bits_second_, 1.0, true});
  if (!touching()) return find_gap(first_, second_, n);
  if (overlap_.largest_strain <= kTouch) {
    overlap_ = {};
    return 0.0;
  }
  // Both by the divergence theorem: of x, and of e (x - centre) whose slope
  // along x is e - e(0).
  overlap_.volume = (of_first.depth_area + of_second.depth_area) / 3.0;
  overlap_.energy = (of_first.depth_press + of_second.depth_press +
                     (first_.scale + second_.scale) * overlap_.volume) /
                    4.0;
  finish();
  return 0.0;
}

void OverlapFinder::finish() {
  overlap_.stiffness = weight_;
  overlap_.point = pressed_at_ / overlap_.pressed;
  const Vec3& at = overlap_.point;
  overlap_.spread = pressed_square_ / overlap_.pressed - at * at.transpose();
  overlap_.arm = std::sqrt(std::max(0.0, overlap_.spread.trace()));
  overlap_.mean_square =
      std::max(0.0, (weight_square_ - 2.0 * at.dot(weight_at_)) / weight_ + at.squaredNorm());
}

OverlapFinder::Sums OverlapFinder::press_faces(const Side& side) {
  const PlacedSolid &of = side.of, &into = side.into;
  Sums sums;
  for (const Solid::Face& face : of.solid->faces()) {
    const int* loop = of.solid->loop().data() + face.begin;
    std::uint64_t all = ~std::uint64_t{0}, any = 0;
    for (int k = 0; k < face.count; ++k) {
      const std::uint64_t corner = side.bits[static_cast<std::size_t>(loop[k])];
      all &= corner;
      any |= corner;
    }
    if (all != 0 || !cut_face(side, face, any)) continue;
    const auto plane = static_cast<std::size_t>(face.plane);
    Vec3 twice = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < outline_.count; ++k)
      twice += (outline_.corner[k] - outline_.corner[0])
                   .cross(outline_.corner[k + 1] - outline_.corner[0]);
    if (!has_origin_) origin_ = outline_.corner[0];
    has_origin_ = true;
    sums.depth_area +=
        of.normal(plane).dot(outline_.corner[0] - origin_) * 0.5 * twice.dot(of.normal(plane));
    const double pressed = press_outline(into, of.normal(plane), side.sign);
    sums.depth_press += (of.offset[plane] - of.normal(plane).dot(into.centre)) * pressed;
  }
  return sums;
}

/// Leaves in outline_ what of the face is inside the other solid; false:
/// nothing.
bool OverlapFinder::cut_face(const Side& side, const Solid::Face& face, std::uint64_t cutting) {
  const PlacedSolid& into = side.into;
  const int* loop = side.of.solid->loop().data() + face.begin;
  outline_.count = static_cast<std::size_t>(face.count);
  for (std::size_t k = 0; k < outline_.count; ++k) outline_.corner[k] = side.of.corner(loop[k]);
  for (; cutting != 0; cutting &= cutting - 1) {
    const auto p = static_cast<std::size_t>(std::countr_zero(cutting));
    for (std::size_t k = 0; k < outline_.count; ++k) {
      const Vec3& at = outline_.corner[k];
      value_[k] = into.offset[p] - into.nx[p] * at.x() - into.ny[p] * at.y() - into.nz[p] * at.z();
    }
    Outline& left = spare_[0];
    cut(outline_, value_.data(), side.strictly, left);
    if (left.count < 3) return false;
    std::copy_n(left.corner.begin(), left.count, outline_.corner.begin());
    outline_.count = left.count;
  }
  return true;
}

/// Planes of `into` whose strain may be the least somewhere on the outline.
std::size_t OverlapFinder::list_nearest(const PlacedSolid& into) {
  constexpr std::size_t kRow = PlacedSolid::kRow;
  alignas(64) std::array<double, Solid::kMostPlanes> low;
  double bound = std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < into.plane_rows; row += kRow) {
    alignas(64) std::array<double, kRow> least, most;
    least.fill(std::numeric_limits<double>::infinity());
    most.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < outline_.count; ++k) {
      const double x = outline_.corner[k].x(), y = outline_.corner[k].y(),
                   z = outline_.corner[k].z();
      for (std::size_t j = 0; j < kRow; ++j) {
        const std::size_t p = row + j;
        const double e = (into.offset[p] - into.nx[p] * x - into.ny[p] * y - into.nz[p] * z) *
                         into.inverse_depth[p];
        least[j] = std::min(least[j], e);
        most[j] = std::max(most[j], e);
      }
    }
    for (std::size_t j = 0; j < kRow; ++j) {
      low[row + j] = least[j];
      bound = std::min(bound, most[j]);
    }
  }
  std::size_t count = 0;
  for (std::size_t p = 0; p < into.planes(); ++p)
    if (low[p] <= bound) nearest_[count++] = static_cast<int>(p);
  return count;
}

/// Integral of the strain over the outline [m2].
double OverlapFinder::press_outline(const PlacedSolid& into, const Vec3& normal, double sign) {
  const std::size_t count = list_nearest(into);
  double pressed = 0.0;
  for (std::size_t own = 0; own < count; ++own) {
    const Outline& part = count == 1 ? outline_ : nearest_part(into, own, count);
    if (part.count >= 3)
      pressed += press_part(part, into, static_cast<std::size_t>(nearest_[own]), normal, sign);
  }
  return pressed;
}

/// Where on the outline the strain of the one plane is the least of those
/// listed.
const OverlapFinder::Outline& OverlapFinder::nearest_part(const PlacedSolid& into, std::size_t own,
                                                          std::size_t count) {
  const auto plane = static_cast<std::size_t>(nearest_[own]);
  const Outline* from = &outline_;
  for (std::size_t j = 0; j < count && from->count >= 3; ++j) {
    if (own == j) continue;
    const auto other = static_cast<std::size_t>(nearest_[j]);
    for (std::size_t k = 0; k < from->count; ++k)
      value_[k] = into.strain(other, from->corner[k]) - into.strain(plane, from->corner[k]);
    Outline& to = spare_[from == &spare_[0] ? 1 : 0];
    cut(*from, value_.data(), j < own,
        to);  // what is equally near to two is the first one's
    from = &to;
  }
  return *from;
}

/// The part of an outline where the plane's strain is the least, in triangles.
double OverlapFinder::press_part(const Outline& part, const PlacedSolid& into, std::size_t plane,
                                 const Vec3& normal, double sign) {
  const Vec3& a = part.corner[0];
  const double e_a = into.strain(plane, a);
  double e_b = into.strain(plane, part.corner[1]), pressed = 0.0;
  overlap_.largest_strain = std::max({overlap_.largest_strain, e_a, e_b});
  Vec3 moment = Vec3::Zero();  // strain times place
  for (std::size_t k = 2; k < part.count; ++k) {
    const Vec3 &b = part.corner[k - 1], &c = part.corner[k];
    const double e_c = into.strain(plane, c);
    overlap_.largest_strain = std::max(overlap_.largest_strain, e_c);
    const double area = 0.5 * normal.dot((b - a).cross(c - a));
    if (area > 0.0) {
      press_triangle({a, b, c}, {e_a, e_b, e_c}, area, area * into.inverse_depth[plane], moment);
      pressed += area * (e_a + e_b + e_c) / 3.0;
    }
    e_b = e_c;
  }
  overlap_.pressed += pressed;
  pressed_at_ += moment;
  overlap_.push += sign * pressed * normal;
  overlap_.moment += sign * moment.cross(normal);
  return pressed;
}

void OverlapFinder::press_triangle(const std::array<Vec3, 3>& corners,
                                   const std::array<double, 3>& strains, double area, double weight,
                                   Vec3& moment) {
  const auto& [a, b, c] = corners;
  const double all = strains[0] + strains[1] + strains[2];
  const Vec3 sum = a + b + c;
  moment += area / 12.0 * (all * sum + strains[0] * a + strains[1] * b + strains[2] * c);
  // Integrals of e x x^T and of x x^T, e linear, over the triangle.
  const Vec3 pulled = strains[0] * a + strains[1] * b + strains[2] * c;
  const Mat3 mixed = pulled * sum.transpose();
  pressed_square_ +=
      area / 60.0 *
      (all * sum * sum.transpose() + mixed + mixed.transpose() +
       (all + 2.0 * strains[0]) * a * a.transpose() + (all + 2.0 * strains[1]) * b * b.transpose() +
       (all + 2.0 * strains[2]) * c * c.transpose());
  const double square =
      (a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + sum.squaredNorm()) / 12.0;
  weight_ += weight;
  weight_at_ += weight / 3.0 * sum;
  weight_square_ += weight * square;
}

}  // namespace muckpile
