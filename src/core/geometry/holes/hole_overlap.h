// SPDX-License-Identifier: GPL-2.0-or-later
// Crushed zones that would lie in one another.
// Scope: cylinders with flat ends; exact where axes are parallel, which decks of one hole and rows
// of holes are. Oblique ends are judged by the line between the nearest points of the axes.
#pragma once

#include <vector>

#include "geometry/block_model.h"

namespace muckpile {

/// True if the two cylinders have volume in common; touching is not overlapping.
[[nodiscard]] bool overlap(const Hole& a, const Hole& b);

/// Throws InputError that names the first two holes, numbered from 1, which overlap.
void refuse_overlapping_holes(const std::vector<Hole>& holes);

}  // namespace muckpile
