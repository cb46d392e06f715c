// SPDX-License-Identifier: GPL-2.0-or-later
// Charges of decks; see the header.
#include "explosive/deck_charge.h"

namespace muckpile {

NamedExplosive deck_explosive(const ChargeOptions& options, const Deck& deck) {
  NamedExplosive explosive =
      deck.explosive ? table_explosive(options, *deck.explosive, "hole_table") : options.explosive;
  explosive.density = deck.explosive_density.value_or(explosive.density);
  explosive.detonation_velocity = deck.detonation_velocity.value_or(explosive.detonation_velocity);
  return explosive;
}

ChargeOptions deck_options(const ChargeOptions& options, const Deck& deck) {
  ChargeOptions own = options;
  own.decoupling.coupling = deck.coupling.value_or(own.decoupling.coupling);
  return own;
}

ChargeShape deck_shape(const ChargeOptions& options, const Deck& deck, double chamber_length) {
  ChargeShape shape;
  shape.hole_radius = 0.5 * deck.diameter;
  shape.charge_radius = options.charge_radius.value_or(shape.hole_radius);
  if (deck.charge_diameter) shape.charge_radius = 0.5 * *deck.charge_diameter;
  shape.chamber_length = chamber_length;
  shape.charge_length = deck.charge_length.value_or(options.charge_length.value_or(chamber_length));
  return shape;
}

}  // namespace muckpile
