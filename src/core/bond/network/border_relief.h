// SPDX-License-Identifier: GPL-2.0-or-later
// Facets between two rocks whose dilatations differ: where the jump splits.
// Scope: intact facets with Border constants (facet_tables.h), of which a network of one rock has
// none. Reads thetas of both blocks, adds to their bulk stress and to the facet's traction.
//
// The split of two_rocks.h gives both sides the same traction in uniaxial strain. In any other
// strain their normal tractions differ by
//     D = push u_n + pull_i theta_i - pull_j theta_j,    push = 2 (G_i e_i - G_j e_j) per jump,
//     pull = lambda g,   g = h m.n/(2 d),
// until the place where the jump splits moves by q = -D/K, K = 2G_i/d_i + 2G_j/d_j +
// lambda_i g_i^2/r_i + lambda_j g_j^2/r_j: then both are equal, and the energy is the least that
// any q gives, less by A D^2/(2K). r is the block's volume over the area of its facets to other
// rocks, each of which counts in its own part of the block: so the energy stays positive and a
// block needs its neighbours' thetas alone. A block on a free face counts as if it had none (K is
// larger then, and the traction of such a facet between that of the fixed split and the true one).
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "bond/network/facet_kinematics.h"
#include "bond/network/joint_books.h"

namespace muckpile {

/// Adds to BlockSums::uneven of all blocks, and sets BlockFields::border_traction. Theta is that of
/// the present pose.
void relieve_borders(const FacetKinematics& facets, BlockFields& blocks);

/// Along the normal, on block i, by the last relieve_borders(); 0 but at intact borders [Pa].
[[nodiscard]] double border_traction(const FacetKinematics& facets, std::size_t f);

/// Of facet f, with the present thetas; never positive [J].
[[nodiscard]] double border_energy(const FacetKinematics& facets, std::size_t f);

/// Books what breaking, which has changed theta, changes of it. A block of another rank still has
/// its theta before: that rank books its part.
void book_borders(const FacetKinematics& facets, std::span<const double> theta_before,
                  JointLosses& losses);
/// Books what is left: `product` of a facet is that of the changes of both thetas, times its weight
/// (FacetBreaking::book_shared_changes()).
void book_shared_borders(const FacetKinematics& facets,
                         const std::function<double(std::size_t)>& product, JointLosses& losses);

}  // namespace muckpile
