// SPDX-License-Identifier: GPL-2.0-or-later
// Where the surface of the pile lies in a tenth, half and nine tenths of the runs of a sweep.
// Scope: benches that were measured, whose profile.csv has the mean height over the width.
#pragma once

#include <filesystem>
#include <vector>

#include "sweep/sweep_runs.h"

namespace muckpile {

struct ProfileBand {
  double x;              // distance along the throw [m]
  double p10, p50, p90;  // heights [m]
};

// On the places of the run whose profile reaches farthest; beyond its end a profile is as high as
// there. Empty where fewer than three runs have a profile.
[[nodiscard]] std::vector<ProfileBand> profile_bands(const Sweep& sweep);

// profile_bands.csv and profile_bands.png in the sweep's folder; nothing of an empty band.
// Gives back what it has written.
std::vector<std::filesystem::path> write_profile_bands(const Sweep& sweep,
                                                       const std::vector<ProfileBand>& bands);

}  // namespace muckpile
