// SPDX-License-Identifier: GPL-2.0-or-later
// Heat into crushed rock; equations in the header.
#include "gas/crushed_bed.h"

#include <algorithm>

#include "args/require.h"

namespace muckpile {

CrushedBed::CrushedBed(const Parameters& parameters) : p_(parameters) {
  require_not_negative("crushed_grain", "m", p_.grain);
  require_positive("heat_capacity", "J/(m3 K)", p_.heat_capacity);
  (void)WallHeat(p_.rock);  // which refuses what is no rock
  const double conductivity = p_.rock.effusivity * p_.rock.effusivity / p_.heat_capacity;
  if (acts()) grains_ = RockLayers::sphere(p_.grain, conductivity, p_.heat_capacity);
}

double CrushedBed::kept(const State& state, double volume, double temperature,
                        const RockLayers::Step& step) const {
  if (!acts() || !(volume > 0.0) || !(temperature > 0.0)) return 1.0;
  const double warmer = temperature - p_.rock.rock_temperature - step.free(state.grains);
  // q A/C of q = warmer/(A/C + resistance)
  return 1.0 - warmer / (1.0 + step.resistance() * state.flow / area(volume)) / temperature;
}

void CrushedBed::take(State& state, double volume, double heat, double flow,
                      const RockLayers::Step& step) const {
  constexpr double kRemembered = 0.9;  // of the flow before, from step to step
  state.flow = std::max(flow, kRemembered * state.flow);
  state.heat += heat;
  if (!acts() || !(volume > 0.0)) return;
  step.take(heat / (area(volume) * step.length()), state.grains);
}

}  // namespace muckpile
