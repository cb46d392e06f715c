// SPDX-License-Identifier: GPL-2.0-or-later
// Heat between gas and crushed rock against spheres cut into shells, and its bounds.
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

double kept_of(const CrushedBed& bed, const CrushedBed::State& state, double volume = kVolume) {
  return bed.kept(state, volume, kGas, bed.step(3e-5));
}

/// Heat that the bed takes in a time [J], by steps.
double heat_of_bed(double flow, double time, int steps) {
  const CrushedBed bed = bed_of(kGrain);
  const RockLayers::Step step = bed.step(time / steps);
  CrushedBed::State state{.flow = flow};
  for (int n = 0; n < steps; ++n) {
    const double heat = flow * kGas * (1.0 - bed.kept(state, kVolume, kGas, step)) * time / steps;
    bed.take(state, kVolume, heat, flow, step);
  }
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

TEST(CrushedBed, TakesWhatSpheresTake) {
  double worst = 0.0;
  for (const double flow : {1e5, 1e6, 1e7, 1e8}) {  // [W/K]
    for (const double time : {1e-4, 1e-3, 1e-2, 5e-2}) {
      const double error = heat_of_bed(flow, time, 300) / heat_of_spheres(flow, time) - 1.0;
      std::cout << "C " << flow << " W/K, " << time << " s: heat off by " << 100.0 * error
                << " %\n";
      worst = std::max(worst, std::abs(error));
    }
  }
  EXPECT_LT(worst, 0.032);
}

TEST(CrushedBed, GasThatCreepsLeavesAsColdAsTheRock) {
  const CrushedBed bed = bed_of(kGrain);
  EXPECT_DOUBLE_EQ(kept_of(bed, {}), kRock / kGas);
  EXPECT_NEAR(kept_of(bed, {.flow = 1e-3}), kRock / kGas, 1e-6);
}

TEST(CrushedBed, NeverGetsHotterThanItsGas) {
  const double full = kCapacity * kVolume * (kGas - kRock);
  EXPECT_NEAR(heat_of_bed(1e7, 10.0, 100000) / full, 1.0, 1e-6);
}

TEST(CrushedBed, GrainsThatAreHotterGiveHeatBack) {
  const CrushedBed bed = bed_of(kGrain);
  CrushedBed::State state;
  state.grains.fill(kGas - kRock + 100.0);
  EXPECT_DOUBLE_EQ(kept_of(bed, state), (kGas + 100.0) / kGas);  // gas that creeps
  state.flow = 1e6;
  const double warmed = kept_of(bed, state);
  EXPECT_GT(warmed, 1.0);
  EXPECT_LT(warmed, (kGas + 100.0) / kGas);
}

/// A thin zone of coarse grains, which a step of that flow heats by more than the gas has.
TEST(CrushedBed, FlowThatComesAndGoesNeverLeavesGasColderThanNothing) {
  const CrushedBed bed = bed_of(1e-2);
  const RockLayers::Step step = bed.step(3e-5);
  constexpr double kThin = 1.3e-3, kFlow = 4e6;  // [m3], [W/K]
  CrushedBed::State state;
  for (int n = 0; n < 400; ++n) {
    const double kept = bed.kept(state, kThin, kGas, step);
    ASSERT_GT(kept, 0.0) << n;
    ASSERT_LT(kept, 1.2) << n;
    const double flow = n % 2 == 0 ? kFlow : 0.0;
    bed.take(state, kThin, flow * kGas * (1.0 - kept) * step.length(), flow, step);
  }
}

TEST(CrushedBed, CoarseGrainsAndFastGasKeepMoreHeat) {
  const CrushedBed fine = bed_of(1e-3), coarse = bed_of(1e-2);
  EXPECT_LT(kept_of(fine, {.flow = 1e7}), kept_of(coarse, {.flow = 1e7}));
  EXPECT_LT(kept_of(fine, {.flow = 1e7}), kept_of(fine, {.flow = 1e9}));
}

TEST(CrushedBed, IsThereOnlyWithGrainsRockAndHeat) {
  EXPECT_EQ(kept_of(bed_of(0.0), {.flow = 1e6}), 1.0);
  EXPECT_EQ(kept_of(bed_of(kGrain), {.flow = 1e6}, 0.0), 1.0);
  const CrushedBed cold({.grain = kGrain, .heat_capacity = kCapacity, .rock = {.effusivity = 0.0}});
  EXPECT_EQ(kept_of(cold, {}), 1.0);
}

TEST(CrushedBed, RefusesWhatIsNoRock) {
  EXPECT_THROW(bed_of(-1.0), InputError);
  EXPECT_THROW(CrushedBed({.heat_capacity = 0.0, .rock = {}}), InputError);
}

}  // namespace
}  // namespace muckpile
