// SPDX-License-Identifier: GPL-2.0-or-later
// Time course of one charged hole; see the header.
#include "explosive/hole_blast.h"

namespace muckpile {

double HoleBlast::gas_pressure(double swept_volume, double time, const GasState& state) const {
  const double since_firing = time - front_.firing_time();
  if (since_firing < 0.0) return 0.0;
  return load_.gas_pressure(swept_volume - state.swept_before, since_firing, state);
}

double HoleBlast::gas_energy(double swept_volume, double time, const GasState& state) const {
  const double since_firing = time - front_.firing_time();
  if (since_firing < 0.0) return 0.0;
  return load_.gas_energy(swept_volume - state.swept_before, since_firing, state);
}

double HoleBlast::gas_enthalpy(double swept_volume, double time, const GasState& state) const {
  const double since_firing = time - front_.firing_time();
  if (since_firing < 0.0) return 0.0;
  return load_.gas_enthalpy(swept_volume - state.swept_before, since_firing, state);
}

double HoleBlast::pulse_limit(double swept_volume, double time, const GasState& state) const {
  return load_.pulse_limit(swept_volume - state.swept_before, time - front_.firing_time(), state);
}

void HoleBlast::advance(GasState& state, double swept_volume, double time, double dt) const {
  const double since_firing = time - front_.firing_time();
  if (since_firing < 0.0) {
    state.swept_before = swept_volume;
  } else {
    load_.advance(state, swept_volume - state.swept_before, since_firing, dt);
  }
}

bool HoleBlast::over(double time, double gas_pressure) const {
  const double since_last = time - front_.last_arrival_time();
  return since_last > 0.0 &&
         load_.bound(since_last, gas_pressure) <= kNegligible * load_.greatest_pressure();
}

}  // namespace muckpile
