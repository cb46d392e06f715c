// SPDX-License-Identifier: GPL-2.0-or-later
// What the colours of a picture stand for, as numbers.
// Scope: one block of one snapshot.
#pragma once

#include "io/snapshot.h"
#include "report/options.h"

namespace muckpile {

// In the unit of its column.
double block_value(ColourBy by, const StartBlock& block, const BlockState& state);

// Its name in a table, with the unit.
const char* column_of(ColourBy by);

}  // namespace muckpile
