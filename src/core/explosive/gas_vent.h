// SPDX-License-Identifier: GPL-2.0-or-later
// How the gas of one hole leaves: through the collar once the stemming is out, and through cracks.
// Scope: one pressure in the chamber; choked flow; no gas dynamics in the cracks, no atmosphere.
#pragma once

#include "state/encoding.h"

namespace muckpile {

/// What the hole remembers.
struct GasState {
  double mass_left = 1.0;       ///< share of the products still in the chamber
  double stemming_path = 0.0;   ///< way that the stemming has gone towards the collar [m]
  double stemming_speed = 0.0;  ///< [m/s]
  double swept_before = 0.0;    ///< swept volume at firing [m3]
  double hotter = 1.0;          ///< energy over that on the products' isentrope [-]
  double vented_energy = 0.0;  ///< that the gas which left through collar and cracks took along [J]
  double stemming_work = 0.0;  ///< of the gas on the stemming, with what lies above it [J]
  double stemming_out = kHolds;  ///< since the primer fired, when the stemming had left [s]

  static constexpr double kHolds = -1.0;  ///< of stemming_out: it is in the hole
};
template <>
struct Stored<GasState> {
  static constexpr std::string_view kName = "gas_state";
  static constexpr int kVersion = 3;
  static auto fields(auto& gas) {
    return std::tie(gas.mass_left, gas.stemming_path, gas.stemming_speed, gas.swept_before,
                    gas.hotter, gas.vented_energy, gas.stemming_work, gas.stemming_out);
  }
};

/// Chamber at one instant.
struct Chamber {
  double pressure;      ///< [Pa]
  double gas_density;   ///< [kg/m3]
  double swept_volume;  ///< by the crushed-zone wall [m3]
  double time;          ///< since the primer fired [s]
};

/// Mass flow per area through a choked opening [kg/(m2 s)]:
/// (gamma p rho)^(1/2) (2/(gamma + 1))^((gamma + 1)/(2 (gamma - 1))), ideal gas.
[[nodiscard]] double choked_flux(double pressure, double density, double gamma);

class GasVent {
 public:
  struct Parameters {
    double hole_radius;                ///< [m]
    double zone_radius;                ///< r1, of the crushed zone [m]
    double products_mass;              ///< of the gas of the charge [kg]
    double gamma = 1.4;                ///< of the expanded gas, > 1
    double share = 1.0;                ///< of the hole that is modelled, as its mass is (Hole)
    double stemming_length = 0.0;      ///< 0: the collar is open from the start [m]
    double stemming_density = 1800.0;  ///< [kg/m3]
    double stemming_shear = 0.0;       ///< resistance per wall area [Pa]
    double stemming_grain = 0.0;       ///< size of its grains; 0: it leaks nothing [m]
    double collar_discharge = 0.8;     ///< share of the choked flow through the collar
    double crack_delay = 0.0;          ///< until cracks reach a free face [s]
    double crack_discharge = 0.05;     ///< share of the choked flow through the cracks
  };

  /// InputError on a value out of range.
  explicit GasVent(const Parameters& parameters);

  /// Area of the openings times their discharge [m2]. The collar opens when the stemming has gone
  /// its own length; until then gas leaks through the pores of what is left in the hole, in
  /// turbulent flow (Ergun 1952): (p rho)^(1/2) (e^3 d / (3.5 (1 - e) (L - x)))^(1/2)
  /// [kg/(m2 s)]. The cracks' area at the wall is what the wall has lengthened by, times the
  /// charge's length: swept volume / r1 (all stretch taken by open radial cracks; ours).
  [[nodiscard]] double open_area(const GasState& state, const Chamber& chamber) const;

  /// Room in the hole that the stemming has cleared [m3], which the gas fills.
  [[nodiscard]] double cleared_room(const GasState& state) const;

  /// One step on [s]. The stemming is a plug: density x length x acceleration = pressure - 2 shear
  /// x remaining length / hole radius. The mass falls by the choked flux through open_area().
  void advance(GasState& state, const Chamber& chamber, double dt) const;

 private:
  /// Cross section of the hole [m2].
  [[nodiscard]] double bore() const;
  [[nodiscard]] double leak_discharge(double in_hole) const;
  void push_stemming(GasState& state, const Chamber& chamber, double dt) const;

  Parameters p_;
};

}  // namespace muckpile
