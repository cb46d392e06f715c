// SPDX-License-Identifier: GPL-2.0-or-later
// From cut blocks to the facets and boundary faces of the joint network.
// Scope: see the header.
#include "bond/build/facet_builder.h"

#include <cmath>

#include "bond/build/facet_openings.h"

namespace muckpile {
namespace {

Facet facet_of(const FaceGeometry& face, const Vec3& centre_i, const Vec3& centre_j) {
  Facet facet;
  facet.normal = face.normal;
  facet.arm_i = face.centroid - centre_i;
  facet.arm_j = face.centroid - centre_j;
  facet.half_axes = {std::sqrt(2.0) * face.radius1 * face.axis,
                     std::sqrt(2.0) * face.radius2 * face.normal.cross(face.axis)};
  facet.area = face.area;
  return facet;
}

/// The ground of a fixed support may yield, which is solved for its block alone: the block's bulk
/// stress must not depend on its neighbours.
void choose_sharpened(const std::vector<Block>& blocks, int first_tag, FacetSet& set) {
  std::vector<bool> fixed(blocks.size(), false);
  const auto is_fixed = [&](int tag) { return fixed[static_cast<std::size_t>(tag - first_tag)]; };
  for (const Facet& facet : set.facets) {
    if (facet.kind == FacetKind::fixed)
      fixed[static_cast<std::size_t>(facet.tag_i - first_tag)] = true;
  }
  for (Facet& facet : set.facets) {
    facet.sharpened =
        facet.kind == FacetKind::joint && !is_fixed(facet.tag_i) && !is_fixed(facet.tag_j);
  }
}

/// See Facet::border_room; not at the blocks of fixed supports, as above. The relief of a block's
/// facets to other rocks changes its dilatation without theta, so D is not for its facets either.
void choose_border_rooms(const std::vector<Block>& blocks, int first_tag, FacetSet& set) {
  std::vector<double> area(blocks.size(), 0.0);
  const auto number = [&](int tag) { return static_cast<std::size_t>(tag - first_tag); };
  for (const Facet& facet : set.facets) {
    if (facet.zone_i == facet.zone_j) continue;
    area[number(facet.tag_i)] += facet.area;
    area[number(facet.tag_j)] += facet.area;
  }
  const auto room = [&](int tag) {
    return static_cast<float>(blocks[number(tag)].mass.volume / area[number(tag)]);
  };
  for (Facet& facet : set.facets) {
    if (facet.zone_i != facet.zone_j && facet.sharpened)
      facet.border_room = {room(facet.tag_i), room(facet.tag_j)};
  }
  for (Facet& facet : set.facets) {
    if (area[number(facet.tag_i)] > 0.0 ||
        (facet.kind == FacetKind::joint && area[number(facet.tag_j)] > 0.0))
      facet.sharpened = false;
  }
}

}  // namespace

FacetSet build_facets(const std::vector<Block>& blocks, int first_tag, const SupportRule& support,
                      Leaning leaning, const std::vector<std::uint8_t>& zones) {
  const auto zone = [&](int block) {
    return zones.empty() ? std::uint8_t{0} : zones[static_cast<std::size_t>(block)];
  };
  FacetSet set;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    const int tag = first_tag + static_cast<int>(b);
    const double smallest = kSmallestFacetShare * std::pow(block.mass.volume, 2.0 / 3.0);
    for (std::size_t k = 0; k < block.neighbour.size(); ++k) {
      const int other = block.neighbour[k];
      if (other >= 0 && other < static_cast<int>(b)) continue;  // made by the other block
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(k));
      if (face.area < smallest && !is_hole_face(other)) continue;
      const Support at_face = other == kFreeFace ? support(face.centroid) : Support::free;
      if (other >= 0 || at_face != Support::free) {
        const Vec3 centre_j =
            other >= 0 ? blocks[static_cast<std::size_t>(other)].mass.centroid : Vec3::Zero();
        Facet facet = facet_of(face, block.mass.centroid, centre_j);
        facet.tag_i = tag;
        facet.face = static_cast<int>(k);
        facet.tag_j = other >= 0 ? first_tag + other : kGroundTag;
        facet.zone_i = zone(static_cast<int>(b));
        facet.zone_j = other >= 0 ? zone(other) : facet.zone_i;
        if (at_face == Support::fixed) facet.kind = FacetKind::fixed;
        if (at_face == Support::mirror) facet.kind = FacetKind::mirror;
        set.facets.push_back(facet);
      } else {
        BoundaryFace boundary;
        boundary.tag = tag;
        boundary.face = static_cast<int>(k);
        boundary.hole = is_hole_face(other) ? hole_of_face(other) : -1;
        boundary.normal = face.normal;
        boundary.arm = face.centroid - block.mass.centroid;
        boundary.start = boundary.last_centroid = face.centroid;
        boundary.last_normal = face.normal;
        boundary.area = face.area;
        set.faces.push_back(boundary);
      }
    }
  }
  set_openings(blocks, first_tag, leaning, set);
  choose_sharpened(blocks, first_tag, set);
  choose_border_rooms(blocks, first_tag, set);
  return set;
}

}  // namespace muckpile
