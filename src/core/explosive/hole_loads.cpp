// SPDX-License-Identifier: GPL-2.0-or-later
// The loads of all holes; see the header.
#include "explosive/hole_loads.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "args/input_error.h"
#include "explosive/attenuation.h"
#include "explosive/deck_charge.h"
#include "explosive/volume_ratio.h"

namespace muckpile {
namespace {

/// What one row of the pattern says instead of the style's words.
void apply_deck(LoadedHole& hole, const BlastOptions& options, const Deck& deck) {
  hole.explosive = deck_explosive(options.charge, deck);
  if (deck.explosive) hole.energy_known = true;
  hole.shape = deck_shape(options.charge, deck, hole.shape.chamber_length);
  if (deck.primer) hole.primer = *deck.primer;
  hole.firing_time = deck.firing_time;
}

/// Of the charge: pressures follow from ratios of volumes, so half a charge in half a hole presses
/// as the whole does [m3].
double modelled_volume(const LoadedHole& hole, const Hole& zone) {
  return zone.share * hole.shape.charge_volume();
}

double charge_mass(const LoadedHole& hole, const Hole& zone) {
  return hole.explosive.density * modelled_volume(hole, zone);
}

/// Peak at the outer boundary of the crushed rock, with or without a pulse [Pa].
double crushing_peak(const BlastOptions& options, const LoadedHole& hole, const Hole& zone) {
  if (options.peak_pressure) return *options.peak_pressure;
  return attenuated_pressure(hole.wall_pressure, hole.shape.hole_radius, zone.radius,
                             hole.exponent);
}

/// While the gas that has filled its room presses more than the peak on the wall of the crushed
/// zone it crushes: its stage starts where it has come down to that. By JWL no later than its fit
/// holds.
ProductExpansion staged(const ProductExpansion& products, const BlastOptions& options,
                        const LoadedHole& hole, const Hole& zone) {
  if (!stage_by_crushing(options.charge)) return products;
  const double peak = crushing_peak(options, hole, zone);
  const double zone_ratio =
      std::pow(zone.radius, 2.0) * hole.shape.chamber_length * M_PI / hole.shape.charge_volume();
  const double filled = std::max(1.0, free_volume_ratio(hole.shape, hole.decoupling));
  const double ratio = volume_ratio_where(filled, [&](double v) {
    return products.pressure(v) * crushed_rock_share(v, zone_ratio, options.crushed_friction) >
           peak;
  });
  const bool fitted = options.charge.expansion == Expansion::jwl;
  return products.switched_at(fitted ? std::min(ratio, JwlIsentrope::kFittedTo) : ratio);
}

BlastLoad blast_load(const BlastOptions& options, const LoadedHole& hole, const Hole& zone) {
  BlastLoad::Parameters parameters{.wave_peak = wall_peak(options, hole, zone),
                                   .pulse = options.pulse_shape,
                                   .charge_volume = modelled_volume(hole, zone),
                                   .products_mass = charge_mass(hole, zone) * hole.explosive.reacts,
                                   .vent_time = options.vent_time.value_or(0.0),
                                   .vent_decay = options.vent_decay.value_or(1.0)};
  if (!options.gas) return BlastLoad(parameters);
  const ProductExpansion expansion = product_expansion(options.charge, hole.explosive);
  parameters.zone_volume =
      zone.share * M_PI * zone.radius * zone.radius * hole.shape.chamber_length;
  parameters.crushed_friction = options.crushed_friction;
  parameters.free_volume_ratio = free_volume_ratio(hole.shape, hole.decoupling);
  parameters.pulse_volume_ratio = pulse_volume_ratio(hole.wall_pressure / hole.initial_pressure,
                                                     expansion, hole.shape, hole.decoupling);
  parameters.expansion =
      staged(products_in_chamber(expansion, hole.shape, hole.decoupling), options, hole, zone);
  if (options.vent_by_flow) {
    parameters.flow = options.flow;
    parameters.flow->gamma = expansion.gamma();
    parameters.flow->hole_radius = hole.shape.hole_radius;
    parameters.flow->zone_radius = zone.radius;
    parameters.flow->share = zone.share;
    parameters.flow->products_mass = parameters.products_mass;
  }
  return BlastLoad(parameters);
}

void check_zone(const BlastOptions& options, const Hole& zone, std::size_t index) {
  const double diameter =
      options.pattern ? options.pattern->decks()[index].diameter : 2.0 * options.charge.hole_radius;
  if (2.0 * zone.radius >= diameter) return;
  std::ostringstream text;
  text << "hole_diameter must not exceed that of the crushed zone of hole " << index + 1 << ", "
       << 2.0 * zone.radius << " [m], got '" << diameter << "'";
  refuse(options.where, text.str());
}

/// The pattern must be the one that the rock was cut for.
void check_pattern(const BlastOptions& options, const std::vector<Hole>& zones) {
  const std::vector<Deck>& decks = options.pattern->decks();
  if (decks.size() != zones.size()) {
    refuse(options.where, "hole_table must have one row for each of the " +
                              std::to_string(zones.size()) + " holes of create_blocks, got " +
                              std::to_string(decks.size()) + " rows");
  }
  constexpr double kSamePlace = 1e-6;  // [m]
  for (std::size_t k = 0; k < zones.size(); ++k) {
    if ((decks[k].toe - zones[k].toe).norm() < kSamePlace &&
        (decks[k].collar - zones[k].collar).norm() < kSamePlace) {
      continue;
    }
    refuse(options.where, "row " + std::to_string(k + 1) + " of hole_table (hole '" +
                              decks[k].hole + "') is not where create_blocks has its hole " +
                              std::to_string(k + 1));
  }
}

HoleBlast hole_blast(const BlastOptions& options, const Hole& zone, std::size_t index) {
  try {
    const LoadedHole hole = loaded_hole(options, zone, index);
    const Vec3 axis = (zone.collar - zone.toe).normalized();
    return {blast_load(options, hole, zone),
            DetonationFront({.toe = zone.toe,
                             .collar = zone.toe + hole.shape.charge_length * axis,
                             .detonation_velocity = hole.explosive.detonation_velocity,
                             .firing_time = hole.firing_time,
                             .primer = hole.primer})};
  } catch (const InputError& error) {
    refuse(options.where, "hole " + std::to_string(index + 1) + ": " + error.what());
  }
}

double gas_gamma_of(const BlastOptions& options, std::size_t hole) {
  const ChargeOptions& charge = options.charge;
  try {
    const NamedExplosive explosive =
        options.pattern ? deck_explosive(charge, options.pattern->decks()[hole]) : charge.explosive;
    return product_expansion(charge, explosive).gamma();
  } catch (const InputError& error) {
    refuse(options.where, "hole " + std::to_string(hole + 1) + ": " + error.what());
  }
}

}  // namespace

double exponent_of(const BlastOptions& options, Attenuation by, const NamedExplosive& explosive) {
  switch (by) {
    case Attenuation::shock:
      return options.poisson_ratio ? crushed_zone_exponent(*options.poisson_ratio) : 0.0;
    case Attenuation::liu_katsabanis:
      return options.p_wave_speed
                 ? liu_katsabanis_exponent(*options.p_wave_speed, explosive.detonation_velocity)
                 : 0.0;
    case Attenuation::exponent:
      break;
  }
  return options.exponent.value_or(0.0);
}

LoadedHole loaded_hole(const BlastOptions& options, const Hole& zone, std::size_t index) {
  const ChargeOptions& charge = options.charge;
  LoadedHole hole;
  hole.explosive = charge.explosive;
  hole.energy_known = charge.energy_known;
  hole.primer = options.primer;
  const auto own = options.delays.find(static_cast<long>(index) + 1);
  hole.firing_time =
      own != options.delays.end() ? own->second : static_cast<double>(index) * options.interval;
  hole.shape.hole_radius = charge.hole_radius;
  hole.shape.charge_radius = charge.charge_radius.value_or(charge.hole_radius);
  hole.shape.chamber_length = (zone.collar - zone.toe).norm();
  hole.shape.charge_length = charge.charge_length.value_or(hole.shape.chamber_length);
  if (options.pattern) apply_deck(hole, options, options.pattern->decks()[index]);
  check_shape(hole.shape);
  hole.exponent = exponent_of(options, options.attenuation, hole.explosive);
  hole.decoupling =
      options.pattern
          ? decoupling_rule(deck_options(charge, options.pattern->decks()[index]), hole.exponent)
          : decoupling_rule(charge, hole.exponent);
  if (!options.needs_borehole_pressure()) return hole;
  hole.initial_pressure = initial_pressure(charge, hole.explosive);
  hole.wall_pressure =
      wall_pressure(hole.initial_pressure, product_expansion(charge, hole.explosive), hole.shape,
                    hole.decoupling);
  return hole;
}

double wall_peak(const BlastOptions& options, const LoadedHole& hole, const Hole& zone) {
  return options.pulse ? crushing_peak(options, hole, zone) : 0.0;
}

std::vector<HoleBlast> hole_blasts(const BlastOptions& options,
                                   const std::vector<Hole>& crushed_zones) {
  const int count = static_cast<int>(crushed_zones.size());
  if (count == 0) refuse(options.where, "there is no hole to load; give create_blocks a hole");
  for (const auto& [number, delay] : options.delays) {
    if (number >= 1 && number <= count) continue;
    refuse(options.where, "hole must be from 1 to " + std::to_string(count) +
                              ", the holes of create_blocks, got '" + std::to_string(number) + "'");
  }
  if (options.pattern) check_pattern(options, crushed_zones);
  std::vector<HoleBlast> blasts;
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<std::size_t>(i);
    check_zone(options, crushed_zones[index], index);
    blasts.push_back(hole_blast(options, crushed_zones[index], index));
  }
  return blasts;
}

