// SPDX-License-Identifier: GPL-2.0-or-later
// Load on the wall of the crushed zone; equations in the header.
#include "explosive/blast_load.h"

#include <algorithm>
#include <cmath>

#include "args/require.h"

namespace muckpile {

double vent_factor(double time, double vent_time, double vent_decay) {
  return time <= vent_time ? 1.0 : std::exp(-(time - vent_time) / vent_decay);
}

double crushed_rock_share(double gas_volume, double zone_volume, double friction) {
  if (!(zone_volume > gas_volume)) return 1.0;
  return std::pow(gas_volume / zone_volume, std::sin(friction) / (1.0 + std::sin(friction)));
}

BlastLoad::BlastLoad(const Parameters& parameters)
    : wave_peak_(parameters.wave_peak),
      pulse_(parameters.pulse),
      expansion_(parameters.expansion),
      charge_volume_(parameters.charge_volume),
      zone_volume_(parameters.zone_volume),
      crushed_friction_(parameters.crushed_friction),
      vent_time_(parameters.vent_time),
      vent_decay_(parameters.vent_decay),
      products_mass_(parameters.products_mass) {
  require_not_negative("peak_pressure", "Pa", wave_peak_);
  if (!expansion_) return;
  require_positive("charge volume", "m3", charge_volume_);
  require_not_negative("volume of the crushed zone", "m3", zone_volume_);
  require_not_negative("crushed_friction", "", crushed_friction_);
  if (parameters.flow) {
    vent_.emplace(*parameters.flow);
  } else {
    require_not_negative("vent_time", "s", vent_time_);
    require_positive("vent_decay", "s", vent_decay_);
  }
  require_positive("free volume ratio", "", parameters.free_volume_ratio);
  start_volume_ =
      std::max(expansion_->switch_ratio(), parameters.free_volume_ratio) * charge_volume_;
  require_positive("volume ratio of the pulse", "", parameters.pulse_volume_ratio);
  pulse_volume_ =
      std::min(parameters.pulse_volume_ratio, parameters.free_volume_ratio) * charge_volume_;
}

double BlastLoad::products_pressure(double volume, double time, const GasState& state) const {
  const double ratio = volume / charge_volume_;
  if (vent_) return state.hotter * expansion_->pressure(ratio / state.mass_left);
  return expansion_->pressure(ratio) * vent_factor(time, vent_time_, vent_decay_);
}

double BlastLoad::gas_pressure(double swept_volume, double time, const GasState& state) const {
  return expansion_ ? products_pressure(gas_room(swept_volume, state), time, state) : 0.0;
}

double BlastLoad::pulse_limit(double swept_volume, double time, const GasState& state) const {
  if (!expansion_) return kNoLimit;
  return products_pressure(pulse_volume_ + swept_volume + cleared_room(state), time, state);
}

double BlastLoad::wall_share(double swept_volume) const {
  if (!(zone_volume_ > 0.0)) return 1.0;
  return crushed_rock_share(gas_room(swept_volume), zone_volume_ + swept_volume, crushed_friction_);
}

double BlastLoad::gas_energy(double swept_volume, double time, const GasState& state) const {
  if (!expansion_) return 0.0;
  const double ratio = gas_room(swept_volume, state) / charge_volume_;
  if (!vent_)
    return charge_volume_ * expansion_->stored_energy(ratio) *
           vent_factor(time, vent_time_, vent_decay_);
  return state.hotter * state.mass_left * charge_volume_ *
         expansion_->stored_energy(ratio / state.mass_left);
}

double BlastLoad::gas_enthalpy(double swept_volume, double time, const GasState& state) const {
  if (!expansion_) return 0.0;
  return (gas_energy(swept_volume, time, state) +
          gas_pressure(swept_volume, time, state) * gas_room(swept_volume, state)) /
         (state.mass_left * products_mass_);
}

void BlastLoad::take_gas(GasState& state, double swept_volume, double time, double share,
                         double energy) const {
  const double left = gas_energy(swept_volume, time, state) - energy;
  state.mass_left -= share;
  state.hotter *= left / gas_energy(swept_volume, time, state);
}

BlastLoad::StartEnergies BlastLoad::start_energies() const {
  if (!expansion_) return {};
  const auto stored = [this](double volume) {
    return charge_volume_ * expansion_->stored_energy(volume / charge_volume_);
  };
  const double products = charge_volume_ * expansion_->energy();
  return {products, products - stored(pulse_volume_),
          stored(pulse_volume_) - stored(start_volume_)};
}

void BlastLoad::advance(GasState& state, double swept_volume, double time, double dt) const {
  if (!expansion_) return;
  if (!vent_) {
    state.vented_energy +=
        gas_energy(swept_volume, time, state) - gas_energy(swept_volume, time + dt, state);
    return;
  }
  const Chamber chamber{
      .pressure = gas_pressure(swept_volume, time, state),
      .gas_density = state.mass_left * products_mass_ / gas_room(swept_volume, state),
      .swept_volume = swept_volume,
      .time = time};
  const double before = state.mass_left, enthalpy = gas_enthalpy(swept_volume, time, state);
  const GasState plug = state;
  vent_->advance(state, chamber, dt);
  state.vented_energy += (before - state.mass_left) * products_mass_ * enthalpy;
  if (state.stemming_path > plug.stemming_path) {
    GasState unmoved = state;
    unmoved.stemming_path = plug.stemming_path;
    state.stemming_work +=
        gas_energy(swept_volume, time, unmoved) - gas_energy(swept_volume, time, state);
  }
}

double BlastLoad::pressure(double tau, double gas_pressure, double pulse_limit) const {
  if (tau <= 0.0) return 0.0;
  return std::max(std::min(wave_peak_ * pulse_.shape(tau), pulse_limit),
                  gas_pressure * pulse_.ramp(tau));
}

double BlastLoad::wave_share(double tau, double gas_pressure, double pulse_limit) const {
  const double load = pressure(tau, gas_pressure, pulse_limit);
  return load > 0.0 ? std::min(wave_peak_ * pulse_.shape(tau), pulse_limit) / load : 0.0;
}

double BlastLoad::bound(double tau, double gas_pressure) const {
  return std::max(wave_peak_ * pulse_.bound(tau), gas_pressure);
}

bool BlastLoad::pulse_over(double tau) const {
  return tau > pulse_.rise_time() && pulse_.bound(tau) <= kPulseLeft;
}

double BlastLoad::greatest_pressure() const {
  return std::max(wave_peak_, wall_share(0.0) * gas_pressure(0.0, 0.0));
}

}  // namespace muckpile
