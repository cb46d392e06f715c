// SPDX-License-Identifier: GPL-2.0-or-later
// What is in each hole, for tables of holes that do not say it: plans of rows, and files of other
// programs.
// Scope: text of hole tables; hole_table.h says what the columns mean.
#pragma once

#include <string>

#include "args/csv_table.h"
#include "geometry/surface/rock_body.h"

namespace muckpile {

/// The hole table `text`, for which `name` stands in messages, with the charges of another one.
/// Each row of `charges` is a deck of the hole that it names and has the columns of charges of a
/// hole table; decks of such holes in `text` go. What a row leaves empty, but for the crushed zone,
/// is that of the first deck in `text`. Throws InputError where a hole is not in `text`, where a
/// row for a hole of several decks lacks a depth, or as HoleTable.
[[nodiscard]] std::string with_charges(const std::string& text, const std::string& name,
                                       const CsvTable& charges);

/// A hole table in mine coordinates, for which `name` stands in messages, as one in those of the
/// run. Throws InputError where no hole is near the frame's origin.
[[nodiscard]] std::string placed_table(const CsvTable& csv, const std::string& name,
                                       const MineFrame& frame);

}  // namespace muckpile