double gas_gamma(const BlastOptions& options) {
  const double gamma = gas_gamma_of(options, 0);
  const std::size_t holes = options.pattern ? options.pattern->decks().size() : 1;
  for (std::size_t k = 1; k < holes; ++k) {
    const double other = gas_gamma_of(options, k);
    if (other == gamma) continue;
    std::ostringstream text;
    text << "gas in joints must have one exponent, got " << gamma << " of hole 1 and " << other
         << " of hole " << k + 1;
    refuse(options.where, text.str());
  }
  return gamma;
}

double gas_constant(const BlastOptions& options, const std::vector<Hole>& crushed_zones) {
  double mass = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < crushed_zones.size(); ++k) {
    const LoadedHole hole = loaded_hole(options, crushed_zones[k], k);
    const double gas = charge_mass(hole, crushed_zones[k]) * hole.explosive.reacts;
    mass += gas;
    sum += gas * gas_constant(hole.explosive);
  }
  return mass > 0.0 ? sum / mass : gas_constant(options.charge.explosive);
}

std::vector<HoleCharge> hole_charges(const BlastOptions& options,
                                     const std::vector<Hole>& crushed_zones) {
  std::vector<HoleCharge> charges;
  for (std::size_t k = 0; k < crushed_zones.size(); ++k) {
    const LoadedHole hole = loaded_hole(options, crushed_zones[k], k);
    const double mass = charge_mass(hole, crushed_zones[k]);
    const double r0 = hole.shape.hole_radius, r1 = crushed_zones[k].radius;
    charges.push_back(
        {mass, mass * hole.explosive.reacts, hole.energy_known ? mass * hole.explosive.energy : 0.0,
         crushed_zones[k].share * M_PI * (r1 * r1 - r0 * r0) * hole.shape.chamber_length});
  }
  return charges;
}

}  // namespace muckpile
