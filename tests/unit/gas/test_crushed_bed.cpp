// SPDX-License-Identifier: GPL-2.0-or-later
// Heat into crushed rock against spheres cut into shells, and its bounds.
// Scope: one bed, gas of constant temperature and flow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "args/input_error.h"
#include "gas/crushed_bed.h"

namespace muckpile {
namespace {

constexpr double kGrain = 1e-3, kVolume = 0.05, kCapacity = 2.1e6, kEffusivity = 2500.0;
constexpr double kGas = 2288.0, kRock = 288.0;
constexpr double kArea = 6.0 * kVolume / kGrain;  // [m2]

CrushedBed bed_of(double grain) {
  return CrushedBed({.grain = grain,
                     .heat_capacity = kCapacity,
                     .rock = {.effusivity = kEffusivity, .rock_temperature = kRock}});
}

/// Heat that the bed takes in a time [J], by steps.
double heat_of_bed(double flow, double time, int steps) {
  const CrushedBed bed = bed_of(kGrain);
  CrushedBed::State state{.flow = flow};
  for (int n = 0; n < steps; ++n)
    state.heat += flow * kGas * (1.0 - bed.kept(state, kVolume, kGas)) * time / steps;
  return state.heat;
}

/// The same of spheres cut into shells of equal thickness, whose surface gives C (T - Ts).
double heat_of_spheres(double flow, double time) {
  constexpr int kShells = 100;
  const double conductivity = kEffusivity * kEffusivity / kCapacity;
  const double width = 0.5 * kGrain / kShells;
  const double dt = 0.2 * width * width * kCapacity / conductivity;
  const auto area = [&](int n) { return 4.0 * M_PI * std::pow(n * width, 2); };
  const auto room = [&](int n) {
    return 4.0 / 3.0 * M_PI * (std::pow((n + 1) * width, 3) - std::pow(n * width, 3));
  };
  const double grains = kArea / area(kShells);
  std::vector<double> excess(kShells, 0.0), heat(kShells + 1, 0.0);
  double taken = 0.0;
  for (double t = 0.0; t < time; t += dt) {
    for (int n = 1; n < kShells; ++n)
      heat[static_cast<std::size_t>(n)] =
          area(n) * conductivity / width *
          (excess[static_cast<std::size_t>(n)] - excess[static_cast<std::size_t>(n) - 1]);
    // Half a shell and the gas in series.
    const double through = area(kShells) * conductivity / (0.5 * width);
    const double by_gas = flow / grains;
    heat[kShells] = (kGas - kRock - excess.back()) / (1.0 / through + 1.0 / by_gas);
    for (int n = 0; n < kShells; ++n)
      excess[static_cast<std::size_t>(n)] +=
          (heat[static_cast<std::size_t>(n) + 1] - heat[static_cast<std::size_t>(n)]) * dt /
          (kCapacity * room(n));
    taken += heat[kShells] * dt * grains;
  }
  return taken;
}

TEST(CrushedBed, TakesUpToATenthLessThanSpheres) {
  double low = 0.0, high = 0.0;
  for (const double flow : {1e5, 1e6, 1e7, 1e8}) {  // [W/K]
    for (const double time : {1e-4, 1e-3, 1e-2, 5e-2}) {
      const double error = heat_of_bed(flow, time, 20000) / heat_of_spheres(flow, time) - 1.0;
      std::cout << "C " << flow << " W/K, " << time << " s: heat off by " << 100.0 * error
                << " %\n";
      low = std::min(low, error);
      high = std::max(high, error);
    }
  }
  EXPECT_GT(low, -0.13);
  EXPECT_LT(high, 0.04);
}

TEST(CrushedBed, GasThatCreepsLeavesAsColdAsTheRock) {
  const CrushedBed bed = bed_of(kGrain);
  EXPECT_DOUBLE_EQ(bed.kept({}, kVolume, kGas), kRock / kGas);
  EXPECT_NEAR(bed.kept({.flow = 1e-3}, kVolume, kGas), kRock / kGas, 1e-6);
}

TEST(CrushedBed, NeverGetsHotterThanItsGas) {
  const double full = kCapacity * kVolume * (kGas - kRock);
  EXPECT_NEAR(heat_of_bed(1e7, 10.0, 100000) / full, 1.0, 1e-6);
  const CrushedBed bed = bed_of(kGrain);
  EXPECT_EQ(bed.kept({.heat = 2.0 * full, .flow = 1e6}, kVolume, kGas), 1.0);
}

TEST(CrushedBed, CoarseGrainsAndFastGasKeepMoreHeat) {
  const CrushedBed fine = bed_of(1e-3), coarse = bed_of(1e-2);
  const CrushedBed::State state{.heat = 1e6, .flow = 1e7};
  EXPECT_LT(fine.kept(state, kVolume, kGas), coarse.kept(state, kVolume, kGas));
  EXPECT_LT(fine.kept(state, kVolume, kGas), fine.kept({.heat = 1e6, .flow = 1e9}, kVolume, kGas));
}

TEST(CrushedBed, IsThereOnlyWithGrainsRockAndHeat) {
  EXPECT_EQ(bed_of(0.0).kept({.flow = 1e6}, kVolume, kGas), 1.0);
  EXPECT_EQ(bed_of(kGrain).kept({.flow = 1e6}, 0.0, kGas), 1.0);
  EXPECT_EQ(CrushedBed({.grain = kGrain, .heat_capacity = kCapacity, .rock = {.effusivity = 0.0}})
                .kept({}, kVolume, kGas),
            1.0);
}

TEST(CrushedBed, RefusesWhatIsNoRock) {
  EXPECT_THROW(bed_of(-1.0), InputError);
  EXPECT_THROW(CrushedBed({.heat_capacity = 0.0, .rock = {}}), InputError);
}

}  // namespace
}  // namespace muckpile
