// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/joint turned into a facet network without facets, and into checks.
// Scope: stops the engine with a message where a word is wrong.
#pragma once

#include <string>

#include "bond/network/facet_network.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile {

struct JointArguments {
  FacetNetwork network;
  std::vector<std::string> zones;  ///< names of the network's, from 1 on
  int step_check;                  ///< steps between looks at the time step, 0: none
  bool contact_check;              ///< whether a joint that lets go stops a run without contact law
};

/// `arg`: all words of the fix command from its ID on; `where` begins every message.
[[nodiscard]] JointArguments joint_arguments(LAMMPS_NS::LAMMPS& lmp, const std::string& where,
                                             int narg, char** arg);

}  // namespace muckpile
