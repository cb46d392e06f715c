// SPDX-License-Identifier: GPL-2.0-or-later
// Heat into the walls of a crack; equations in the header.
#include "gas/wall_heat.h"

#include <cmath>

#include "args/require.h"

namespace muckpile {

WallHeat::WallHeat(const Parameters& parameters) : p_(parameters) {
  require_not_negative("effusivity", "W s^0.5/(m2 K)", p_.effusivity);
  require_positive("rock_temperature", "K", p_.rock_temperature);
  require_positive("prandtl", "", p_.prandtl);
  analogy_ = std::pow(p_.prandtl, -2.0 / 3.0);
}

}  // namespace muckpile
