// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic energy of facets in the present pose.
// Scope: reads only; per facet, in J, of the whole facet whatever share this rank books. Bulk
// stresses and dilatations are those of the present pose.
#pragma once

#include "bond/network/facet_kinematics.h"

namespace muckpile {

/// Of the closed broken points.
[[nodiscard]] double contact_energy(const FacetKinematics& facets, std::size_t f,
                                    const FacetMotion& motion);
/// Of the joint, of its closed broken points and of the uneven dilatation on its sides.
[[nodiscard]] double facet_energy(const FacetKinematics& facets, std::size_t f);

}  // namespace muckpile
