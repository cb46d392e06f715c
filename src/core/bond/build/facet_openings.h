// SPDX-License-Identifier: GPL-2.0-or-later
// m of every facet (facet_network.h): how its jump dilates the two blocks.
// Scope: once, from the whole cut.
#pragma once

#include <vector>

#include "bond/build/facet_builder.h"

namespace muckpile {

/// Sets the openings of all facets and says which are slanted: none where faces lean little.
void set_openings(const std::vector<Block>& blocks, int first_tag, Leaning leaning, FacetSet& set);

}  // namespace muckpile
