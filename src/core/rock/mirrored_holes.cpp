// SPDX-License-Identifier: GPL-2.0-or-later
// Charges on symmetry planes: how much of each crushed zone is modelled.
// Scope: see the header.
#include "rock/mirrored_holes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "args/input_error.h"

namespace muckpile {
namespace {

struct Mirror {
  Vec3 point;   // [m]
  Vec3 normal;  // unit, out of the rock

  [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p - point); }
};

constexpr double kNear = 1e-5;  // of a radius, or of 1 for a normal: text and rounding of faces

/// Per hole, the different mirror planes of the blocks on its crushed zone.
std::vector<std::vector<Mirror>> mirrors_at(const std::vector<Hole>& holes,
                                            const std::vector<Block>& blocks, int first_tag,
                                            const FacetSet& set) {
  std::vector<std::vector<Mirror>> found(holes.size());
  for (const Facet& facet : set.facets) {
    if (facet.kind != FacetKind::mirror) continue;
    const Block& block = blocks[static_cast<std::size_t>(facet.tag_i - first_tag)];
    const Mirror mirror{block.mass.centroid + facet.arm_i, facet.normal};
    for (const int code : block.neighbour) {
      if (!is_hole_face(code)) continue;
      const auto h = static_cast<std::size_t>(hole_of_face(code));
      const auto same = [&](const Mirror& other) {
        return (other.normal - mirror.normal).norm() < kNear &&
               std::abs(other.height(mirror.point)) < kNear * holes[h].radius;
      };
      if (std::ranges::none_of(found[h], same)) found[h].push_back(mirror);
    }
  }
  return found;
}

bool holds_axis(const Mirror& mirror, const Hole& hole) {
  const double most =
      std::max(std::abs(mirror.height(hole.toe)), std::abs(mirror.height(hole.collar)));
  return most <= kNear * hole.radius;
}

/// Whether part of the cylinder lies behind the mirror.
bool cuts(const Mirror& mirror, const Hole& hole) {
  const double along = mirror.normal.dot((hole.collar - hole.toe).normalized());
  const double sideways = hole.radius * std::sqrt(std::max(0.0, 1.0 - along * along));
  const double farthest = std::max(mirror.height(hole.toe), mirror.height(hole.collar)) + sideways;
  return farthest > kNear * hole.radius;
}

[[noreturn]] void refuse_cut(std::size_t h, const Mirror& mirror, const Hole& hole) {
  std::ostringstream text;
  text << "the axis of hole " << h + 1
       << " must lie in the mirror plane at its wall, or its crushed zone clear of that plane, got "
          "toe and collar '"
       << 0.0 - mirror.height(hole.toe) << ' ' << 0.0 - mirror.height(hole.collar)
       << "' m in front of it and a radius of " << hole.radius << " m";
  throw InputError(text.str());
}

double share_between(std::size_t h, const std::vector<Mirror>& planes) {
  if (planes.empty()) return 1.0;
  if (planes.size() == 1) return 0.5;
  const double between =
      std::numbers::pi - std::acos(std::clamp(planes[0].normal.dot(planes[1].normal), -1.0, 1.0));
  const double images = std::numbers::pi / between;
  if (planes.size() == 2 && std::abs(images - std::round(images)) < kNear * images)
    return 0.5 / std::round(images);
  std::ostringstream text;
  text << "mirror planes through the axis of hole " << h + 1
       << " must be two at an angle of 180 degrees over a whole number, got " << planes.size()
       << ", the first two at '" << between * 180.0 / std::numbers::pi << "' degrees";
  throw InputError(text.str());
}

}  // namespace

std::vector<Hole> holes_between_mirrors(std::vector<Hole> holes, const std::vector<Block>& blocks,
                                        int first_tag, const FacetSet& set) {
  const std::vector<std::vector<Mirror>> mirrors = mirrors_at(holes, blocks, first_tag, set);
  for (std::size_t h = 0; h < holes.size(); ++h) {
    std::vector<Mirror> through;
    for (const Mirror& mirror : mirrors[h]) {
      if (holds_axis(mirror, holes[h]))
        through.push_back(mirror);
      else if (cuts(mirror, holes[h]))
        refuse_cut(h, mirror, holes[h]);
    }
    holes[h].share = share_between(h, through);
  }
  return holes;
}

}  // namespace muckpile
