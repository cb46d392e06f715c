// SPDX-License-Identifier: GPL-2.0-or-later
// Starfield-Pugliese pulse; equations in the header.
#include "explosive/starfield_pulse.h"

#include <cmath>

#include "args/require.h"

namespace muckpile {

StarfieldPulse::StarfieldPulse(double rise_time) : rise_time_(rise_time) {
  require_positive("rise_time", "s", rise_time);
}

double StarfieldPulse::shape(double time) const {
  if (time <= 0.0) return 0.0;
  const double x = std::exp2(-time / rise_time_);
  return 4.0 * x * (1.0 - x);
}

}  // namespace muckpile
