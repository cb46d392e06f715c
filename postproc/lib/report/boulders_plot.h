// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of the boulders of a pile, seen from above.
// Scope: draws what it is given; boulders under other rock are shown as if that were away.
#pragma once

#include <vector>

#include "draw/canvas.h"
#include "report/run_data.h"

namespace muckpile {

struct Boulder {
  std::vector<size_t> blocks;  // of the run
  double sieve;                // size [m]
  Vec3 centre;                 // at the end [m]
};

// `least`: size above which a fragment is a boulder [m]; `mass_share`: theirs of the pile's mass.
Canvas draw_boulders(const RunData& run, std::vector<Boulder> boulders, double least,
                     double mass_share);

}  // namespace muckpile
