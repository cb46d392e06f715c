// SPDX-License-Identifier: GPL-2.0-or-later
// Attenuation through the crushed zone; equations in the header.
#include "explosive/attenuation.h"

#include <cmath>

#include "args/require.h"

namespace muckpile {

double crushed_zone_exponent(double poisson_ratio) {
  if (!(poisson_ratio >= 0.0 && poisson_ratio < 0.5)) {
    refuse_value("poisson_ratio", "0 or more and below 0.5", "", poisson_ratio);
  }
  return 2.0 + poisson_ratio / (1.0 - poisson_ratio);
}

double liu_katsabanis_exponent(double p_wave_speed, double detonation_velocity) {
  require_positive("rock_p_wave_speed", "m/s", p_wave_speed);
  require_positive("vod", "m/s", detonation_velocity);
  return 1.54 * std::pow(p_wave_speed / detonation_velocity, -0.33);
}

double attenuated_pressure(double pressure, double borehole_radius, double radius,
                           double exponent) {
  require_not_negative("borehole_pressure", "Pa", pressure);
  require_positive("hole radius", "m", borehole_radius);
  require_not_negative("attenuation_exponent", "", exponent);
  if (!(std::isfinite(radius) && radius >= borehole_radius)) {
    refuse_value("crushed-zone radius", "at least the hole radius", "m", radius);
  }
  return pressure * std::pow(borehole_radius / radius, exponent);
}

}  // namespace muckpile
