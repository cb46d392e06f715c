// SPDX-License-Identifier: GPL-2.0-or-later
// p(V) of the detonation products by the chosen law, and where its gas stage starts.
// Scope: one charge; no heat loss. Who loads a wall or lets gas out takes the law from here only.
#pragma once

#include <variant>

#include "explosive/jwl_isentrope.h"
#include "explosive/two_stage_isentrope.h"

namespace muckpile {

class ProductExpansion {
 public:
  /// Each has the member functions below. A new law: its type joins this list, its name and case
  /// charge_options.cpp.
  using Law = std::variant<TwoStageIsentrope, JwlGas>;

  explicit ProductExpansion(const Law& law);

  /// [Pa] at a volume ratio V/V0; below 1 it is held at that of V0.
  [[nodiscard]] double pressure(double volume_ratio) const {
    return std::visit([volume_ratio](const auto& law) { return law.pressure(volume_ratio); }, law_);
  }
  /// V_k/V0, where the gas stage starts [-].
  [[nodiscard]] double switch_ratio() const { return switch_ratio_; }
  /// Exponent of the expanded gas, with which it flows [-].
  [[nodiscard]] double gamma() const;
  /// Per volume V0 of charge [J/m3]: all that the expansion from a volume ratio V/V0 to nothing can
  /// do, the integral of pressure() from there on.
  [[nodiscard]] double stored_energy(double volume_ratio) const;
  /// The same from V0 on: what the products hold at the explosion state [J/m3].
  [[nodiscard]] double energy() const { return stored_energy(1.0); }

 private:
  Law law_;
  double switch_ratio_;
};

}  // namespace muckpile
