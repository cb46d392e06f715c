// SPDX-License-Identifier: GPL-2.0-or-later
// How a figure answers to a change: exponents n of v/v0 = factor^n and ratios, each from one pair
// of runs. Scope: no fit; a name may stand in several rows, whose factors differ.
#pragma once

#include <filesystem>

#include "figures/figures.h"

namespace muckpile::check {

/// From a table with the columns name, factor, value, base: a figure NAME_exponent per row, or
/// NAME_at_FACTOR_exponent where several rows have a name; NAME_ratio, value over base, where there
/// is no factor; NAME, the value itself, where there is no base either. InputError unless all
/// numbers are > 0 and no factor is 1, or if two figures have one name.
[[nodiscard]] Json exponents(const std::filesystem::path& table);

}  // namespace muckpile::check
