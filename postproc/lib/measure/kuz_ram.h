// SPDX-License-Identifier: GPL-2.0-or-later
// Kuz-Ram: the size curve that the formula of Kuznetsov and Cunningham gives for a blast.
// Scope: the form of 1987 for one kind of charge per hole; an estimate beside a simulation, never
// part of it. SI units inside; the formulas' own are made here.
#pragma once

#include "geometry/size/size_target.h"

namespace muckpile {

struct KuzRamBlast {
  double burden, spacing, bench_height;  // [m]
  double hole_diameter;                  // [m]
  double charge_above_floor;             // length of charge above grade [m]
  double charge_mass;                    // per hole [kg]
  double weight_strength;                // energy per mass over that of ANFO, ANFO = 100
  double rock_factor;                    // A, 0.8 to 22
  double drilling_deviation = 0.0;       // standard deviation of the holes' place at the toe [m]
};

struct KuzRamCurve {
  double x50;  // [m]
  double n;    // exponent of Rosin-Rammler
  [[nodiscard]] SizeTarget curve() const { return SizeTarget::kuz_ram(x50, n); }
};

// x50 = A q^-0.8 Q^(1/6) (115/RWS)^(19/30) [cm], q in kg/m3, Q in kg; n = (2.2 - 14 B/d)
// sqrt((1 + S/B)/2) (1 - W/B) L/H, d in mm. Throws InputError where n is not > 0 or an input is not
// positive.
KuzRamCurve kuz_ram(const KuzRamBlast& blast);

// A = 0.06 (RMD + RDI + HF) with RDI = 25 rho - 50 [t/m3], HF = E/3 [GPa] below 50 GPa, else
// UCS/5 [MPa]. `mass_rating` is RMD: 10 powdery, 50 massive, more where joints decide.
double lilly_rock_factor(double mass_rating, double density, double youngs_modulus, double ucs);

}  // namespace muckpile
