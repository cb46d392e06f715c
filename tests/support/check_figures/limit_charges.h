// SPDX-License-Identifier: GPL-2.0-or-later
// Charges of a single hole that just loosen its burden, beside the law of sizes of Langefors and
// Kihlstrom.
// Scope: a table with a row per run.
#pragma once

#include <filesystem>

#include "figures/figures.h"

namespace muckpile::check {

/// Of a table with the columns burden_m, which is the bench's height too, charge_kg and throw_m, of
/// the mass centre of the burden; rows of one charge are cuts, and count by their mean. Gives for each burden V [m], 100 V in the names,
///   limit_kg_m3_at_: charge over V^3 at which the throw is a twentieth of the burden, linear in
///   the
///     logarithms between two charges of which the smaller throws less, the largest such two;
///   limit_over_langefors_at_: that over 0.07/V + 0.40/1.2 + 0.004 V, of usual rock without the
///     technical margin of a fifth (Langefors, after Bastante's lecture book, chapter 7).
/// Throws InputError where a number is missing or out of range, or no two charges of a burden lie
/// on both sides.
[[nodiscard]] Json limit_charges(const std::filesystem::path& table);

}  // namespace muckpile::check
