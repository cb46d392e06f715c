// SPDX-License-Identifier: GPL-2.0-or-later
// Overlap of two convex solids: faces of one are cut by the planes of the other, and what is left
// is pressed by the strain of that one.
// Scope: see the header.
#include "contact/polyhedra/solid_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muckpile {
namespace {

/// What lies where `value` is not below 0, or, where `strictly`, above it. Edges are cut where the
/// value, linear along them, is 0.
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
  count_ = 0;
  pressed_ = weight_ = weight_square_ = 0.0;
  pressed_at_.setZero();
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
  if (count_ == 0) return find_gap(first_, second_, n);
  // Both by the divergence theorem: of x, and of e (x - centre) whose slope along x is e - e(0).
  overlap_.volume = (of_first.depth_area + of_second.depth_area) / 3.0;
  overlap_.energy = (of_first.depth_press + of_second.depth_press +
                     (first_.scale + second_.scale) * overlap_.volume) /
                    4.0;
  finish();
  return 0.0;
}

void OverlapFinder::finish() {
  overlap_.stiffness = weight_;
  if (!(pressed_ > 0.0)) return;
  overlap_.point = pressed_at_ / pressed_;
  const Vec3& at = overlap_.point;
  overlap_.mean_square = std::max(
      0.0, weight_square_ / weight_ - 2.0 * at.dot(weight_at_) / weight_ + at.squaredNorm());
  double arm = 0.0;
  for (const PressedPiece& piece : *this) arm += piece.push.norm() * (piece.point - at).norm();
  overlap_.arm = arm / pressed_;
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
    sums.depth_area += of.offset[plane] * 0.5 * twice.dot(of.normal[plane]);
    const double pressed = press_outline(into, of.normal[plane], side.sign);
    sums.depth_press += (of.offset[plane] - of.normal[plane].dot(into.centre)) * pressed;
  }
  return sums;
}

/// Leaves in outline_ what of the face is inside the other solid; false: nothing.
bool OverlapFinder::cut_face(const Side& side, const Solid::Face& face, std::uint64_t cutting) {
  const PlacedSolid &of = side.of, &into = side.into;
  const int* loop = of.solid->loop().data() + face.begin;
  outline_.count = static_cast<std::size_t>(face.count);
  for (std::size_t k = 0; k < outline_.count; ++k) outline_.corner[k] = of.corner(loop[k]);
  for (std::size_t p = 0; cutting != 0; ++p, cutting >>= 1) {
    if ((cutting & 1) == 0) continue;
    for (std::size_t k = 0; k < outline_.count; ++k)
      value_[k] = into.offset[p] - into.normal[p].dot(outline_.corner[k]);
    cut(outline_, value_.data(), side.strictly, spare_);
    if (spare_.count < 3) return false;
    std::swap_ranges(outline_.corner.begin(),
                     outline_.corner.begin() + static_cast<std::ptrdiff_t>(spare_.count),
                     spare_.corner.begin());
    outline_.count = spare_.count;
  }
  return true;
}

/// Planes of `into` whose strain may be the least somewhere on the outline.
std::size_t OverlapFinder::list_nearest(const PlacedSolid& into) {
  std::array<double, Solid::kMostPlanes> low;
  double bound = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < into.planes(); ++p) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t k = 0; k < outline_.count; ++k) {
      const double e = into.strain(p, outline_.corner[k]);
      least = std::min(least, e);
      most = std::max(most, e);
    }
    low[p] = least;
    bound = std::min(bound, most);
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
  for (std::size_t i = 0; i < count; ++i) {
    const auto own = static_cast<std::size_t>(nearest_[i]);
    part_.count = outline_.count;
    std::copy_n(outline_.corner.begin(), outline_.count, part_.corner.begin());
    for (std::size_t j = 0; j < count && part_.count >= 3; ++j) {
      if (i == j) continue;
      const auto other = static_cast<std::size_t>(nearest_[j]);
      for (std::size_t k = 0; k < part_.count; ++k)
        value_[k] = into.strain(other, part_.corner[k]) - into.strain(own, part_.corner[k]);
      cut(part_, value_.data(), j < i, spare_);  // what is equally near to two is the first one's
      std::copy_n(spare_.corner.begin(), spare_.count, part_.corner.begin());
      part_.count = spare_.count;
    }
    if (part_.count >= 3) pressed += press_part(part_, into, own, normal, sign);
  }
  return pressed;
}

/// The part of an outline where the plane's strain is the least, in triangles about its middle.
double OverlapFinder::press_part(const Outline& part, const PlacedSolid& into, std::size_t plane,
                                 const Vec3& normal, double sign) {
  Vec3 middle = Vec3::Zero();
  for (std::size_t k = 0; k < part.count; ++k) middle += part.corner[k];
  middle /= static_cast<double>(part.count);
  const double at_middle = into.strain(plane, middle);
  double pressed = 0.0, before = into.strain(plane, part.corner[part.count - 1]);
  for (std::size_t k = 0; k < part.count; ++k) {
    const Vec3& a = part.corner[k == 0 ? part.count - 1 : k - 1];
    const Vec3& b = part.corner[k];
    const double e_a = before, e_b = into.strain(plane, b);
    before = e_b;
    overlap_.largest_strain = std::max(overlap_.largest_strain, e_b);
    const double area = 0.5 * normal.dot((a - middle).cross(b - middle));
    const double all = at_middle + e_a + e_b, press = area * all / 3.0;  // integral of e
    if (!(press > 0.0)) continue;
    const Vec3 sum = middle + a + b;
    const Vec3 moment = area / 12.0 * (all * sum + at_middle * middle + e_a * a + e_b * b);
    const Vec3 point = moment / press, push = sign * press * normal;
    const double weight = area * into.inverse_depth[plane];
    weight_ += weight;
    weight_at_ += weight / 3.0 * sum;
    weight_square_ += weight / 3.0 * (middle.squaredNorm() + a.squaredNorm() + b.squaredNorm());
    pressed += press;
    pressed_at_ += moment;
    overlap_.push += push;
    overlap_.moment += point.cross(push);
    if (count_ < kMostPieces) pieces_[count_++] = {point, push};
  }
  pressed_ += pressed;
  return pressed;
}

}  // namespace muckpile
