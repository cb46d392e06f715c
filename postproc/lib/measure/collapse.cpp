// SPDX-License-Identifier: GPL-2.0-or-later
// What a bench would leave beyond its old toe if its burden only broke, swelled and slumped.
// Scope: docs/theory/collapse.md has the formula and its derivation.
#include "measure/collapse.h"

#include <algorithm>
#include <cmath>

namespace muckpile {

double collapsed_beyond_toe(const CollapseShape& s) {
  const double bulk = s.swell * s.rock_area, tangent = std::tan(s.angle);
  if (!(bulk > 0.0) || !(tangent > 0.0)) return std::nan("");
  // A triangle on the wall, or the slope from the bench's full height behind a level part.
  const double triangle = std::sqrt(2.0 * bulk * tangent);  // its height [m]
  const double height = std::min(triangle, s.height);
  const double level = bulk / height - 0.5 * height / tangent;  // from the wall to the slope [m]
  const double crest = level - s.burden;                        // of the slope, x [m]
  if (crest >= 0.0) return 1.0 - s.burden * height / bulk;
  const double foot = std::max(0.0, crest + height / tangent);
  return 0.5 * foot * foot * tangent / bulk;
}

}  // namespace muckpile
