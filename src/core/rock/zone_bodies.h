// SPDX-License-Identifier: GPL-2.0-or-later
// Zones of rock inside of closed surfaces, such as a body of ore.
// Scope: triangles from files, in mine coordinates or those of the run; the blocks keep their
// shape, and are of the zone if their centroid is inside.
#pragma once

#include <string>

#include "rock/rock_model.h"

namespace muckpile {

/// Reads the surfaces that the zones name. Throws InputError for one that is not closed or looks
/// inward.
void read_zone_bodies(CutOptions& options);

/// Once the region is known: throws InputError for a surface beside it, or of an unlikely unit.
void check_zone_bodies(const CutOptions& options);

/// Lines of the log: the rock that each surface encloses, and that of the blocks; "" without.
[[nodiscard]] std::string describe_zone_bodies(const CutOptions& options, const RockModel& model);

}  // namespace muckpile
