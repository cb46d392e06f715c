// SPDX-License-Identifier: GPL-2.0-or-later
// What LAMMPS' `damping tsuji` must be given so that its dashpot is as strong as Muckpile's.
// Scope: crosscheck_tsuji_damping pair|wall RESTITUTION prints it. pair: between clumps, Muckpile's
// contact, which never pulls (damping_ratio_for in contact_law.h). wall: LIGGGHTS' wall, which sees
// the mass of one of the eight spheres where LAMMPS sees the clump's.
#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contact/contact_law.h"

namespace {

/// Strength of LAMMPS' dashpot over sqrt(k m), a polynomial in its number (Tsuji et al. 1992,
/// fitted in pair_granular's documentation); falls from 1.27 at 0 to 0 at 1.
double strength(double x) {
  constexpr double kTerms[] = {4.8218, -18.022, 27.467, -22.348, 11.087, -4.2783, 1.2728};
  double sum = 0.0;
  for (const double term : kTerms) sum = sum * x + term;
  return sum;
}

double number_of(double wanted) {
  double low = 0.0, high = 1.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (strength(middle) > wanted ? low : high) = middle;
  }
  return high;
}

double damping_ratio(const std::string& contact, double restitution) {
  if (contact == "pair") return muckpile::damping_ratio_for(restitution);
  if (contact != "wall") throw std::runtime_error("must be pair or wall, got '" + contact + "'");
  constexpr double kSpheres = 8.0;
  return -std::log(restitution) / std::hypot(std::log(restitution), std::numbers::pi) /
         std::sqrt(kSpheres);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s pair|wall RESTITUTION\n", argv[0]);
    return 2;
  }
  try {
    std::printf("%.6f\n", number_of(std::sqrt(5.0) * damping_ratio(argv[1], std::stod(argv[2]))));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "crosscheck_tsuji_damping: %s\n", error.what());
    return 1;
  }
  return 0;
}
