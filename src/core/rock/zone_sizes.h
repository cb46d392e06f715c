// SPDX-License-Identifier: GPL-2.0-or-later
// Block sizes of zones of rock: size_factor of each.
// Scope: from the zones to the factor that the cuts ask (geometry/size/size_factor.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rock/cut_options.h"

namespace muckpile {

/// Throws InputError where a zone has a size_factor and the blocks are imported or fitted to a size
/// curve.
void check_zone_sizes(const CutOptions& options);

/// Once the box of the rock and all zones are known. Throws InputError where the factor of a zone
/// asks for blocks below block_min, or above block_max, in all of it.
void lay_zone_sizes(CutOptions& options);

/// Warnings for the log about zones whose blocks have not the sizes that their factor asks for, as
/// those thinner than a block. `zone_of` is per block.
[[nodiscard]] std::string describe_zone_sizes(const CutOptions& options, const Tessellation& cut,
                                              const std::vector<std::uint8_t>& zone_of);

}  // namespace muckpile
