// SPDX-License-Identifier: GPL-2.0-or-later
// p(V) of the detonation products by the chosen law, and where its gas stage starts.
// Scope: one charge; no heat loss. Who loads a wall or lets gas out takes the law from here only.
#pragma once

#include <variant>

#include "explosive/covolume_isentrope.h"
#include "explosive/jwl_isentrope.h"
#include "explosive/two_stage_isentrope.h"

namespace muckpile {

class ProductExpansion {
 public:
  /// Each has the member functions below. A new law: its type joins this list, its name
  /// charge_options.cpp, its case charge_products.cpp.
  using Law = std::variant<TwoStageIsentrope, JwlGas, CovolumeIsentrope>;

  explicit ProductExpansion(const Law& law);

  /// [Pa] at a volume ratio V/V0; below 1 it stays that of V0.
  [[nodiscard]] double pressure(double volume_ratio) const;
  /// V_k/V0, where the gas stage starts [-].
  [[nodiscard]] double switch_ratio() const { return switch_ratio_; }
  /// Exponent of the expanded gas, with which it flows [-].
  [[nodiscard]] double gamma() const;
  /// Per volume V0 of charge [J/m3]: all that the expansion from a volume ratio V/V0 to nothing can
  /// do, the integral of pressure() from there on.
  [[nodiscard]] double stored_energy(double volume_ratio) const;
  /// The same from where they start: what the products hold [J/m3].
  [[nodiscard]] double energy() const { return stored_energy(filled_); }
  /// Work per volume V0 of charge from where they start down to a pressure [J/m3].
  [[nodiscard]] double work_down_to(double pressure) const;

  /// The same law with its gas stage from where it has done a share, 0 to 1 (exclusive), of the
  /// work that it can do.
  [[nodiscard]] ProductExpansion switched_after(double share) const;
  /// The same from a volume ratio V/V0 on.
  [[nodiscard]] ProductExpansion switched_at(double volume_ratio) const;

  /// The products once they have filled a room of this volume ratio without work, and have come to
  /// rest: in it they have the energy that they had in V0. The law's pressures times
  /// energy()/stored_energy (ratio), exact for a gas of constant exponent with or without covolume,
  /// where more heat at one volume is more pressure in proportion; below that ratio it stays that
  /// of the room.
  [[nodiscard]] ProductExpansion after_filling(double volume_ratio) const;

 private:
  Law law_;
  double switch_ratio_;
  double filled_ = 1.0;  // volume ratio from which they expand
  double hotter_ = 1.0;  // their pressures over the law's
};

}  // namespace muckpile
