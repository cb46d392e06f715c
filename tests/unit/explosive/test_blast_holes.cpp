// SPDX-License-Identifier: GPL-2.0-or-later
// The charged holes of a blast: firing, books, gas that is moved, end, and going on from a state.
// Scope: walls are rigid pistons that the test moves; no engine.
#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "explosive/blast_holes.h"

namespace muckpile {
namespace {

const std::string kWhere = "fix muckpile/blast 'b'";
constexpr double kDelay = 0.02;  // of the second hole [s]
const std::vector<Hole> kZones = {{.toe = {0, 0, 0}, .collar = {0, 0, 9}, .radius = 0.135},
                                  {.toe = {0, 4, 0}, .collar = {0, 4, 9}, .radius = 0.135}};

BlastHoles two_holes(BlastHoles::State state = {}, const std::vector<Hole>& zones = kZones,
                     const std::string& more = "") {
  std::istringstream text(
      "explosive anfo hole_diameter 0.09 poisson_ratio 0.22 venting flow stemming_length 3 "
      "crack_delay 1 crack_discharge 0 interval 0.02 " +
      more);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  const BlastOptions options = blast_options(parse_args(blast_table(), kWhere, words), kWhere);
  BlastHoles holes;
  holes.resume(std::move(state));
  holes.set(hole_blasts(options, zones), hole_charges(options, zones));
  return holes;
}

/// Both walls are at that volume since the last step, with no work of their own [m3].
void sweep(BlastHoles& holes, double first, double second, double time) {
  const std::array swept = {first, second}, work = {0.0, 0.0};
  holes.book_walls(swept, work, time);
}

TEST(BlastHoles, EachPressesFromItsFiringTimeOn) {
  BlastHoles holes = two_holes();
  EXPECT_FALSE(holes.any_fired(-1e-6));
  EXPECT_TRUE(holes.any_fired(0.0));
  EXPECT_EQ(holes.active(0.01), 1);
  EXPECT_EQ(holes.active(kDelay), 2);
  holes.press(0.01);
  EXPECT_GT(holes.gas_pressure(0), 1e8);
  EXPECT_EQ(holes.gas_pressure(1), 0.0);
  EXPECT_EQ(holes.audit(1, 0.01).explosive, 0.0);
  // pi 0.045^2 x 9 m x 800 kg/m3 x 3.8 MJ/kg
  EXPECT_NEAR(holes.audit(0, 0.01).explosive, 174.06e6, 0.01e6);
  EXPECT_NEAR(holes.explosive_energy(), 348.11e6, 0.02e6);
}

// What does not react makes no gas: half of an explosive that detonates does what one of half the
// density does.
TEST(BlastHoles, AShareThatReactsIsAsMuchLessExplosive) {
  BlastHoles half = two_holes({}, kZones, "energy_share 0.5"),
             light = two_holes({}, kZones, "explosive_density 400"), whole = two_holes();
  for (BlastHoles* holes : {&half, &light, &whole}) {
    sweep(*holes, 0.02, 0.0, 0.005);
    holes->press(0.005);
  }
  EXPECT_NEAR(half.explosive_energy() / light.explosive_energy(), 1.0, 1e-12);
  EXPECT_NEAR(half.gas_pressure(0) / light.gas_pressure(0), 1.0, 1e-9);
  const BlastHoles::Gas gas = half.gas(0, 0.005), as_light = light.gas(0, 0.005);
  EXPECT_NEAR(gas.mass / as_light.mass, 1.0, 1e-9);
  EXPECT_NEAR(gas.density / as_light.density, 1.0, 1e-9);
  EXPECT_NEAR(gas.enthalpy / as_light.enthalpy, 1.0, 1e-9);
  EXPECT_NEAR(gas.mass / whole.gas(0, 0.005).mass, 0.5, 1e-9);
  EXPECT_EQ(half.explosive_mass(), whole.explosive_mass());
}

TEST(BlastHoles, OneOnSymmetryPlanesHasItsShareOfEveryEnergy) {
  std::vector<Hole> zones = kZones;
  zones[0].share = 0.25;
  BlastHoles part = two_holes({}, zones), whole = two_holes();
  for (BlastHoles* holes : {&part, &whole}) {
    const double share = holes == &part ? 0.25 : 1.0;
    holes->press(0.01);
    sweep(*holes, 0.01 * share, 0.0, 0.01);
  }
  EXPECT_NEAR(part.gas_pressure(0) / whole.gas_pressure(0), 1.0, 1e-12);
  const HoleAudit quarter = part.hole_audit(0, 0.01), all = whole.hole_audit(0, 0.01);
  EXPECT_NEAR(quarter.energy.explosive, 0.25 * 174.06e6, 0.01e6);
  for (const EnergyAudit::Term& term : EnergyAudit::kTerms)
    EXPECT_NEAR(quarter.energy.*term.value, 0.25 * (all.energy.*term.value),
                1e-9 * all.energy.explosive)
        << term.name;
  EXPECT_NEAR(quarter.error(), 0.25 * all.error(), 1e-9 * all.energy.explosive);
}

TEST(BlastHoles, TheGasPressesByItsExcessOverTheAtmosphere) {
  BlastHoles holes = two_holes();
  holes.press(0.01);
  const double alone = holes.gas_pressure(0);
  holes.press_against(1e5);
  holes.press(0.01);
  EXPECT_NEAR(alone - holes.gas_pressure(0), 1e5, 1e-3);
}

TEST(BlastHoles, BooksWhatTheWallSweepsOfFiredHolesOnly) {
  BlastHoles holes = two_holes();
  holes.press(0.01);
  sweep(holes, 0.01, 0.003, 0.01);
  EXPECT_DOUBLE_EQ(holes.state().books[0].air_volume, 0.01);
  EXPECT_EQ(holes.state().books[1].air_volume, 0.0);
  EXPECT_DOUBLE_EQ(holes.swept_volume(), 0.013);
  // The trapezium of the pressures before and after.
  const HoleBlast& blast = holes.blast(0);
  const double mean = 0.5 * (blast.gas_pressure(0.0, 0.01) + blast.gas_pressure(0.01, 0.01));
  EXPECT_NEAR(holes.state().books[0].expansion / (mean * 0.01), 1.0, 1e-12);
}

TEST(BlastHoles, GasThatIsTakenIsBookedAndMissing) {
  BlastHoles holes = two_holes();
  const BlastHoles::Gas before = holes.gas(0, 0.01);
  // pi 0.045^2 x 9 m x 800 kg/m3
  EXPECT_NEAR(before.mass, 45.804, 0.001);
  const double mass = 0.25 * before.mass, energy = mass * before.enthalpy;
  const double inside = holes.audit(0, 0.01).in_holes;
  holes.take_gas(0, mass, energy, 0.01);
  EXPECT_NEAR(holes.gas(0, 0.01).mass / before.mass, 0.75, 1e-12);
  EXPECT_EQ(holes.state().books[0].into_joints, energy);
  EXPECT_NEAR((inside - holes.audit(0, 0.01).in_holes) / energy, 1.0, 1e-9);
}

TEST(BlastHoles, EachHoleAccountsForItsOwnCharge) {
  BlastHoles holes = two_holes();
  std::array<double, 2> swept{};
  for (double time = 0.0; time < 0.06; time += 1e-5) {
    holes.press(time);
    std::array<double, 2> work{};
    for (std::size_t h = 0; h < 2; ++h) {
      // A wall that gives way at a steady pace takes what presses on it.
      const double more = time >= holes.blast(h).firing_time() ? 2e-5 : 0.0;
      work[h] = holes.gas_pressure(h) * more;
      swept[h] += more;
    }
    holes.book_walls(swept, work, time);
    holes.advance(time, 1e-5);
    if (holes.active(time) == 2) holes.take_gas(1, 1e-3, 1e-3 * holes.gas(1, time).enthalpy, time);
  }
  for (std::size_t h = 0; h < 2; ++h) {
    const HoleAudit audit = holes.hole_audit(h, 0.06);
    EXPECT_NEAR(audit.error() / audit.energy.explosive, 0.0, 1e-3) << h;
    EXPECT_GT(audit.energy.stemming, 0.01 * audit.energy.explosive) << h;
    EXPECT_GT(audit.stemming_out, 5e-3) << h;
    EXPECT_GT(audit.stemming_speed, 10.0) << h;
    EXPECT_EQ(audit.energy.in_joints, 0.0) << h;
  }
  EXPECT_EQ(holes.hole_audit(0, 0.06).into_joints, 0.0);
  EXPECT_GT(holes.hole_audit(1, 0.06).into_joints, 0.0);
  EXPECT_EQ(two_holes().hole_audit(1, 0.01).stemming_out, GasState::kHolds);
}

TEST(BlastHoles, WhatIsLeftOfAnEndedHoleGoesIntoTheOpen) {
  BlastHoles holes = two_holes();
  const double inside = holes.audit(0, 0.01).in_holes;
  holes.release_gas(0.01);
  EXPECT_TRUE(holes.all_over());
  EXPECT_EQ(holes.active(0.03), 0);
  holes.press(0.03);
  EXPECT_EQ(holes.gas_pressure(0), 0.0);
  EXPECT_EQ(holes.on_wall(0, 0.0, 0.03).pressure, 0.0);
  EXPECT_EQ(holes.audit(0, 0.03).in_holes, 0.0);
  EXPECT_DOUBLE_EQ(holes.audit(0, 0.03).vented, inside);
}

TEST(BlastHoles, GoOnFromTheirState) {
  BlastHoles holes = two_holes();
  for (int step = 0; step < 200; ++step) {
    const double time = 1e-4 * step;
    holes.press(time);
    sweep(holes, 1e-4 * step, 0.0, time);
    holes.advance(time, 1e-4);
  }
  BlastHoles later = two_holes(holes.state());
  holes.press(kDelay);
  later.press(kDelay);
  EXPECT_EQ(later.gas_pressure(0), holes.gas_pressure(0));
  EXPECT_EQ(later.audit(0, kDelay).in_holes, holes.audit(0, kDelay).in_holes);
  EXPECT_LT(later.state().gas[0].mass_left, 1.0);  // past the stemming
}

}  // namespace
}  // namespace muckpile
