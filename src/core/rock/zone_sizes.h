// SPDX-License-Identifier: GPL-2.0-or-later
// Block sizes of zones of rock: size_factor of each.
// Scope: from the zones to the factor that the cuts ask (geometry/size/size_factor.h).
#pragma once

#include "rock/cut_options.h"

namespace muckpile {

/// Throws InputError where a zone has a size_factor and the blocks are imported or fitted to a size
/// curve.
void check_zone_sizes(const CutOptions& options);

/// Once the box of the rock and all zones are known. Throws InputError where the factor of a zone
/// asks for blocks below block_min, or above block_max, in all of it.
void lay_zone_sizes(CutOptions& options);

}  // namespace muckpile
