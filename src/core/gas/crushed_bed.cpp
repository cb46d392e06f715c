// SPDX-License-Identifier: GPL-2.0-or-later
// Heat into crushed rock; equations in the header.
#include "gas/crushed_bed.h"

#include <algorithm>

#include "args/require.h"

namespace muckpile {

CrushedBed::CrushedBed(const Parameters& parameters) : p_(parameters), rock_(parameters.rock) {
  require_not_negative("crushed_grain", "m", p_.grain);
  require_positive("heat_capacity", "J/(m3 K)", p_.heat_capacity);
}

/// Into a surface [W/m2], from gas that is warmer by `excess` than the mean of the grains [K].
double CrushedBed::flux(const State& state, double area, double excess) const {
  const double film = state.flow / area;  // gas that gives all that it carries
  const double half_space = rock_.flux(rock_.rock_temperature() + excess, film, state.heat / area);
  const double conductivity =
      p_.rock.effusivity * p_.rock.effusivity / p_.heat_capacity;  // [W/(m K)]
  const double sphere = film * excess / (1.0 + film * p_.grain / (10.0 * conductivity));
  return std::max(half_space, sphere);
}

double CrushedBed::kept(const State& state, double volume, double temperature) const {
  if (!(p_.grain > 0.0) || !(volume > 0.0) || !rock_.acts()) return 1.0;
  const double mean = rock_.rock_temperature() + state.heat / (p_.heat_capacity * volume);
  if (!(temperature > mean)) return 1.0;
  if (!(state.flow > 0.0)) return mean / temperature;
  const double area = 6.0 * volume / p_.grain;
  const double loss = flux(state, area, temperature - mean) * area / state.flow;  // [K]
  return 1.0 - loss / temperature;
}

}  // namespace muckpile
