// SPDX-License-Identifier: GPL-2.0-or-later
// Heat that crushed rock takes from the gas that passes it on its way from a hole into joints.
// Scope: one crushed zone, all of it passed alike; no heat from the rock back into colder gas.
//
// Grains of diameter d fill the volume V between hole and joints: a surface A = 6 V/d, so large
// that the gas leaves with the temperature Ts of the grains' surface (with the film of a packed
// bed, Wakao & Kaguei 1982, 0.1 m of grains of 1 mm could pass on some eight times what it
// carries). With C = cp dm/dt of the gas, Q what the grains have taken and q the heat flux into
// them,
//     C (T - Ts) = q A,     Ts - T0 = Q/(rho c V) + min(y, q d/(10 k)),     q = (2/pi) e^2 y^2 A/Q:
// the mean of the grains, and the excess of their surface, first that of a half space
// (wall_heat.h), later that of a sphere which is heated evenly (Carslaw & Jaeger 1959,
// section 9.8), k = e^2/(rho c). Against the exact sphere Ts - T0 is up to a quarter high, so the
// heat is rather low.
#pragma once

#include <string_view>
#include <tuple>

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
    double heat = 0.0;  ///< Q [J]
    double flow = 0.0;  ///< C of the last step [W/K]
  };

  /// InputError on a value out of range.
  explicit CrushedBed(const Parameters& parameters);

  /// Of the enthalpy of gas of a temperature [K] (enthalpy over cp) what it keeps when it passes a
  /// `volume` of crushed rock [m3].
  [[nodiscard]] double kept(const State& state, double volume, double temperature) const;

 private:
  [[nodiscard]] double flux(const State& state, double area, double excess) const;

  Parameters p_;
  WallHeat rock_;
};

template <>
struct Stored<CrushedBed::State> {
  static constexpr std::string_view kName = "crushed_bed";
  static constexpr int kVersion = 1;
  static auto fields(auto& bed) { return std::tie(bed.heat, bed.flow); }
};

}  // namespace muckpile
