// SPDX-License-Identifier: GPL-2.0-or-later
// Heat into the wall of a crack against the exact solution of the half space behind a film.
// Scope: one wall in gas of constant temperature; Carslaw & Jaeger (1959), section 2.7.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "args/input_error.h"
#include "gas/wall_heat.h"

namespace muckpile {
namespace {

constexpr double kEffusivity = 2500.0, kGas = 2288.0, kRock = 288.0;

/// exp(b^2) erfc(b), by its series for large b where the factors leave the range.
double scaled_erfc(double b) {
  if (b < 20.0) return std::exp(b * b) * std::erfc(b);
  const double x = 1.0 / (2.0 * b * b);
  return (1.0 - x + 3.0 * x * x) / (b * std::sqrt(M_PI));
}

/// Heat per area that the wall takes in a time through a film [J/m2]: b = h t^(1/2)/e,
/// Q = (dT e^2/h) [exp(b^2) erfc(b) - 1 + 2 b/pi^(1/2)].
double exact_heat(double film, double time) {
  const double b = film * std::sqrt(time) / kEffusivity;
  return (kGas - kRock) * kEffusivity * kEffusivity / film *
         (scaled_erfc(b) - 1.0 + 2.0 * b / std::sqrt(M_PI));
}

double heat_by_steps(double film, double time, int steps) {
  const WallHeat wall({.effusivity = kEffusivity, .rock_temperature = kRock});
  const RockLayers::Step step(wall.rock(), time / steps);
  RockLayers::Excess rock{};
  double heat = 0.0;
  for (int n = 0; n < steps; ++n) {
    heat += step.take_from(kGas - kRock, 1.0 / film, rock) * time / steps;
  }
  return heat;
}

TEST(WallHeat, FilmAndRockInSeriesAreWithinThreePerCentOfTheExactSolution) {
  double worst = 0.0;
  for (const double b : {0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0}) {
    constexpr double kTime = 0.01;
    const double film = b * kEffusivity / std::sqrt(kTime);
    const double error = heat_by_steps(film, kTime, 300) / exact_heat(film, kTime) - 1.0;
    std::cout << "h t^(1/2)/e = " << b << ": heat off by " << 100.0 * error << " %\n";
    worst = std::max(worst, std::abs(error));
  }
  EXPECT_LT(worst, 0.03);
}

TEST(WallHeat, FilmIsTheReynoldsAnalogy) {  // f/8 G cp at a Prandtl number of 1
  const WallHeat wall({.prandtl = 1.0});
  EXPECT_DOUBLE_EQ(wall.film(0.08, 1e4, 1300.0), 0.01 * 1e4 * 1300.0);
  EXPECT_NEAR(WallHeat({.prandtl = 0.7}).film(0.08, 1e4, 1300.0) / 1.3e5, 1.2684, 1e-4);
}

TEST(WallHeat, RefusesWhatIsNoRock) {
  EXPECT_THROW(WallHeat({.effusivity = -1.0}), InputError);
  EXPECT_THROW(WallHeat({.rock_temperature = 0.0}), InputError);
  EXPECT_THROW(WallHeat({.prandtl = 0.0}), InputError);
}

}  // namespace
}  // namespace muckpile
