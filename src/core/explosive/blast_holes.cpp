// SPDX-License-Identifier: GPL-2.0-or-later
// Gas, pressures and books of the charged holes; see the header.
#include "explosive/blast_holes.h"

#include <algorithm>
#include <numeric>

namespace muckpile {

void BlastHoles::set(std::vector<HoleBlast> blasts, std::vector<HoleCharge> charges) {
  blasts_ = std::move(blasts);
  charges_ = std::move(charges);
  state_.swept.resize(count(), 0.0);
  state_.gas.resize(count());
  state_.over.resize(count(), 0);
  state_.books.resize(count());
  pressures_.resize(count());
}

bool BlastHoles::any_fired(double time) const {
  return std::ranges::any_of(
      blasts_, [time](const HoleBlast& blast) { return time >= blast.firing_time(); });
}

bool BlastHoles::all_over() const {
  return std::ranges::all_of(state_.over, [](char over) { return over != 0; });
}

bool BlastHoles::any_pulse(double time) const {
  return std::ranges::any_of(blasts_, [time](const HoleBlast& blast) {
    return time >= blast.firing_time() && !blast.pulse_over(time);
  });
}

int BlastHoles::active(double time) const {
  int active = 0;
  for (std::size_t h = 0; h < count(); ++h)
    active += !over(h) && time >= blasts_[h].firing_time() ? 1 : 0;
  return active;
}

void BlastHoles::start_from(std::span<const double> swept) {
  for (std::size_t h = 0; h < count(); ++h) state_.swept[h] = state_.gas[h].swept_before = swept[h];
}

void BlastHoles::book_walls(std::span<const double> swept, std::span<const double> work,
                            double time) {
  for (std::size_t h = 0; h < count(); ++h) {
    HoleBooks& books = state_.books[h];
    books.wall_work += work[h];
    if (!over(h) && time >= blasts_[h].firing_time()) {
      const auto pressure = [&](double volume) {
        return blasts_[h].gas_pressure(volume, time, state_.gas[h]);
      };
      const double more = swept[h] - state_.swept[h];
      books.expansion += 0.5 * (pressure(state_.swept[h]) + pressure(swept[h])) * more;
      books.air_volume += more;
    }
    state_.swept[h] = swept[h];
  }
}

void BlastHoles::advance(double time, double dt) {
  for (std::size_t h = 0; h < count(); ++h)
    if (!over(h)) blasts_[h].advance(state_.gas[h], state_.swept[h], time, dt);
}

void BlastHoles::press(double time) {
  for (std::size_t h = 0; h < count(); ++h) {
    const HoleBlast& blast = blasts_[h];
    const double swept = state_.swept[h];
    const GasState& gas = state_.gas[h];
    Pressures& found = pressures_[h];
    found.gas = std::max(0.0, blast.gas_pressure(swept, time, gas) - ambient_);
    found.on_wall = found.gas * blast.wall_share(swept, gas);
    found.limit = blast.pulse_limit(swept, time, gas) - ambient_;
    if (blast.over(time, found.on_wall)) end(h, time);
    if (over(h)) found.gas = found.on_wall = 0.0;
  }
}

BlastHoles::OnWall BlastHoles::on_wall(std::size_t hole, double arrival, double time) const {
  const HoleBlast& blast = blasts_[hole];
  const Pressures& found = pressures_[hole];
  return {over(hole) ? 0.0 : blast.pressure(arrival, time, found.on_wall, found.limit),
          blast.load().wave_share(time - arrival, found.on_wall, found.limit)};
}

BlastHoles::Gas BlastHoles::gas(std::size_t hole, double time) const {
  const HoleBlast& blast = blasts_[hole];
  const double swept = state_.swept[hole];
  const GasState& state = state_.gas[hole];
  const double share = blast.wall_share(swept, state);
  const double mass = state.mass_left * charges_[hole].gas;
  return {mass, share * blast.gas_pressure(swept, time, state),
          share * mass / blast.gas_volume(swept, state), blast.gas_enthalpy(swept, time, state),
          blast.gas_energy(swept, time, state) / mass};
}

void BlastHoles::take_gas(std::size_t hole, double mass, double energy, double time) {
  blasts_[hole].take_gas(state_.gas[hole], state_.swept[hole], time, mass / charges_[hole].gas,
                         energy);
  state_.books[hole].into_joints += energy;
}

void BlastHoles::release_gas(double time) {
  for (std::size_t h = 0; h < count(); ++h) end(h, time);
}

/// What gas is left in a hole that is over goes into the open.
void BlastHoles::end(std::size_t hole, double time) {
  if (over(hole)) return;
  state_.books[hole].let_go += blasts_[hole].gas_energy(state_.swept[hole], time, state_.gas[hole]);
  state_.over[hole] = 1;
}

EnergyAudit BlastHoles::audit(std::size_t hole, double time) const {
  const HoleBlast& blast = blasts_[hole];
  const GasState& gas = state_.gas[hole];
  if (time < blast.firing_time()) return {};
  const double in_hole = over(hole) ? 0.0 : blast.gas_energy(state_.swept[hole], time, gas);
  return audit_of_hole(blast.load(), charges_[hole].energy, in_hole, gas, state_.books[hole],
                       ambient_);
}

HoleAudit BlastHoles::hole_audit(std::size_t hole, double time) const {
  const GasState& gas = state_.gas[hole];
  return {audit(hole, time), state_.books[hole].into_joints, gas.stemming_out, gas.stemming_speed};
}

double BlastHoles::swept_volume() const {
  return std::accumulate(state_.swept.begin(), state_.swept.end(), 0.0);
}

double BlastHoles::explosive_mass() const {
  double mass = 0.0;
  for (const HoleCharge& charge : charges_) mass += charge.mass;
  return mass;
}

double BlastHoles::explosive_energy() const {
  double energy = 0.0;
  for (const HoleCharge& charge : charges_) energy += charge.energy;
  return energy;
}

}  // namespace muckpile
