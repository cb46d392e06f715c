// SPDX-License-Identifier: GPL-2.0-or-later
// The charge of a deck of a pattern: what its row says, else what the words of the style say.
// Scope: explosive and shape; its load is hole_loads.h, its crushed zone design_zones.h.
#pragma once

#include "explosive/charge_options.h"
#include "explosive/hole_table.h"

namespace muckpile {

/// With density and detonation velocity of the row. InputError if the table of explosives lacks the
/// name.
[[nodiscard]] NamedExplosive deck_explosive(const ChargeOptions& options, const Deck& deck);

/// With what stands around the charge by its row.
[[nodiscard]] ChargeOptions deck_options(const ChargeOptions& options, const Deck& deck);

/// In a chamber of this length [m]; not checked.
[[nodiscard]] ChargeShape deck_shape(const ChargeOptions& options, const Deck& deck,
                                     double chamber_length);

}  // namespace muckpile
