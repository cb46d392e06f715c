// SPDX-License-Identifier: GPL-2.0-or-later
// Mass of explosive of a pattern, and the most of it that fires within a window of time.
// Scope: sums of the table's charges; what they shake is not computed.
#pragma once

#include <span>

#include "explosive/hole_table.h"

namespace muckpile {

/// Charges less far apart usually count as one for vibrations, a rule of practice [s].
inline constexpr double kVibrationWindow = 8e-3;

/// Explosive in a deck: a cylinder of the charge's diameter and length, else those of the hole and
/// its chamber [kg].
[[nodiscard]] double charge_mass(const Deck& deck, double density);

struct TimedCharge {
  double time = 0.0;  ///< it fires [s]
  double mass = 0.0;  ///< [kg]
};

/// Largest sum of charges that fire less than `window` [s] apart, first to last; 0 for none, NaN
/// where one is not known [kg].
[[nodiscard]] double largest_within(std::span<const TimedCharge> charges, double window);

}  // namespace muckpile
