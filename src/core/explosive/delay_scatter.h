// SPDX-License-Identifier: GPL-2.0-or-later
// Scatter of detonators: each delay element of a blast plan burns somewhat longer or shorter than
// its nominal time.
// Scope: elements are the surface delay of a hole and the in-hole delay of a deck; a hole table
// gets the column scatter_s, and who reads the table knows of no scatter by itself.
#pragma once

#include <cstdint>
#include <string>

namespace muckpile {

struct DelayScatter {
  double share = 0.0;      ///< standard deviation of an element over its delay [-]
  std::uint64_t seed = 1;  ///< of the draws
};

/// Number `index` of a normal distribution of mean 0 and standard deviation 1, cut at 3 (which
/// leaves a standard deviation of 0.987); the same on any number of ranks.
[[nodiscard]] double cut_normal(std::uint64_t seed, std::uint64_t index);

/// Which draw an element has: deck 0 is the surface delay of the hole, 1 its lowest deck.
[[nodiscard]] std::uint64_t draw_of(const std::string& hole, std::size_t deck);

struct ScatteredTable {
  std::string text;    ///< the table with the column scatter_s
  std::string report;  ///< one line for the log
};

/// What the elements of the tie-up add up to, for each deck of a hole table: `text`, for which
/// `name` stands in messages. An element has its draw by the name of its hole, and a detonator by
/// the number of its deck from the bottom up, too: the order of rows does not matter. Throws
/// InputError where the table is wrong, or has scatter_s already.
[[nodiscard]] ScatteredTable scattered(const std::string& text, const std::string& name,
                                       const DelayScatter& scatter);

}  // namespace muckpile
