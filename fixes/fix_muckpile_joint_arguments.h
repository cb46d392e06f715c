// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/joint turned into a facet network without facets.
// Scope: stops the engine with a message where a word is wrong.
#pragma once

#include <string>

#include "bond/facet_network.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile {

/// `arg`: all words of the fix command from its ID on; `where` begins every message.
[[nodiscard]] FacetNetwork network_from_arguments(LAMMPS_NS::LAMMPS& lmp, const std::string& where,
                                                  int narg, char** arg);

}  // namespace muckpile
