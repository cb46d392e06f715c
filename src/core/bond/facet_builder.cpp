// SPDX-License-Identifier: GPL-2.0-or-later
// From cut blocks to the facets and boundary faces of the joint network.
// Scope: see the header.
#include "bond/facet_builder.h"

#include <cmath>

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

/// Half the way to the centre of the neighbour, its mirror image or, at other faces, all the way to
/// the face.
Vec3 half_way(const Facet& facet) {
  if (facet.kind == FacetKind::mirror) return facet.normal.dot(facet.arm_i) * facet.normal;
  return facet.kind == FacetKind::fixed ? facet.arm_i : 0.5 * (facet.arm_i - facet.arm_j);
}

/// The jump u of a facet adds A m.u/2 to the volume of its block. With m = n the sum is wrong in a
/// homogeneous strain by the first moment of the facets about the lines between the centres; the
/// inverse of the sum of A n (x) r / V takes that out.
void set_openings(const std::vector<Block>& blocks, int first_tag, FacetSet& set) {
  std::vector<Mat3> moment(blocks.size(), Mat3::Zero());
  const auto number = [&](int tag) { return static_cast<std::size_t>(tag - first_tag); };
  const auto add = [&](int tag, const Vec3& area, const Vec3& reach) {
    moment[number(tag)] += area * reach.transpose() / blocks[number(tag)].mass.volume;
  };
  for (const Facet& facet : set.facets) {
    const Vec3 area = facet.area * facet.normal, reach = half_way(facet);
    add(facet.tag_i, area, reach);
    if (facet.kind == FacetKind::joint) add(facet.tag_j, area, reach);
  }
  for (const BoundaryFace& face : set.faces) add(face.tag, face.area * face.normal, face.arm);
  for (Facet& facet : set.facets) {
    facet.opening_i = moment[number(facet.tag_i)].inverse() * facet.normal;
    facet.opening_j = facet.kind == FacetKind::joint
                          ? Vec3(moment[number(facet.tag_j)].inverse() * facet.normal)
                          : Vec3::Zero();
  }
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

}  // namespace

FacetSet build_facets(const std::vector<Block>& blocks, int first_tag, const SupportRule& support) {
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
      const Support held = other == kFreeFace ? support(face.centroid) : Support::free;
      if (other >= 0 || held != Support::free) {
        const Vec3 centre_j =
            other >= 0 ? blocks[static_cast<std::size_t>(other)].mass.centroid : Vec3::Zero();
        Facet facet = facet_of(face, block.mass.centroid, centre_j);
        facet.tag_i = tag;
        facet.face = static_cast<int>(k);
        facet.tag_j = other >= 0 ? first_tag + other : kGroundTag;
        if (held == Support::fixed) facet.kind = FacetKind::fixed;
        if (held == Support::mirror) facet.kind = FacetKind::mirror;
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
  set_openings(blocks, first_tag, set);
  choose_sharpened(blocks, first_tag, set);
  return set;
}

}  // namespace muckpile
