// SPDX-License-Identifier: GPL-2.0-or-later
// Venting by flow: choked flux, stemming as a plug, mass that leaves.
// Scope: closed forms of one chamber.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "args/input_error.h"
#include "explosive/blast_load.h"

namespace muckpile {
namespace {

GasVent::Parameters vent() {
  GasVent::Parameters p;
  p.hole_radius = 0.045;
  p.zone_radius = 0.135;
  p.products_mass = 60.0;
  p.stemming_length = 3.0;
  p.crack_delay = 3e-3;
  return p;
}

/// A chamber of constant volume, ideal gas of exponent 1.4, after that many steps [s].
GasState emptied(const GasVent& gas, double p0, double rho0, int steps, double step) {
  GasState state;
  for (int i = 0; i < steps; ++i) {
    const double left = state.mass_left;
    gas.advance(state, {p0 * std::pow(left, 1.4), rho0 * left, 0.0, i * step}, step);
  }
  return state;
}

TEST(GasVent, ChokedFluxIsThatOfAnIdealGas) {
  // air at 1 bar, 1.2 kg/m3: sqrt(1.4 x 1e5 x 1.2) (2/2.4)^3 = 409.878 x 0.578704 = 237.198
  EXPECT_NEAR(choked_flux(1e5, 1.2, 1.4), 237.198, 1e-3);
}

TEST(GasVent, StemmingIsAPlugUnderConstantPressure) {
  // path = p t^2 / (2 rho T): 2e7/(1800 x 3) = 3703.7 m/s2, 3 m after sqrt(2 x 3/3703.7) = 40.25 ms
  const GasVent gas(vent());
  GasState state;
  double time = 0.0;
  constexpr double kStep = 1e-6;
  while (state.stemming_path < 3.0) {
    gas.advance(state, {2e7, 100.0, 0.0, time}, kStep);
    time += kStep;
  }
  EXPECT_NEAR(time, 40.249e-3, 2e-6);  // one step
  EXPECT_NEAR(state.stemming_out, time, 1e-12);
  EXPECT_NEAR(gas.cleared_room(state), 3.0 * std::numbers::pi * 0.045 * 0.045, 1e-12);
  EXPECT_EQ(state.mass_left, 1.0);  // closed until now, and the cracks have no width
}

TEST(GasVent, ShearOnTheWallHoldsAPlugThatIsLongEnough) {
  GasVent::Parameters p = vent();
  p.stemming_shear = 2e5;  // holds 2 x 2e5 x 3/0.045 = 26.7 MPa
  const GasVent gas(p);
  GasState state;
  gas.advance(state, {26e6, 100.0, 0.0, 0.0}, 1e-3);
  EXPECT_EQ(state.stemming_path, 0.0);
  gas.advance(state, {28e6, 100.0, 0.0, 0.0}, 1e-3);
  EXPECT_GT(state.stemming_path, 0.0);
}

TEST(GasVent, CollarOpensWhenTheStemmingIsOutAndCracksWithTheirDelay) {
  const GasVent gas(vent());
  const double bore = 0.8 * std::numbers::pi * 0.045 * 0.045;
  const double cracks = 0.05 * 0.027 / 0.135;  // 0.027 m3 swept: 0.2 m2 of cracks
  GasState out;
  out.stemming_path = 3.0;
  EXPECT_EQ(gas.open_area({}, {1e8, 100.0, 0.027, 1e-3}), 0.0);
  EXPECT_DOUBLE_EQ(gas.open_area(out, {1e8, 100.0, 0.027, 1e-3}), bore);
  EXPECT_DOUBLE_EQ(gas.open_area(out, {1e8, 100.0, 0.027, 4e-3}), bore + cracks);
  EXPECT_DOUBLE_EQ(gas.open_area(out, {1e8, 100.0, -0.01, 4e-3}), bore);
}

TEST(GasVent, AChamberOfConstantVolumeEmptiesAsTheClosedFormSays) {
  // p ~ m^1.4 and rho ~ m, so dm/dt = -k m^1.2 and m = (1 + 0.2 k t)^-5, k = A flux(p0, rho0)/mass
  GasVent::Parameters p = vent();
  p.stemming_length = 0.0;
  const GasVent gas(p);
  const double p0 = 2e8, rho0 = 400.0;
  const double k = 0.8 * std::numbers::pi * 0.045 * 0.045 * choked_flux(p0, rho0, 1.4) / 60.0;
  const GasState state = emptied(gas, p0, rho0, 3000, 1e-5);
  const double expected = std::pow(1.0 + 0.2 * k * 0.03, -5.0);
  ASSERT_LT(expected, 0.7);
  EXPECT_NEAR(state.mass_left, expected, 1e-3 * expected);  // first order in the step
}

TEST(GasVent, GasLeaksThroughThePoresOfAPlugThatHolds) {
  // As above, but the discharge of the leak in place of the collar's. By hand: e = 1 - 1800/2650 =
  // 0.32075, e^3 d/(3.5 (1 - e) L) = 0.033000 * 0.01/(3.5 * 0.67925 * 1.8) = 7.7115e-5, its root
  // 8.78165e-3; choked 1.4^(1/2) (2/2.4)^3 = 0.684731: together 0.01282495.
  GasVent::Parameters p = vent();
  p.stemming_length = 1.8;
  p.stemming_density = 1800.0;
  p.stemming_grain = 0.01;
  p.stemming_shear = 1e9;  // holds
  const GasVent gas(p);
  const double p0 = 2e8, rho0 = 400.0;
  const double bore = std::numbers::pi * 0.045 * 0.045;
  const double leak = 0.01282495;
  EXPECT_NEAR(gas.open_area({}, {p0, rho0, 0.0, 0.0}), leak * bore, 1e-5 * leak * bore);
  const double k = leak * bore * choked_flux(p0, rho0, 1.4) / 60.0;
  const GasState state = emptied(gas, p0, rho0, 10000, 1e-4);
  const double expected = std::pow(1.0 + 0.2 * k * 1.0, -5.0);
  ASSERT_LT(expected, 0.9);
  EXPECT_NEAR(state.mass_left, expected, 1e-3 * expected);
  EXPECT_EQ(state.stemming_path, 0.0);
}

TEST(GasVent, AShortPlugLeaksNoMoreThanTheOpenCollar) {
  GasVent::Parameters p = vent();
  p.stemming_grain = 0.05;
  p.stemming_length = 1e-4;
  EXPECT_DOUBLE_EQ(GasVent(p).open_area({}, {2e8, 400.0, 0.0, 0.0}),
                   p.collar_discharge * std::numbers::pi * p.hole_radius * p.hole_radius);
  p.stemming_density = 2700.0;
  EXPECT_THROW(GasVent{p}, InputError);
}

TEST(GasVent, GasThatIsLeftFillsTheChamberAlone) {
  BlastLoad::Parameters parameters{
      .wave_peak = 0.0,
      .expansion = ProductExpansion(TwoStageIsentrope({.initial_pressure = 2.784375e9})),
      .charge_volume = 0.01,
      .vent_time = 0.0,
      .vent_decay = 1.0,
      .flow = vent()};
  const BlastLoad load(parameters);
  GasState half;
  half.mass_left = 0.5;
  EXPECT_NEAR(load.gas_pressure(0.0, 1.0, {}), 200e6, 1.0);  // no time law
  EXPECT_NEAR(load.gas_pressure(0.0, 1.0, half), 200e6 / std::pow(2.0, 1.4), 1.0);
}

TEST(GasVent, WhatTheStemmingGetsTheGasHasLost) {
  // A tight chamber of constant volume: all that its gas loses is the motion of the plug, 1800
  // kg/m3 x 3 m x area x v^2/2, as nothing else takes work from it. The plug's speed is that of the
  // explicit step.
  const BlastLoad load(
      {.wave_peak = 0.0,
       .expansion = ProductExpansion(TwoStageIsentrope({.initial_pressure = 2.784375e9})),
       .charge_volume = 0.01,
       .vent_time = 0.0,
       .vent_decay = 1.0,
       .flow = vent()});
  GasState state;
  const double full = load.gas_energy(0.0, 0.0, state);
  double time = 0.0;
  constexpr double kStep = 1e-6;
  while (state.stemming_out < 0.0) load.advance(state, 0.0, time += kStep, kStep);
  const double area = std::numbers::pi * 0.045 * 0.045, speed = state.stemming_speed;
  const double motion = 0.5 * 1800.0 * 3.0 * area * speed * speed;
  ASSERT_GT(motion, 0.05 * full);
  EXPECT_NEAR(state.stemming_work / motion, 1.0, 1e-3);  // first order in the step
  EXPECT_NEAR((full - load.gas_energy(0.0, time, state)) / state.stemming_work, 1.0, 1e-9);
  EXPECT_EQ(state.mass_left, 1.0);
  // Afterwards it takes nothing more.
  const double work = state.stemming_work;
  load.advance(state, 0.0, time, kStep);
  EXPECT_EQ(state.stemming_work, work);
  EXPECT_LT(state.mass_left, 1.0);
}

TEST(GasVent, RefusesValuesOutOfRange) {
  const auto refused = [](auto change) {
    GasVent::Parameters p = vent();
    change(p);
    EXPECT_THROW(GasVent{p}, InputError);
  };
  refused([](auto& p) { p.hole_radius = 0.0; });
  refused([](auto& p) { p.products_mass = 0.0; });
  refused([](auto& p) { p.gamma = 1.0; });
  refused([](auto& p) { p.stemming_length = -1.0; });
  refused([](auto& p) { p.stemming_density = 0.0; });
  refused([](auto& p) { p.crack_delay = -1.0; });
}

}  // namespace
}  // namespace muckpile
