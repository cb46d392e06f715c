// SPDX-License-Identifier: GPL-2.0-or-later
// p(V) of the detonation products by the chosen law, and where its gas stage starts.
// Scope: one charge; two-stage isentrope, or JWL if its parameters are given.
#pragma once

#include <optional>

#include "explosive/jwl_isentrope.h"
#include "explosive/two_stage_isentrope.h"

namespace muckpile {

class ProductExpansion {
 public:
  /// Of `two_stage` only the switch pressure p_k counts when `jwl` is given: the gas stage then
  /// starts where the JWL isentrope passes p_k. InputError as the laws, or if JWL passes p_k beyond
  /// the volumes that it was fitted to.
  ProductExpansion(const TwoStageIsentrope::Parameters& two_stage,
                   const std::optional<JwlParameters>& jwl);

  [[nodiscard]] double pressure(double volume_ratio) const {  ///< [Pa], as the laws'
    return jwl_ ? jwl_->pressure(volume_ratio) : two_stage_.pressure(volume_ratio);
  }
  [[nodiscard]] double switch_ratio() const { return switch_ratio_; }  ///< V_k/V0 [-]

 private:
  TwoStageIsentrope two_stage_;
  std::optional<JwlIsentrope> jwl_;
  double switch_ratio_;
};

}  // namespace muckpile
