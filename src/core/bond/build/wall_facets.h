// SPDX-License-Identifier: GPL-2.0-or-later
// Makes the wall of a crushed zone as stiff as that of a round hole, where blocks are not small
// against its radius.
// Scope: start configuration, before anything moves; from blocks and holes alone, so it is the same
// on any number of ranks. Sets Facet::stiffening of the facets between blocks on one wall and
// BoundaryFace::depth_share of their faces; all else stays. Blocks beyond the ends of a hole stay
// as they are.
//
// Around a round hole of radius a under pressure p rock moves by u = p a^2/(2G) psi, psi = out/r,
// r the distance from the axis (Lame, plane strain; no dilatation). Rigid blocks move by u at their
// centre, so what strains is only the rock between centres: the steep part of psi between wall and
// centres is missing, and the facets of two wall blocks begin at the corner of a polygon instead of
// at the circle.
//   Stiffening: with the wall blocks displaced by psi, the work of their facets must be that of the
// pressure on their faces. With c = A/h of a facet and N the sum of A n of a block's faces (out of
// the block),
//     k sum over facets in the ring of c |psi_i - psi_j|^2
//       + sum over facets of ring blocks b to others of c psi_b.(psi_b - psi_other)
//       = -sum over ring blocks of N.psi_b / a^2
// gives the k of a hole's ring.
//   Depth: the face itself moves on by what Lame's displacement changes between centre and wall.
// Of the volume p V/G that the wall sweeps the part of a face is p A g/G with its distance g from
// the axis; the block's motion gives -A n.psi of it, so the rest is that of a depth
//     d' = g + n.psi a^2     in place of d = n.arm.
#pragma once

#include <span>
#include <vector>

#include "bond/build/facet_builder.h"

namespace muckpile {

/// `holes`: in the order of BoundaryFace::hole; their radii are those of the voids as they were
/// cut, which may be wider than what was asked for.
void fit_walls(const std::vector<Block>& blocks, int first_tag, std::span<const Hole> holes,
               FacetSet& set);

}  // namespace muckpile
