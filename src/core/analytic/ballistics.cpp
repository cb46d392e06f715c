// SPDX-License-Identifier: GPL-2.0-or-later
// Ballistic range over level ground.
#include "analytic/ballistics.h"

#include <cmath>
#include <sstream>

#include "args/input_error.h"

namespace muckpile {

double ballistic_time(double speed, double angle, double height, double gravity) {
  if (!(speed >= 0.0 && height >= 0.0 && gravity > 0.0)) {
    std::ostringstream text;
    text << "ballistic flight: need speed >= 0 m/s, height >= 0 m, gravity > 0 m/s2, got '" << speed
         << "', '" << height << "', '" << gravity << "'";
    throw InputError(text.str());
  }
  const double rise = speed * std::sin(angle);
  return (rise + std::sqrt(rise * rise + 2.0 * gravity * height)) / gravity;
}

double ballistic_range(double speed, double angle, double height, double gravity) {
  return speed * std::cos(angle) * ballistic_time(speed, angle, height, gravity);
}

}  // namespace muckpile
