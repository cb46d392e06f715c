// SPDX-License-Identifier: GPL-2.0-or-later
// Explosive density, detonation velocity and coupling of each row of a hole table.
// Scope: pressures on the wall and masses of charges; core only.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "explosive/borehole_pressure.h"
#include "explosive/charge_design.h"
#include "explosive/hole_loads.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

class DeckCharge : public ::testing::Test {
 protected:
  DeckCharge() {
    const std::string hole = ",-3,0,10,-3,0,0,0.1,2,10,";
    file_ = testing::write_text(
        folder_.path() / "p.csv",
        "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,"
        "explosive,explosive_density_kg_m3,vod_m_s,coupling,charge_diameter_m\n"
        "dry" +
            hole + ",,,,\nheavy" + hole + ",1150,4800,,\nnamed" + hole +
            "emulsion,1200,,,\n"
            "air" +
            hole + ",,,air,0.08\nwater" + hole + ",,,water,0.08\nsand" + hole +
            ",,,stemming,0.08\n");
    options_ = blast_options(parse_args(blast_table(), "fix",
                                        {"explosive", "anfo", "hole_table", file_, "poisson_ratio",
                                         "0.25", "vent_time", "0.01", "vent_decay", "0.01"}),
                             "fix");
    zones_ = HoleTable::read(file_).crushed_zones(3.0);
  }
  [[nodiscard]] LoadedHole hole(std::size_t k) const { return loaded_hole(options_, zones_[k], k); }

  testing::TemporaryFolder folder_;
  std::string file_;
  BlastOptions options_;
  std::vector<Hole> zones_;
};

TEST_F(DeckCharge, DensityAndVodOfARowMakeItsBoreholePressure) {
  EXPECT_EQ(hole(0).explosive.density, 800.0);
  EXPECT_EQ(hole(1).explosive.density, 1150.0);
  EXPECT_EQ(hole(1).initial_pressure, explosion_state_pressure({1150.0, 4800.0}));
  EXPECT_GT(hole(1).initial_pressure, 1.3 * hole(0).initial_pressure);
  const NamedExplosive emulsion = ExplosiveTable::shipped().find("emulsion", "");
  EXPECT_EQ(hole(2).explosive.density, 1200.0);
  EXPECT_EQ(hole(2).explosive.energy, emulsion.energy);
  EXPECT_EQ(hole(2).explosive.detonation_velocity, emulsion.detonation_velocity);
}

TEST_F(DeckCharge, WaterAndStemmingCarryThePeakAndKeepTheGap) {
  // charges of 0.08 m in holes of 0.1 m
  const double p0 = hole(0).initial_pressure;
  EXPECT_EQ(hole(0).wall_pressure, p0);
  EXPECT_NEAR(hole(4).wall_pressure / (p0 * std::pow(0.8, 0.72)), 1.0, 1e-12);
  // crushed rock around it: the exponent of the shock in rock
  EXPECT_NEAR(hole(5).wall_pressure / (p0 * std::pow(0.8, hole(5).exponent)), 1.0, 1e-12);
  EXPECT_LT(hole(3).wall_pressure, hole(4).wall_pressure);
  EXPECT_EQ(free_volume_ratio(hole(4).shape, hole(4).decoupling), 1.0);
  EXPECT_NEAR(free_volume_ratio(hole(3).shape, hole(3).decoupling), 1.5625, 1e-12);
}

TEST_F(DeckCharge, TheLogTellsThoseThatDiffer) {
  const std::string text = describe(options_, zones_, hole_blasts(options_, zones_));
  EXPECT_NE(text.find("  hole 2 ('heavy'): anfo, 1150 kg/m3, 4800 m/s, P0 = "), std::string::npos)
      << text;
  EXPECT_NE(text.find("  hole 4 ('air'): anfo, 800 kg/m3, "), std::string::npos) << text;
  EXPECT_EQ(text.find("hole 5"), std::string::npos) << text;  // three lines, and how many more
  EXPECT_NE(text.find("  and 2 more charges that differ from that of hole 1"), std::string::npos)
      << text;
}

TEST_F(DeckCharge, MassesFollowInTheLoadAndInTheDesign) {
  const double area = std::numbers::pi * 0.0025, thin = 0.64 * area;
  const std::vector<HoleCharge> charges = hole_charges(options_, zones_);
  EXPECT_NEAR(charges[1].mass, area * 8.0 * 1150.0, 1e-9);
  EXPECT_NEAR(charges[2].mass, area * 8.0 * 1200.0, 1e-9);
  const ChargeDesign design =
      charge_design(parse_args(charge_design_table(), "charge_design",
                               {"explosive", "anfo", "crushed_ratio", "3", "hole_table", file_}),
                    "charge_design");
  EXPECT_NEAR(design.pattern_mass,
              area * 8.0 * (800.0 + 1150.0 + 1200.0) + 3.0 * thin * 8.0 * 800.0, 1e-9);
}

}  // namespace
}  // namespace muckpile
