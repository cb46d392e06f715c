// SPDX-License-Identifier: GPL-2.0-or-later
// Facets and faces on their way into a network and out of it.
// Scope: data. `memory` has an entry for each facet, or is shorter: the rest are intact.
#pragma once

#include <vector>

#include "bond/facet.h"
#include "bond/network/facet_memory.h"

namespace muckpile {

struct FacetLists {
  std::vector<Facet> facets;
  std::vector<FacetMemory> memory;
  std::vector<BoundaryFace> faces;
};

}  // namespace muckpile
