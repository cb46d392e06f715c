// SPDX-License-Identifier: GPL-2.0-or-later
// The audit of a hole's energy: a piston driven by the load through pulse and gas stage.
// Scope: one hole, a rigid piston for its wall; no engine.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>

#include "explosive/energy_audit.h"

namespace muckpile {
namespace {

constexpr double kVolume = 0.05, kMass = 55.0, kEnergy = 1.65e8;  // of the charge [m3], [kg], [J]
constexpr double kAmbient = 1e5;                                  // [Pa]

BlastLoad load_of(double wave_peak) {
  const TwoStageIsentrope::Parameters shape{.initial_pressure = 2.784e9};
  TwoStageIsentrope::Parameters products = shape;
  products.switch_pressure = energy_switch_pressure(shape, kEnergy / kVolume);
  GasVent::Parameters flow{.hole_radius = 0.045, .zone_radius = 0.135, .products_mass = kMass};
  flow.collar_discharge = 0.05;
  return BlastLoad({.wave_peak = wave_peak,
                    .pulse = {.rise_time = 1e-4},
                    .expansion = ProductExpansion(TwoStageIsentrope(products)),
                    .charge_volume = kVolume,
                    .products_mass = kMass,
                    .vent_time = 0.0,
                    .vent_decay = 1.0,
                    .flow = flow});
}

/// A wall of 5 m2 and 100 t that the load drives against the atmosphere for 20 ms.
EnergyAudit driven(const BlastLoad& load) {
  constexpr double kArea = 5.0, kWallMass = 1e5, kStep = 2e-6;
  GasState gas;
  HoleBooks books;
  double path = 0.0, speed = 0.0, time = 0.0;
  for (; time < 0.02; time += kStep) {
    const double swept = kArea * path;
    const double inside = load.gas_pressure(swept, time, gas);
    const double pressed =
        load.pressure(time, inside - kAmbient, load.pulse_limit(swept, time, gas) - kAmbient);
    const double before = speed;
    speed += pressed * kArea / kWallMass * kStep;
    const double way = 0.5 * (before + speed) * kStep;
    path += way;
    books.wall_work += pressed * kArea * way;
    const double after = load.gas_pressure(kArea * path, time, gas);
    books.expansion += 0.5 * (inside + after) * kArea * way;
    books.air_volume += kArea * way;
    load.advance(gas, kArea * path, time, kStep);
  }
  EXPECT_NEAR(books.wall_work / (0.5 * kWallMass * speed * speed), 1.0, 1e-6);
  return audit_of_hole(load, kEnergy, load.gas_energy(kArea * path, time, gas), gas, books,
                       kAmbient);
}

TEST(EnergyAudit, ClosesForAWallThatTheChargeDrives) {
  const EnergyAudit audit = driven(load_of(227e6));
  std::cout << "audit off by " << audit.error() / kEnergy << " of the explosive's energy\n";
  EXPECT_NEAR(audit.error() / kEnergy, 0.0, 1e-4);
  EXPECT_NEAR(audit.not_released / kEnergy, 0.0, 1e-9);
  EXPECT_GT(audit.wall_work, 0.02 * kEnergy);
  EXPECT_GT(audit.vented, 0.02 * kEnergy);
  EXPECT_GT(audit.crushing, 0.1 * kEnergy);
}

TEST(EnergyAudit, GasThatLeavesAndComesBackKeepsTheEnergy) {
  const BlastLoad load = load_of(227e6);
  GasState gas;
  const double full = load.gas_energy(0.01, 1e-3, gas);
  const double mass = 0.3 * kMass, energy = mass * load.gas_enthalpy(0.01, 1e-3, gas);
  load.take_gas(gas, 0.01, 1e-3, 0.3, energy);
  EXPECT_NEAR((load.gas_energy(0.01, 1e-3, gas) + energy) / full, 1.0, 1e-14);
  EXPECT_LT(gas.hotter, 1.0);  // enthalpy of the start, for all of it
  const double cold = load.gas_pressure(0.01, 1e-3, gas);
  load.take_gas(gas, 0.01, 1e-3, -0.1, -0.5 * energy);  // hot gas: half the energy, a third of it
  EXPECT_NEAR((load.gas_energy(0.01, 1e-3, gas) + 0.5 * energy) / full, 1.0, 1e-14);
  EXPECT_GT(load.gas_pressure(0.01, 1e-3, gas), cold);
  EXPECT_NEAR(gas.mass_left, 0.8, 1e-14);
}

TEST(EnergyAudit, PulseBeyondTheDenseStageIsAnError) {
  HoleBooks books;
  const BlastLoad load = load_of(227e6);
  books.wall_work = load.start_energies().dense + 1e7;
  const EnergyAudit audit =
      audit_of_hole(load, kEnergy, load.gas_energy(0.0, 0.0), {}, books, kAmbient);
  EXPECT_EQ(audit.crushing, 0.0);
  EXPECT_NEAR(audit.error() / -1e7, 1.0, 1e-9);
}

TEST(EnergyAudit, UnknownEnergyIsThatOfTheProducts) {
  const BlastLoad load = load_of(227e6);
  const EnergyAudit audit = audit_of_hole(load, 0.0, load.gas_energy(0.0, 0.0), {}, {}, kAmbient);
  EXPECT_NEAR(audit.explosive / kEnergy, 1.0, 1e-9);
  EXPECT_NEAR(audit.error() / kEnergy, 0.0, 1e-9);
}

TEST(EnergyAudit, SumsHolesTermByTerm) {
  EnergyAudit sum;
  const EnergyAudit one = driven(load_of(227e6));
  sum += one;
  sum += one;
  for (const EnergyAudit::Term& term : EnergyAudit::kTerms)
    EXPECT_DOUBLE_EQ(sum.*term.value, 2.0 * (one.*term.value)) << term.name;
}

TEST(EnergyAudit, WarnsOfMoreThanAHundredth) {
  EnergyAudit audit;
  EXPECT_EQ(warning_of_missing(audit), "");  // no charge has fired
  audit.explosive = 1000.0;
  audit.wall_work = 100.0;
  audit.joint_work = -20.0;
  audit.rock_heat = 910.5;  // 9.5 are missing
  EXPECT_EQ(warning_of_missing(audit), "");
  for (const double sign : {1.0, -1.0}) {
    audit.rock_heat = 920.0 - sign * 15.0;
    const std::string told = warning_of_missing(audit);
    EXPECT_EQ(told.find("the audit of the explosive's energy misses " +
                        std::string(sign > 0.0 ? "1.5" : "-1.5") +
                        " % of it and should close to 1 %; wave and gas have done work of 8 %"),
              0U)
        << told;
  }
}

}  // namespace
}  // namespace muckpile
