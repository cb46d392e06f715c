// SPDX-License-Identifier: GPL-2.0-or-later
// The charges of a run with their masses and when they fire.
// Scope: of the hole table beside the run, else of the equal charges of its scene, which fire
// together.
#pragma once

#include <vector>

#include "io/result_folder.h"
#include "math/types.h"

namespace muckpile {

struct FiredCharge {
  Vec3 toe, collar;    // ends of the axis [m]
  double mass;         // [kg]
  double firing_time;  // [s]
};

// Never empty; masses are NaN where the table has an explosive whose density is not known. Throws
// InputError where there is no table and the scene does not tell the mass.
std::vector<FiredCharge> fired_charges(const ResultFolder& folder);

// The largest mass that fires within less than `window` [s], in kg.
double largest_mass_within(const std::vector<FiredCharge>& charges, double window);

// From a point to the nearest point of the nearest axis [m].
double distance_to_charges(const Vec3& point, const std::vector<FiredCharge>& charges);

}  // namespace muckpile
