// SPDX-License-Identifier: GPL-2.0-or-later
// Where the charges of a run were: the axes of their crushed zones.
// Scope: from run.json, else from the hole table beside it, else the row that scene.json describes.
#pragma once

#include <cmath>
#include <vector>

#include "explosive/hole_table.h"
#include "io/result_folder.h"
#include "math/types.h"

namespace muckpile {

struct Charge {
  Vec3 toe, collar;  // ends of the axis [m]
  double radius;     // of the crushed zone; of the hole where the zone is not known [m]
  double hole_radius = std::nan("");  // where the hole table tells it [m]
};

// Never empty: scene.json describes one hole at least. Throws InputError on a malformed list or a
// scene without the numbers that describe a row.
std::vector<Charge> charges_of(const ResultFolder& folder);

// The "holes" of run.json; empty where there is no such file or it has none.
std::vector<Charge> charges_of_run(const ResultFolder& folder);

// dump/holes.csv. InputError where run.json has charges and these are others than the table's: that
// may be one that another run has left, or have been changed since.
HoleTable hole_table_of(const ResultFolder& folder);

}  // namespace muckpile
