// SPDX-License-Identifier: GPL-2.0-or-later
// Stay of a block about one place.
// Scope: see the header.
#include "rest/stillness.h"

namespace muckpile {

bool Stillness::follow(const StillnessLimits& limits, const BlockPlace& place, double now) {
  const double turned = (place.axes - axes_).colwise().norm().maxCoeff();
  const double moved = (place.centre - centre_).norm() + turned * place.radius;
  if (!(moved <= limits.distance && place.speed <= limits.speed)) {
    centre_ = place.centre;
    axes_ = place.axes;
    since_ = now;
    return false;
  }
  return now - since_ >= limits.time;
}

}  // namespace muckpile
