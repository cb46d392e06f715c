// SPDX-License-Identifier: GPL-2.0-or-later
// Heat that crushed rock takes from the gas that passes it on its way from a hole into joints, and
// gives back to colder gas.
// Scope: one crushed zone, all of it passed alike.
//
// Grains of diameter d fill the volume V between hole and joints: a surface A = 6 V/d, so large
// that the gas leaves with the temperature Ts of the grains' surface (with the film of a packed
// bed, Wakao & Kaguei 1982, 0.1 m of grains of 1 mm could pass on some eight times what it
// carries). With C = cp dm/dt of the gas and q the heat flux into the grains,
//     C (T - Ts) = q A:
// as if the gas lay behind a film of C/A on spheres that conduct (rock_layers.h).
#pragma once

#include <string_view>
#include <tuple>

#include "gas/rock_layers.h"
#include "gas/wall_heat.h"
#include "state/encoding.h"

namespace muckpile {

class CrushedBed {
 public:
  struct Parameters {
    double grain = 0.0;            ///< d [m]; 0: the crushed rock takes no heat
    double heat_capacity = 2.1e6;  ///< rho c of the rock [J/(m3 K)]
    WallHeat::Parameters rock;
  };
  struct State {
    RockLayers::Excess grains{};  ///< [K]
    double heat = 0.0;            ///< in them [J]
    double flow = 0.0;            ///< C of the last steps [W/K]
  };

  /// InputError on a value out of range.
  explicit CrushedBed(const Parameters& parameters);

  [[nodiscard]] bool acts() const { return p_.grain > 0.0 && p_.rock.effusivity > 0.0; }
  /// For a time [s].
  [[nodiscard]] RockLayers::Step step(double time) const { return {grains_, time}; }
  /// Of the enthalpy of gas of a temperature [K] (enthalpy over cp) what it has behind a `volume`
  /// of crushed rock [m3], in a step in which it flows as in the last ones. More than 1: the grains
  /// are warmer.
  [[nodiscard]] double kept(const State& state, double volume, double temperature,
                            const RockLayers::Step& step) const;
  /// What has flowed in the step, C [W/K], has left that much heat [J]. A flow that stops is
  /// remembered for some steps: gas that came on at once would leave more than the grains bear.
  void take(State& state, double volume, double heat, double flow,
            const RockLayers::Step& step) const;

 private:
  [[nodiscard]] double area(double volume) const { return 6.0 * volume / p_.grain; }

  Parameters p_;
  RockLayers grains_;
};

template <>
struct Stored<CrushedBed::State> {
  static constexpr std::string_view kName = "crushed_bed";
  static constexpr int kVersion = 2;
  static auto fields(auto& bed) { return std::tie(bed.grains, bed.heat, bed.flow); }
};

}  // namespace muckpile
