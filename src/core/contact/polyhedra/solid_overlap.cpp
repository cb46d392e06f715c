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
  turn_ = turn;
  first_.place(first, Mat3::Identity(), Vec3::Zero(), size);
  second_.place(second, turn, between, size);
}

void OverlapFinder::clear() {
  overlap_ = {};
  has_origin_ = false;
  weight_ = weight_square_ = 0.0;
  pressed_at_.setZero();
  pressed_square_.setZero();
  weight_at_.setZero();
  lane_sums_ = {};
}

double OverlapFinder::work(Vec3& n) {
  clear();
  along_first_.look(first_, n);
  along_second_.look(second_, n);
  const double gap = along_second_.low - along_first_.high;
  if (gap > 0.0) return gap;
  place_planes_in_slab(n);
  mark_outside(first_, second_, false, bits_first_);
  mark_outside(second_, first_, true, bits_second_);
  const Sums of_first = press_faces({first_, second_, bits_first_, -1.0, false});
  const Sums of_second = press_faces({second_, first_, bits_second_, 1.0, true});
  if (in_lanes_) sum_lanes();
  if (!touching()) return search_gap(n);
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

/// All planes if a centre lies in the slab.
void OverlapFinder::place_planes_in_slab(const Vec3& n) {
  std::uint64_t first = ~std::uint64_t{0} >> (64 - first_.solid->planes().size());
  std::uint64_t second = ~std::uint64_t{0} >> (64 - second_.solid->planes().size());
  const double low = along_second_.low, high = along_first_.high;
  if (n.dot(first_.centre) < low && n.dot(second_.centre) > high) {
    first &= along_first_.planes_above(first_, low);
    second &= along_second_.planes_below(second_, high);
  }
  first_.place_planes(Mat3::Identity(), first);
  first_.lead(n);
  second_.place_planes(turn_, second);
  second_.lead(-n);
}

double OverlapFinder::search_gap(Vec3& n) {
  first_.place_planes(Mat3::Identity(), ~std::uint64_t{0} >> (64 - first_.solid->planes().size()));
  second_.place_planes(turn_, ~std::uint64_t{0} >> (64 - second_.solid->planes().size()));
  Vec3 above_first = n, above_second = n;
  const double first_gap = gap_above_planes(second_, first_, above_first);
  const double second_gap = gap_above_planes(first_, second_, above_second);
  const double gap = std::max(first_gap, second_gap);
  if (!(gap > 0.0)) return find_gap(first_, second_, n);
  n = first_gap > second_gap ? above_first : Vec3(-above_second);
  return gap;
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
  const Solid& solid = *side.of.solid;
  Sums sums;
  for (std::size_t p = 0; p < side.of.planes; ++p) {
    const std::size_t plane = side.of.plane[p];
    for (std::size_t f = solid.face_begin(plane); f < solid.face_begin(plane + 1); ++f)
      if (!in_lanes_ || !press_face_in_lanes(side, p, solid.faces()[f], sums))
        press_face(side, p, solid.faces()[f], sums);
  }
  return sums;
}

void OverlapFinder::press_face(const Side& side, std::size_t plane, const Solid::Face& face,
                               Sums& sums) {
  if (!cut_face(side, face)) return;
  const PlacedSolid& of = side.of;
  const Outline& outline = faces_[outline_];
  const Vec3 &start = outline.corner[0], normal = of.normal(plane);
  Vec3 twice = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < outline.count; ++k)
    twice += (outline.corner[k] - start).cross(outline.corner[k + 1] - start);
  if (!has_origin_) origin_ = start;
  has_origin_ = true;
  sums.depth_area += normal.dot(start - origin_) * 0.5 * twice.dot(normal);
  const double pressed = press_outline(side.into, normal, side.sign);
  sums.depth_press += (of.offset[plane] - normal.dot(side.into.centre)) * pressed;
}

/// Leaves in faces_[outline_] what of the face is inside the other solid; false:
/// nothing.
bool OverlapFinder::cut_face(const Side& side, const Solid::Face& face) {
  const int* loop = side.of.solid->loop().data() + face.begin;
  std::uint64_t all = ~std::uint64_t{0}, any = 0;
  for (int k = 0; k < face.count; ++k) {
    const std::uint64_t corner = side.bits[static_cast<std::size_t>(loop[k])];
    all &= corner;
    any |= corner;
  }
  if (all != 0) return false;
  outline_ = 0;
  Outline& outline = faces_[0];
  outline.count = static_cast<std::size_t>(face.count);
  for (std::size_t k = 0; k < outline.count; ++k) outline.corner[k] = side.of.corner(loop[k]);
  for (; any != 0; any &= any - 1)
    if (!cut_outline(side, static_cast<std::size_t>(std::countr_zero(any)))) return false;
  find_depths(side.into);
  return true;
}

/// Of the outline that is left.
void OverlapFinder::find_depths(const PlacedSolid& into) {
  const Outline& outline = faces_[outline_];
  for (std::size_t row = 0; row < into.plane_rows; row += kRow) {
    std::array<double, kRow> least, most;
    least.fill(std::numeric_limits<double>::infinity());
    most.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < outline.count; ++k) {
      const double x = outline.corner[k].x(), y = outline.corner[k].y(), z = outline.corner[k].z();
      for (std::size_t j = 0; j < kRow; ++j) {
        const std::size_t p = row + j;
        const double depth = into.offset[p] - into.nx[p] * x - into.ny[p] * y - into.nz[p] * z;
        least[j] = std::min(least[j], depth);
        most[j] = std::max(most[j], depth);
      }
    }
    std::copy_n(least.begin(), kRow, depths_.least.begin() + static_cast<std::ptrdiff_t>(row));
    std::copy_n(most.begin(), kRow, depths_.most.begin() + static_cast<std::ptrdiff_t>(row));
  }
}

/// By one plane; false: nothing is left.
bool OverlapFinder::cut_outline(const Side& side, std::size_t p) {
  const PlacedSolid& into = side.into;
  const Outline& outline = faces_[outline_];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < outline.count; ++k) {
    const Vec3& at = outline.corner[k];
    value_[k] = into.offset[p] - into.nx[p] * at.x() - into.ny[p] * at.y() - into.nz[p] * at.z();
    least = std::min(least, value_[k]);
  }
  if (side.strictly ? least > 0.0 : least >= 0.0) return true;
  outline_ = 1 - outline_;
  cut(outline, value_.data(), side.strictly, faces_[outline_]);
  return faces_[outline_].count >= 3;
}

/// Planes of `into` whose strain may be the least somewhere on the outline: those of the last
/// find_depths().
std::size_t OverlapFinder::list_nearest(const PlacedSolid& into) {
  double bound = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < into.planes; ++p)
    bound = std::min(bound, depths_.most[p] * into.inverse_depth[p]);
  std::size_t count = 0;
  for (std::size_t p = 0; p < into.planes; ++p)
    if (depths_.least[p] * into.inverse_depth[p] <= bound) nearest_[count++] = static_cast<int>(p);
  return count;
}

/// Integral of the strain over the outline [m2].
double OverlapFinder::press_outline(const PlacedSolid& into, const Vec3& normal, double sign) {
  const std::size_t count = list_nearest(into);
  double pressed = 0.0;
  for (std::size_t own = 0; own < count; ++own) {
    const Outline& part = count == 1 ? faces_[outline_] : nearest_part(into, own, count);
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
  const Outline* from = &faces_[outline_];
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
