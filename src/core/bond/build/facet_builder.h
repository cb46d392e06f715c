// SPDX-License-Identifier: GPL-2.0-or-later
// From cut blocks to the facets and boundary faces of the joint network.
// Scope: start configuration; tags are first_tag + block number.
#pragma once

#include <functional>
#include <vector>

#include "bond/facet.h"
#include "geometry/block_model.h"

namespace muckpile {

/// How the rock's boundary is supported at a face with this centroid.
enum class Support : std::uint8_t { free, fixed, mirror };
using SupportRule = std::function<Support(const Vec3& face_centroid)>;

struct FacetSet {
  std::vector<Facet> facets;  ///< joints have tag_i < tag_j; sorted by (tag_i, face)
  std::vector<BoundaryFace> faces;
};

/// Faces of a block smaller than this share of V^(2/3) carry no joint: their stiffness is lost in
/// rounding and their h/area would only disturb the time step.
inline constexpr double kSmallestFacetShare = 1e-6;

/// How far lines between centres are from crossing faces at right angles: little in relaxed Voronoi
/// cells; much where planes or joint sets cut, which takes the terms of leaning_faces.h.
enum class Leaning : std::uint8_t { little, much };

/// `zones`: the zone of rock of each block; none: all have one rock.
[[nodiscard]] FacetSet build_facets(const std::vector<Block>& blocks, int first_tag,
                                    const SupportRule& support, Leaning leaning = Leaning::little,
                                    const std::vector<std::uint8_t>& zones = {});

}  // namespace muckpile
