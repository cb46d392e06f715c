// SPDX-License-Identifier: GPL-2.0-or-later
// Radius of the crushed zone around a borehole, by the strength of the rock or published formulas.
// Scope: one hole in intact rock; the formulas differ by several times, so all are offered. They
// are of charges that fill their holes; pressure_share tells what a decoupled one presses.
#pragma once

#include <array>

namespace muckpile {

enum class CrushedZone { strength, multiple, esen, djordjevic, kanchibotla, dai };
inline constexpr std::array kCrushedZones = {"strength",   "multiple",    "esen",
                                             "djordjevic", "kanchibotla", "dai"};

/// Peak pressure down to which rock is crushed, over its uniaxial strength: ours, three hole radii
/// round an emulsion in granite (docs/theory/charge.md).
inline constexpr double kCrushingFactor = 3.15;

struct CrushedZoneInput {
  double hole_radius = 0.0;        ///< r_b [m]
  double borehole_pressure = 0.0;  ///< P0 of a charge that fills the hole [Pa]
  double cj_pressure = 0.0;        ///< Chapman-Jouguet [Pa]
  double wall_shock = 0.0;         ///< P_w, impedance-matched [Pa]
  double youngs_modulus = 0.0;     ///< of the intact rock [Pa]
  double poisson_ratio = 0.0;
  double ucs = 0.0;               ///< uniaxial compressive strength of the intact rock [Pa]
  double tensile_strength = 0.0;  ///< of the intact rock [Pa]
  double crushing_factor = kCrushingFactor;  ///< sigma_cr over ucs [-]; `strength` only
  double strain_rate = 1e3;                  ///< in the crushed zone, 1e2 to 1e4 [1/s]; `dai` only
  double multiple = 3.0;  ///< radius over hole radius of a full hole; `multiple` only
  /// Peak on the wall of the hole over that of a charge that fills it. Each pressure above counts
  /// by so much [-].
  double pressure_share = 1.0;
  /// alpha, of the peak in crushed rock; `strength` and `multiple` only.
  double attenuation_exponent = 2.0;
};

/// Peak on the wall of the hole [Pa].
[[nodiscard]] double wall_peak(const CrushedZoneInput& input);

/// Radius [m], never below the hole's. InputError names what is out of range.
///   strength     r_b (P_b / sigma_cr)^(1/alpha), sigma_cr = crushing_factor x ucs: where the peak
///                P_b (r_b/r)^alpha has fallen to what the rock bears
///   multiple     ratio x r_b (3 is what particle models load; Yan et al. 2016), which takes the
///                rock to be crushed down to the peak P0/ratio^alpha: r_b ratio share^(1/alpha)
///                where share of P0 is on the wall
///   esen         r_b 0.812 CZI^0.219, CZI = P_b^3 (1 + nu)/(E sigma_c^2), r_b below CZI 2.6
///                (Esen, Onederra and Bilgin 2003)
///   djordjevic   r_b / sqrt(24 sigma_t / P_b) (Djordjevic 1999, Griffith's criterion)
///   kanchibotla  r_b sqrt(P_CJ / sigma_c) (Kanchibotla et al. 1999)
///   dai          r_b [P_w B / (sqrt 2 sigma_cd)]^(1/(2 + b)), b = mu/(1 - mu), mu = 0.8 nu,
///                B^2 = (1 + b)^2 + 1 + b^2 - 2 mu (1 - mu)(1 - b)^2,
///                sigma_cd = sigma_c (strain rate x 1 s)^(1/3) (Dai Jun 2001)
/// Where each was seen: docs/sources.md.
[[nodiscard]] double crushed_zone_radius(CrushedZone model, const CrushedZoneInput& input);

}  // namespace muckpile
