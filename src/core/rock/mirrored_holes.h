// SPDX-License-Identifier: GPL-2.0-or-later
// Charges on symmetry planes: how much of each crushed zone is modelled.
// Scope: start configuration; mirror planes are those of the mirror faces of blocks on a zone.
#pragma once

#include <vector>

#include "bond/build/facet_builder.h"

namespace muckpile {

/// The holes with their shares: 1/2 where the axis lies in one mirror plane, the angle of the rock
/// between the planes over the full circle where it lies in two (1/4 in planes at right angles).
/// `set` holds the supports of `blocks`, tags from `first_tag`.
/// Throws InputError: a zone that a mirror plane cuts beside its axis, or at an angle to it; planes
/// whose angle is no whole part of 180 degrees, so that the images do not close.
[[nodiscard]] std::vector<Hole> holes_between_mirrors(std::vector<Hole> holes,
                                                      const std::vector<Block>& blocks,
                                                      int first_tag, const FacetSet& set);

}  // namespace muckpile
