// SPDX-License-Identifier: GPL-2.0-or-later
// Overlap of two convex solids: faces of few corners, all corners of an outline at once.
// Scope: members of OverlapFinder, see its header; what they leave is worked on in
// solid_overlap.cpp.
#include <algorithm>
#include <bit>
#include <limits>

#include "contact/polyhedra/lane_outline.h"
#include "contact/polyhedra/solid_overlap.h"

namespace muckpile {

#if defined(__AVX512F__) && defined(__AVX512VL__)

namespace {

using Left = LaneOutline::Left;

/// Depth below the placed plane p [m].
OutlineLanes depth(const PlacedSolid& s, std::size_t p, const OutlineVec& at) {
  return s.offset[p] - s.nx[p] * at.x - s.ny[p] * at.y - s.nz[p] * at.z;
}
OutlineLanes strain(const PlacedSolid& s, std::size_t p, const OutlineVec& at) {
  return s.inverse_depth[p] * depth(s, p, at);
}

Left cut_by_planes(const PlacedSolid& into, std::uint64_t planes, bool strictly,
                   LaneOutline& outline) {
  for (; planes != 0; planes &= planes - 1) {
    const auto p = static_cast<std::size_t>(std::countr_zero(planes));
    const Left left = outline.cut(depth(into, p, outline.corner()), strictly);
    if (left == Left::nothing || left == Left::unknown) return left;
  }
  return Left::part;
}

}  // namespace

bool OverlapFinder::press_face_in_lanes(const Side& side, std::size_t plane,
                                        const Solid::Face& face, Sums& sums) {
  if (face.count > LaneOutline::kMost) return false;
  const std::span<const int> corners(side.of.solid->loop().data() + face.begin,
                                     static_cast<std::size_t>(face.count));
  std::uint64_t outside_all = ~std::uint64_t{0}, outside = 0;
  for (const int k : corners) {
    const std::uint64_t of_corner = side.bits[static_cast<std::size_t>(k)];
    outside_all &= of_corner;
    outside |= of_corner;
  }
  if (outside_all != 0) return true;
  LaneOutline outline(side.of.x.data(), side.of.y.data(), side.of.z.data(), corners);
  const Left left = cut_by_planes(side.into, outside, side.strictly, outline);
  if (left != Left::part) return left == Left::nothing;
  const Vec3 normal = side.of.normal(plane);
  const OutlineVec along(normal);
  LaneSums of_face;
  if (!press_parts(side.into, outline, along, of_face)) return false;
  const Vec3 start = outline.start();
  if (!has_origin_) origin_ = start;
  has_origin_ = true;
  sums.depth_area += normal.dot(start - origin_) * 0.5 * reduce(outline.twice_area(along));
  const double pressed = reduce(of_face.pressed);
  const Vec3 moment(reduce(of_face.pressed_at.x), reduce(of_face.pressed_at.y),
                    reduce(of_face.pressed_at.z));
  sums.depth_press += (side.of.offset[plane] - normal.dot(side.into.centre)) * pressed;
  overlap_.push += side.sign * pressed * normal;
  overlap_.moment += side.sign * moment.cross(normal);
  lane_sums_.add(of_face);
  return true;
}

/// False: some part must be worked on otherwise.
bool OverlapFinder::press_parts(const PlacedSolid& into, const LaneOutline& outline,
                                const OutlineVec& normal, LaneSums& sums) {
  const std::size_t count = list_nearest(into, outline);
  for (std::size_t own = 0; own < count; ++own) {
    const auto plane = static_cast<std::size_t>(nearest_[own]);
    LaneOutline part = outline;
    Left left = Left::all;
    for (std::size_t j = 0; j < count && left != Left::nothing; ++j) {
      if (own == j) continue;
      const auto other = static_cast<std::size_t>(nearest_[j]);
      const OutlineVec& at = part.corner();
      // What is equally near to two is the first one's.
      left = part.cut(strain(into, other, at) - strain(into, plane, at), j < own);
      if (left == Left::unknown) return false;
    }
    if (left != Left::nothing)
      part.press(strain(into, plane, part.corner()), normal, into.inverse_depth[plane], sums);
  }
  return true;
}

/// As list_nearest() of the outline that is left.
std::size_t OverlapFinder::list_nearest(const PlacedSolid& into, const LaneOutline& outline) {
  double bound = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < into.planes; ++p) {
    const OutlineLanes e = strain(into, p, outline.corner());
    depths_.least[p] = outline.least(e);
    bound = std::min(bound, outline.most(e));
  }
  std::size_t count = 0;
  for (std::size_t p = 0; p < into.planes; ++p)
    if (depths_.least[p] <= bound) nearest_[count++] = static_cast<int>(p);
  return count;
}

void OverlapFinder::sum_lanes() {
  const auto sum = [](const OutlineVec& v) { return Vec3(reduce(v.x), reduce(v.y), reduce(v.z)); };
  overlap_.pressed += reduce(lane_sums_.pressed);
  overlap_.largest_strain = std::max(overlap_.largest_strain, hmax(lane_sums_.largest_strain));
  pressed_at_ += sum(lane_sums_.pressed_at);
  const Vec3 square = sum(lane_sums_.square), mixed = sum(lane_sums_.mixed);
  pressed_square_ += (Mat3() << square.x(), mixed.x(), mixed.z(),  //
                      mixed.x(), square.y(), mixed.y(),            //
                      mixed.z(), mixed.y(), square.z())
                         .finished();
  weight_ += reduce(lane_sums_.weight);
  weight_square_ += reduce(lane_sums_.weight_square);
  weight_at_ += sum(lane_sums_.weight_at);
}

#else

bool OverlapFinder::press_face_in_lanes(const Side& /*side*/, std::size_t /*plane*/,
                                        const Solid::Face& /*face*/, Sums& /*sums*/) {
  return false;
}

void OverlapFinder::sum_lanes() {}

#endif

}  // namespace muckpile
