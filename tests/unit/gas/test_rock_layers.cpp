// SPDX-License-Identifier: GPL-2.0-or-later
// Conduction into layered rock against exact solutions of the half space and of the sphere.
// Scope: one face, in contact with a given temperature; steps of a gas in joints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

#include "gas/rock_layers.h"

namespace muckpile {
namespace {

constexpr double kEffusivity = 2500.0, kStep = 2.5e-5;  // [s]
constexpr double kHot = 2000.0;                         // [K]
using Course = std::function<double(double)>;  // of the face's temperature [K] over time [s]

/// Heat per area [J/m2] that the face takes in a time while it has these temperatures.
double heat_by_layers(const RockLayers& rock, const Course& face, double time) {
  const RockLayers::Step step(rock, kStep);
  RockLayers::Excess excess{};
  double heat = 0.0;
  const auto steps = static_cast<int>(std::lround(time / kStep));
  EXPECT_NEAR(steps * kStep, time, 1e-9);
  for (int n = 1; n <= steps; ++n) {
    heat += step.take_from(face(n * kStep), 0.0, excess) * kStep;
  }
  EXPECT_NEAR(rock.heat(excess) / heat, 1.0, 1e-9);  // what the layers hold is what they took
  return heat;
}

/// e/pi^(1/2) times the integral of T(s) (t - s)^(-1/2) ds: Carslaw & Jaeger (1959), section 2.5.
double heat_of_half_space(const Course& face, double time) {
  constexpr int kPoints = 20000;
  double sum = 0.0;
  for (int n = 0; n < kPoints; ++n)  // of u = (t - s)^(1/2)
    sum += face(time * (1.0 - std::pow((n + 0.5) / kPoints, 2)));
  return kEffusivity * 2.0 * std::sqrt(time / M_PI) * sum / kPoints;
}

double worst_error(const Course& face, double from) {
  const RockLayers rock = RockLayers::half_space(kEffusivity);
  double worst = 0.0;
  for (double time = from; time < 0.11; time *= 10.0) {
    const double error = heat_by_layers(rock, face, time) / heat_of_half_space(face, time) - 1.0;
    std::cout << "after " << time << " s: heat off by " << 100.0 * error << " %\n";
    EXPECT_LT(error, 0.005);  // it is low
    worst = std::max(worst, std::abs(error));
  }
  return worst;
}

TEST(RockLayers, FaceOfConstantTemperature) {
  EXPECT_LT(worst_error([](double) { return kHot; }, 1e-3), 0.035);
  EXPECT_LT(worst_error([](double) { return kHot; }, 1e-4), 0.08);  // four steps
}

TEST(RockLayers, FaceThatCoolsAsExpandingGas) {
  EXPECT_LT(worst_error([](double t) { return kHot * std::pow(1.0 + t / 1e-3, -0.6); }, 1e-3),
            0.035);
}

TEST(RockLayers, HeatComesBack) {  // hot for a millisecond, then cold
  const Course pulse = [](double t) { return t < 1e-3 + 1e-9 ? kHot : 0.0; };
  const auto exact = [](double t) {
    return kEffusivity * kHot * 2.0 / std::sqrt(M_PI) * (std::sqrt(t) - std::sqrt(t - 1e-3));
  };
  const RockLayers rock = RockLayers::half_space(kEffusivity);
  const double taken = heat_by_layers(rock, pulse, 1e-3);
  for (const double time : {2e-3, 5e-3, 2e-2}) {
    const double left = heat_by_layers(rock, pulse, time);
    std::cout << "of the heat of a pulse " << left / taken << " is in the rock after " << time
              << " s, exact " << exact(time) / exact(1e-3) << '\n';
    EXPECT_NEAR(left / taken, exact(time) / exact(1e-3), 0.006);
  }
}

/// Of what it takes in the end (Carslaw & Jaeger 1959, section 9.3): 1 - 6/pi^2 sum of exp(-(n
/// pi)^2 a t/R^2)/n^2.
double filling_of_sphere(double over_radius_squared) {
  double sum = 0.0;
  for (int n = 1; n < 1000; ++n)
    sum += std::exp(-std::pow(n * M_PI, 2) * over_radius_squared) / (n * n);
  return 1.0 - 6.0 / (M_PI * M_PI) * sum;
}

TEST(RockLayers, SphereOfConstantSurfaceTemperature) {
  constexpr double kDiameter = 1e-3, kCapacity = 2.1e6;
  constexpr double kConductivity = kEffusivity * kEffusivity / kCapacity;
  const RockLayers grain = RockLayers::sphere(kDiameter, kConductivity, kCapacity);
  for (const double time : {1e-3, 1e-2, 3e-2, 0.3}) {
    const double in_the_end = kHot * kCapacity * kDiameter / 6.0;
    const double filled = heat_by_layers(
                              grain, [](double) { return kHot; }, time) /
                          in_the_end;
    const double exact =
        filling_of_sphere(kConductivity / kCapacity * time / std::pow(0.5 * kDiameter, 2));
    std::cout << "sphere after " << time << " s: filled to " << filled << ", exact " << exact
              << '\n';
    EXPECT_NEAR(filled / exact, 1.0, 0.035);
  }
}

}  // namespace
}  // namespace muckpile
