// SPDX-License-Identifier: GPL-2.0-or-later
// The shipped table of explosives, a user's own, and the JWL isentrope.
// Scope: core only.
#include <gtest/gtest.h>

#include "explosive/explosive_table.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

ExplosiveTable from(const std::string& text) {
  return ExplosiveTable(CsvTable::parse(text, "own.csv"));
}

JwlParameters tnt() { return *ExplosiveTable::shipped().find("tnt", "test").jwl; }

TEST(ExplosiveTable, ShipsTheFiveKindsWithTheirSources) {
  for (const char* name : {"anfo", "emulsion", "heavy_anfo", "gelatine", "tnt"}) {
    EXPECT_FALSE(ExplosiveTable::shipped().find(name, "test").source.empty()) << name;
  }
  const NamedExplosive& anfo = ExplosiveTable::shipped().find("anfo", "test");
  EXPECT_EQ(anfo.density, 800.0);
  EXPECT_EQ(anfo.detonation_velocity, 4000.0);
  EXPECT_FALSE(anfo.jwl.has_value());
}

TEST(ExplosiveTable, EnergyOfEachJwlSetIsThatOfItsOwnIsentrope) {
  // E0 is published beside the other constants: a mistyped digit of any of them shows here.
  int sets = 0;
  for (const NamedExplosive& explosive : ExplosiveTable::shipped().entries()) {
    if (!explosive.jwl) continue;
    ++sets;
    EXPECT_NEAR(JwlIsentrope(*explosive.jwl).implied_energy() / explosive.jwl->energy, 1.0, 3e-3)
        << explosive.name;
  }
  EXPECT_EQ(sets, 3);
}

TEST(ExplosiveTable, AnUnknownNameIsToldWithTheNearest) {
  EXPECT_EQ(input_error_of([] { (void)ExplosiveTable::shipped().find("emulsin", "here"); }),
            "here: unknown explosive 'emulsin'; did you mean 'emulsion'? (known: anfo, anfo_dense, "
            "heavy_anfo, emulsion, emulsion_dense, gelatine, tnt)");
}

TEST(ExplosiveTable, ReadsAUsersOwnRowWithoutJwl) {
  const ExplosiveTable own =
      from("name, density_kg_m3, vod_m_s, energy_J_kg\nmine, 1200, 5000, 3.1e6\n");
  EXPECT_EQ(own.find("mine", "test").energy, 3.1e6);
  EXPECT_FALSE(own.find("mine", "test").gamma.has_value());
}

TEST(ExplosiveTable, GasVolumeGivesTheGasConstantOfTheProducts) {
  // 11 mol x 8.314 J/(mol K) / 0.2542 kg = 359.8 J/(kg K)
  EXPECT_NEAR(gas_constant(ExplosiveTable::shipped().find("anfo", "test")), 359.8, 0.1);
  const ExplosiveTable own = from(
      "name,density_kg_m3,vod_m_s,energy_J_kg,gas_volume_m3_kg\nmine,1200,5000,3.1e6,0.8\n"
      "other,1200,5000,3.1e6,\n");
  EXPECT_EQ(own.find("mine", "test").gas_volume, 0.8);
  EXPECT_EQ(own.find("other", "test").gas_volume, kUsualGasVolume);
  EXPECT_EQ(input_error_of([] {
              (void)from(
                  "name,density_kg_m3,vod_m_s,energy_J_kg,gas_volume_m3_kg\n"
                  "mine,1200,5000,3.1e6,900\n");
            }),
            "own.csv:2: gas_volume_m3_kg must be >= 0.1 and <= 2, got '900'");
}

TEST(ExplosiveTable, EachFaultNamesFileLineAndColumn) {
  const std::string head = "name,density_kg_m3,vod_m_s,energy_J_kg";
  const auto fault = [](const std::string& text) {
    return input_error_of([&] { (void)from(text); });
  };
  EXPECT_EQ(fault(head + "\na,0,5000,3e6\n"),
            "own.csv:2: density_kg_m3 must be >= 10 and <= 10000, got '0'");
  EXPECT_EQ(fault(head + "\na,1000,,3e6\n"),
            "own.csv:2: vod_m_s must be >= 100 and <= 1e+05, got ''");
  EXPECT_EQ(fault(head + "\na,1000,5000,3e6\na,1000,5000,3e6\n"),
            "own.csv:3: explosive 'a' is given twice");
  EXPECT_EQ(fault("name,density_kg_m3\na,1000\n"), "own.csv: has no column 'vod_m_s'");
  EXPECT_EQ(fault(head + ",gama\na,1000,5000,3e6,2\n")
                .find("own.csv: unknown column 'gama'; did you mean 'gamma'? (known: name, "
                      "density_kg_m3, "),
            0U);
  EXPECT_NE(fault(head + ",jwl_a_Pa\na,1000,5000,3e6,2\n").find("own.csv:2: needs all of jwl_a_Pa"),
            std::string::npos);
}

TEST(JwlIsentrope, PassesTheChapmanJouguetPointOfTnt) {
  const JwlIsentrope jwl(tnt());
  // V_CJ = 1 - 21/(1.63 x 6.93^2) = 1 - 21/78.28059 = 0.731734
  EXPECT_NEAR(jwl.cj_volume(), 0.731734, 1e-6);
  // C published with this set: 1.045 GPa; the difference is the rounding of P_CJ and E0
  EXPECT_NEAR(jwl.gas_coefficient(), 1.045e9, 0.003e9);
}

TEST(JwlIsentrope, MatchesTheTntTableAtVolumeRatioTwo) {
  // 371.2 e^-8.3 + 3.231 e^-1.9 + 1.04785 / 2^1.3 = 0.0922496 + 0.483257 + 0.425561 GPa
  EXPECT_NEAR(JwlIsentrope(tnt()).pressure(2.0), 1.00107e9, 1e5);
}

TEST(JwlIsentrope, VolumeRatioAtUndoesPressure) {
  const JwlIsentrope jwl(tnt());
  for (const double v : {1.5, 2.41, 6.0}) {
    EXPECT_NEAR(jwl.volume_ratio_at(jwl.pressure(v)), v, 1e-12 * v);
  }
  EXPECT_EQ(jwl.volume_ratio_at(1e12), 1.0);
}

TEST(JwlIsentrope, RefusesAPointThatNoIsentropePasses) {
  JwlParameters p = tnt();
  p.cj_pressure = 80e9;  // above rho D^2
  EXPECT_THROW(JwlIsentrope{p}, InputError);
  p = tnt();
  p.cj_pressure = 5e9;  // below the A and B terms
  EXPECT_THROW(JwlIsentrope{p}, InputError);
  p = tnt();
  p.omega = 0.0;
  EXPECT_THROW(JwlIsentrope{p}, InputError);
}

}  // namespace
}  // namespace muckpile
