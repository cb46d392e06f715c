// SPDX-License-Identifier: GPL-2.0-or-later
// The frequency of a vibration from samples of it.
// Scope: one cosine about zero.
#pragma once

#include <vector>

namespace muckpile::verification {

struct Sample {
  double time, amplitude;  ///< [s], any unit
};

/// Angular frequency [rad/s] between `low` and `high` of the cosine of any phase that fits the
/// samples best (least squares); the misfit must have one minimum there.
[[nodiscard]] double fitted_frequency(const std::vector<Sample>& samples, double low, double high);

}  // namespace muckpile::verification
