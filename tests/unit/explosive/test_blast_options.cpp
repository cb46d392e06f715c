// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/blast: what they build, and what each wrong one says.
// Scope: core only; the engine repeats the messages in tests/errors.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "explosive/hole_loads.h"
#include "input_error_of.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

const std::string kWhere = "fix muckpile/blast 'b'";
const std::string kCharge = "explosive_density 1100 vod 4500 hole_diameter 0.09 poisson_ratio 0.22";
const std::string kGas = " vent_time 9.9e-3 vent_decay 4.5e-3";
const Hole kZone{.toe = {0, 0, 0}, .collar = {0, 0, 9}, .radius = 0.135};

BlastOptions read(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return blast_options(parse_args(blast_table(), kWhere, words), kWhere);
}

/// P0 [Pa] with these words beside the charge's.
double p0(const std::string& words) {
  const BlastOptions options = read(kCharge + kGas + words);
  return initial_pressure(options.charge, options.charge.explosive);
}

std::string message(const std::string& text, const std::vector<Hole>& zones = {kZone, kZone}) {
  return input_error_of([&] { (void)hole_blasts(read(text), zones); });
}

TEST(BlastOptions, DefaultsBuildTheEmulsionOfTheDossier) {
  const std::vector<HoleBlast> blasts = hole_blasts(read(kCharge + kGas), {kZone});
  const BlastLoad& load = blasts.front().load();
  // P1 = 2784.375 x 3^-1.5 = 535.85 MPa
  EXPECT_NEAR(load.wave_peak(), 535.85e6, 0.01e6);
  // Vk = 13.921875^(1/3) pi 0.045^2 9 = 2.40565 x 0.0572555 = 0.137737 m3
  EXPECT_NEAR(load.start_volume(), 0.137737, 1e-6);
  EXPECT_NEAR(load.gas_pressure(0.0, 0.0), 200e6, 1.0);
  EXPECT_NEAR(load.gas_pressure(0.0, 9.9e-3 + 4.5e-3), 200e6 * std::exp(-1.0), 1.0);
  EXPECT_EQ(blasts.front().arrival_time({0, 0, 0}), 0.0);
  EXPECT_DOUBLE_EQ(blasts.front().arrival_time({0, 0, 9}), 0.002);
}

TEST(BlastOptions, ANamedExplosiveBringsItsNumbersAndTypedOnesBeatThem) {
  const std::string rest = " hole_diameter 0.09 poisson_ratio 0.22" + kGas;
  const BlastOptions anfo = read("explosive anfo" + rest);
  EXPECT_EQ(anfo.charge.explosive.density, 800.0);
  EXPECT_DOUBLE_EQ(initial_pressure(anfo.charge, anfo.charge.explosive), 1.6e9);  // 800 x 4000^2/8
  const BlastOptions dense = read("explosive anfo explosive_density 900" + rest);
  EXPECT_EQ(dense.charge.explosive.density, 900.0);
  EXPECT_EQ(dense.charge.explosive.detonation_velocity, 4000.0);
  // pi 0.045^2 9 x 900 x 3.8e6 = 0.0572555 x 900 x 3.8e6 = 195.814 MJ
  EXPECT_NEAR(hole_charges(dense, {kZone})[0].energy, 195.814e6, 1e3);
  EXPECT_EQ(hole_charges(read(kCharge + kGas), {kZone})[0].energy, 0.0);
}

TEST(BlastOptions, FormulasForP0AreRefusedOutsideTheirRange) {
  const std::string fast = "explosive_density 1100 vod 12000 hole_diameter 0.09 poisson_ratio 0.2";
  EXPECT_EQ(message(fast + kGas),
            kWhere +
                ": hole 1: vod must be from 1000 to 9500, the range of the formulas for P0, "
                "m/s, got '12000'");
  EXPECT_EQ(message(fast + " peak_pressure 1e8 gas no"), "");
  EXPECT_NE(
      message("explosive anfo energy_share 0.01 hole_diameter 0.09 poisson_ratio 0.2" + kGas)
          .find("also once energy_share 0.01 has slowed an explosive of the table, m/s, got '"),
      std::string::npos);
}

TEST(BlastOptions, ADecoupledChargeHasItsOwnWallPressureAndRoom) {
  const auto thin =
      hole_blasts(read(kCharge + kGas + " charge_diameter 0.06 decoupling isentrope"), {kZone});
  // kd = 1.5: 2784.375/1.5^6 = 244.44 MPa on the wall, x 3^-1.5 on r1
  EXPECT_NEAR(thin[0].load().wave_peak(), 244.444e6 * 0.1924501, 0.01e6);
  // V0 = pi 0.03^2 9, room 2.25 V0 < Vk = 2.40565 V0
  EXPECT_NEAR(thin[0].load().start_volume(), 2.40565 * 0.0254469, 1e-6);
  const auto deck = hole_blasts(read(kCharge + kGas + " charge_length 3"), {kZone});
  EXPECT_NEAR(deck[0].load().start_volume(), 0.0572555, 1e-6);  // 9 m of hole
  EXPECT_DOUBLE_EQ(deck[0].arrival_time({0, 0, 9}), 3.0 / 4500.0);
}

TEST(BlastOptions, APatternGivesEachHoleItsOwnChargeAndFiringTime) {
  const testing::TemporaryFolder folder;
  const std::string table = testing::write_text(
      folder.path() / "pattern.csv",
      "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,"
      "explosive,charge_diameter_m,surface_delay_s\n"
      "a,0,0,9,0,0,0,0.09,anfo,,0.000001\n"
      "b,3,0,9,3,0,0,0.1,,0.08,0.025\n");
  const std::string words = "explosive emulsion poisson_ratio 0.22" + kGas + " hole_table " + table;
  Hole second = kZone;
  second.toe.x() = second.collar.x() = 3.0;
  const BlastOptions options = read(words);
  const auto blasts = hole_blasts(options, {kZone, second});
  EXPECT_EQ(blasts[0].firing_time(), 1e-6);
  EXPECT_EQ(blasts[1].firing_time(), 0.025);
  EXPECT_NEAR(blasts[0].load().wave_peak(), 1600e6 * 0.1924501, 0.01e6);  // 3^-1.5
  const auto energies = hole_charges(options, {kZone, second});
  EXPECT_NEAR(energies[0].mass, 800 * M_PI * 0.045 * 0.045 * 9, 1e-9);
  EXPECT_NEAR(energies[1].energy, 3e6 * 1100 * M_PI * 0.04 * 0.04 * 9, 1e-3);
  EXPECT_EQ(message(words, {kZone}),
            kWhere +
                ": hole_table must have one row for each of the 1 holes of create_blocks, got "
                "2 rows");
  EXPECT_EQ(message(words, {kZone, kZone}),
            kWhere + ": row 2 of hole_table (hole 'b') is not where create_blocks has its hole 2");
  for (const char* word : {"hole_diameter 0.09", "interval 0.01", "hole 1 delay 0"}) {
    const std::string text(word);
    EXPECT_EQ(message(words + " " + text, {kZone, second}),
              kWhere + ": hole_table excludes " + text.substr(0, text.find(' ')));
  }
  EXPECT_EQ(message("explosive anfo poisson_ratio 0.2" + kGas),
            kWhere + ": needs hole_diameter [m] or hole_table");
}

TEST(BlastOptions, IntervalAndOwnDelaySetTheFiringTimes) {
  const std::vector<HoleBlast> blasts = hole_blasts(
      read(kCharge + kGas + " interval 0.025 hole 2 delay 0.04 primer top"), {kZone, kZone, kZone});
  EXPECT_EQ(blasts[0].firing_time(), 0.0);
  EXPECT_EQ(blasts[1].firing_time(), 0.04);
  EXPECT_EQ(blasts[2].firing_time(), 0.05);
  EXPECT_EQ(blasts[1].arrival_time({0, 0, 9}), 0.04);
}

TEST(BlastOptions, PressuresCanBeTyped) {
  EXPECT_EQ(p0(" borehole_pressure 1e9"), 1e9);
  const auto typed = hole_blasts(read(kCharge + kGas + " peak_pressure 1e6"), {kZone});
  EXPECT_EQ(typed.front().load().wave_peak(), 1e6);
  const auto flat = hole_blasts(read(kCharge + kGas + " attenuation_exponent 0"), {kZone});
  EXPECT_DOUBLE_EQ(flat.front().load().wave_peak(), 2.784375e9);
  const auto no_pulse = hole_blasts(read(kCharge + kGas + " pulse no"), {kZone});
  EXPECT_EQ(no_pulse.front().load().wave_peak(), 0.0);
}

TEST(BlastOptions, BoreholeModelsAreTheFormulasOfTheirNames) {
  EXPECT_DOUBLE_EQ(p0(" borehole_model chapman_jouguet"), 5.56875e9);
  EXPECT_DOUBLE_EQ(p0(" borehole_model impedance_matched rock_impedance 13.5e6"),
                   impedance_matched_pressure({1100.0, 4500.0}, 13.5e6));
  EXPECT_DOUBLE_EQ(p0(" borehole_model explosion_state_fit"),
                   explosion_state_pressure_fit({1100.0, 4500.0}));
}

TEST(BlastOptions, DescriptionNamesTheChoiceAndTheAlternatives) {
  const BlastOptions options = read(kCharge + kGas);
  const std::string text = describe(options, {kZone}, hole_blasts(options, {kZone}));
  for (const char* part :
       {"P0 = 2784 MPa", "Chapman-Jouguet 5569", "P1 = 535.9 MPa", "0.1377 m3"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
}

TEST(BlastOptions, SwitchPressureFollowsTheEnergy) {
  const auto start = [](const std::string& words) {
    const BlastOptions options = read(kCharge + kGas + words);
    return hole_blasts(options, {kZone}).front().load().gas_pressure(0.0, 0.0);
  };
  const std::string two_stages = " expansion two_stage explosive_energy 3e6";
  // Of the emulsion's 3.0 MJ/kg: 558.33 MPa (EnergySwitchPressure). Three quarters of it:
  // y = (0.888889 - 0.5)/2, p_k = 2784.375 y^1.5 = 238.74 MPa.
  EXPECT_NEAR(start(two_stages + " gas_switch_pressure energy"), 558.33e6, 0.05e6);
  EXPECT_NEAR(start(two_stages + " gas_switch_pressure energy energy_share 0.75"), 238.74e6,
              0.05e6);
  // It is the default, but an explosive without a known energy has 200 MPa.
  EXPECT_NEAR(start(two_stages), 558.33e6, 0.05e6);
  EXPECT_NEAR(start(""), 200e6, 1.0);
}

/// The products of an explosive whose energy is known expand by covolume and the wave falls by 1.5
/// unless other laws are asked for.
TEST(BlastOptions, LawsByDefaultAreThoseAskedForByName) {
  const auto load = [](const std::string& words) {
    const BlastOptions options = read(kCharge + kGas + words);
    const BlastLoad of_hole = hole_blasts(options, {kZone}).front().load();
    return std::pair(of_hole.wave_peak(), of_hole.gas_pressure(0.0, 0.0));
  };
  const std::string known = " explosive_energy 3e6";
  EXPECT_EQ(load(known), load(known + " expansion covolume attenuation_exponent 1.5"));
  EXPECT_EQ(load(""), load(" expansion two_stage attenuation exponent"));
  EXPECT_EQ(load(known + " gas_gamma_dense 3"), load(known + " expansion two_stage"));
  EXPECT_NE(load(known).second, load(known + " expansion two_stage").second);
  // 3^-2.282051 of a shock in rock of 0.22
  EXPECT_NEAR(load(" attenuation shock").first, 226.94e6, 0.01e6);
}

TEST(BlastOptions, GasStageOfCovolumeByTheShareSpent) {
  const auto start = [](const std::string& words) {
    const BlastOptions options =
        read(kCharge + kGas + " explosive_energy 3e6 expansion covolume" + words);
    return hole_blasts(options, {kZone}).front().load().gas_pressure(0.0, 0.0);
  };
  // That of the pulse on the wall of the crushed zone, 3^-1.5 P0: by default all of the gas'.
  EXPECT_NEAR(start(""), 2784.375e6 / std::sqrt(27.0), 1e3);
  EXPECT_NEAR(start(" dense_share 0.4"), 2784.375e6 * std::pow(0.6, 3.5), 1e3);
  EXPECT_NEAR(start(" gas_switch_pressure 2e8"), 200e6, 1e3);
}

/// What the gas presses through crushed rock of 35 degrees, (V/Vz)^0.3645 of it, has come down to
/// 535.5 MPa at 1.489, 2.056 and 1.422 V0 in a full hole, with air and with water around the
/// charge, once 0.247, 0.144 and 0.225 of 3300 MJ/m3 are spent.
TEST(BlastOptions, GasStageStartsWhereItPressesWhatTheWaveDoes) {
  const auto dense_share = [](const std::string& words, double ratio) {
    const BlastOptions options =
        read(kCharge + kGas + " explosive_energy 3e6 crushed_friction 35" + words);
    Hole zone = kZone;
    zone.radius = 0.045 * ratio;
    const std::vector<HoleBlast> blasts = hole_blasts(options, {zone});
    const BlastLoad& load = blasts.front().load();
    EXPECT_NEAR(load.wave_peak(), 535.5e6, 1e5);
    EXPECT_NEAR(load.gas_pressure(0.0, 0.0) * load.wall_share(0.0), load.wave_peak(), 1.0);
    const BlastLoad::StartEnergies at = load.start_energies();
    EXPECT_NEAR(at.filling, 0.0, 1e-9 * at.products);
    return at.dense / at.products;
  };
  EXPECT_NEAR(dense_share("", 3.0013), 0.247, 0.002);
  EXPECT_NEAR(dense_share(" charge_diameter 0.072", 1.7816), 0.144, 0.002);
  EXPECT_NEAR(dense_share(" charge_diameter 0.072 coupling water", 2.6966), 0.225, 0.002);
  // Where they fill more than the volume at which a full hole's gas would have come down to it.
  EXPECT_NEAR(dense_share(" charge_diameter 0.063", 1.3834), 0.085, 0.002);
  EXPECT_NEAR(dense_share(" charge_diameter 0.054", 1.0621), 0.017, 0.002);
  EXPECT_NEAR(dense_share(" charge_length 6.3", 1.9537), 0.164, 0.002);
}

/// Where nothing is crushed nothing is spent on it.
TEST(BlastOptions, TheGasStageNeedsTheFallOfThePeakWithoutAPulseToo) {
  const std::string gas = kCharge + kGas + " explosive_energy 3e6 pulse no";
  EXPECT_NO_THROW((void)read(gas));
  try {
    (void)read("explosive emulsion hole_diameter 0.09 attenuation liu_katsabanis pulse no" + kGas);
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("needs rock_p_wave_speed"), std::string::npos)
        << error.what();
  }
}

TEST(BlastOptions, WithoutCrushedRockTheGasStageStartsAtOnce) {
  const BlastOptions options = read(kCharge + kGas + " explosive_energy 3e6 crushed_friction 35");
  Hole zone = kZone;
  zone.radius = 0.045;
  const auto at = hole_blasts(options, {zone}).front().load().start_energies();
  EXPECT_NEAR(at.dense, 0.0, 1e-9 * at.products);
}

TEST(BlastOptions, GasStageOfJwlStaysWithinItsFit) {
  // JWL of tnt has spent 0.686 of its energy at 7 V0.
  const std::string tnt =
      "explosive tnt hole_diameter 0.09 poisson_ratio 0.22 expansion jwl" + kGas;
  EXPECT_NO_THROW((void)hole_blasts(read(tnt + " dense_share 0.68"), {kZone}));
  try {
    (void)hole_blasts(read(tnt + " dense_share 0.7"), {kZone});
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("dense_share must be at most 0.685977, what is spent at 7 V0 to which JWL "
                        "is fitted, got"),
              std::string::npos)
        << error.what();
  }
}

TEST(BlastOptions, AShareOfTheEnergyDetonatesMoreSlowly) {
  const std::string rest = " hole_diameter 0.09 poisson_ratio 0.22" + kGas;
  for (const char* name : {"anfo", "heavy_anfo", "emulsion", "gelatine", "tnt"}) {
    const BlastOptions whole = read("explosive " + std::string(name) + rest);
    const BlastOptions half = read("explosive " + std::string(name) + " energy_share 0.5" + rest);
    const NamedExplosive &a = whole.charge.explosive, &b = half.charge.explosive;
    EXPECT_DOUBLE_EQ(b.energy, 0.5 * a.energy);
    EXPECT_NEAR(b.detonation_velocity, std::sqrt(0.5) * a.detonation_velocity, 1e-9);
    const ProductExpansion all = product_expansion(whole.charge, a);
    const ProductExpansion part = product_expansion(half.charge, b);
    for (const double v : {1.0, 1.5, 3.0, 10.0}) {
      EXPECT_NEAR(part.pressure(v) / all.pressure(v), 0.5, 1e-9) << name << " at " << v;
    }
  }
  const BlastOptions typed = read("explosive anfo vod 3900 energy_share 0.8" + rest);
  EXPECT_EQ(typed.charge.explosive.detonation_velocity, 3900.0);
  EXPECT_DOUBLE_EQ(typed.charge.explosive.energy, 0.8 * 3.8e6);
}

struct WrongInput {
  const char* words;
  const char* message;
};

TEST(BlastOptions, EachWrongWordIsNamedWithItsRule) {
  const std::vector<WrongInput> cases = {
      {"rise_time 0", "rise_time must be > 0 and <= 1 s, got '0'"},
      {"peak_pressure -1e6", "peak_pressure must be >= 1e+05 and <= 1e+12 Pa, got '-1e6'"},
      {"peak_pressure 2.78", "peak_pressure must be >= 1e+05 and <= 1e+12 Pa, got '2.78'"},
      {"expansion jwl jwl 371.2 3.231 4.15 0.95 0.3 21",
       "jwl A must be >= 1e+08 and <= 1e+13 Pa, got '371.2'"},
      {"expansion jwl jwl 371e9 3e15 4.15 0.95 0.3 21e9",
       "jwl B must be >= 0 and <= 1e+12 Pa, got '3e15'"},
      {"expansion jwl jwl 371e9 3e9 300 0.95 0.3 21e9",
       "jwl R1 must be >= 0.5 and <= 20, got '300'"},
      {"expansion jwl jwl 371e9 3e9 4.15 95 0.3 21e9", "jwl R2 must be >= 0 and <= 10, got '95'"},
      {"expansion jwl jwl 371e9 3e9 4.15 0.95 1e-9 21e9",
       "jwl omega must be >= 0.01 and <= 2, got '1e-9'"},
      {"expansion jwl jwl 371e9 3e9 4.15 0.95 0.3 21",
       "jwl P_CJ must be >= 1e+08 and <= 1e+12 Pa, got '21'"},
      {"gas_switch_pressure -2e8",
       "gas_switch_pressure must be >= 1e+05 and <= 1e+12 Pa, got '-2e8'"},
      {"gas_switch_pressure work", "gas_switch_pressure must be a number in Pa, got 'work'"},
      {"energy_share 0", "energy_share must be > 0 and <= 1, got '0'"},
      {"expansion jwl energy_share 0.9 jwl 371.2e9 3.231e9 4.15 0.95 0.3 21e9",
       "hole 1: energy_share does not go with JWL, which is a fit to the whole reaction"},
      {"gas_switch_pressure energy",
       "hole 1: gas_switch_pressure energy needs explosive_energy [J/kg]"},
      {"dense_share 0.3",
       "dense_share needs expansion covolume or jwl, and gas_switch_pressure energy"},
      {"expansion covolume gas_switch_pressure 2e8 dense_share 0.3",
       "dense_share needs expansion covolume or jwl, and gas_switch_pressure energy"},
      {"expansion covolume dense_share 1", "dense_share must be >= 0 and < 1, got '1'"},
      {"expansion covolume", "hole 1: expansion covolume needs explosive_energy [J/kg]"},
      {"expansion two_stage explosive_energy 1e5",
       "hole 1: explosive_energy x explosive_density must be above 1.39219e+09 and "
       "at most 6.96094e+09, what products of these exponents can hold at P0 = 2.78438e+09 Pa (a "
       "slow detonation releases less: energy_share), J/m3, got '1.1e+08'"},
      {"interval -0.01", "interval must be >= 0 and <= 60 s, got '-0.01'"},
      {"hole 1 delay -0.01", "hole 1 delay must be >= 0 and <= 60 s, got '-0.01'"},
      {"hole 3 delay 0.01", "hole must be from 1 to 2, the holes of create_blocks, got '3'"},
      {"hole 0 delay 0.01", "hole must be from 1 to 2, the holes of create_blocks, got '0'"},
      {"hole 1 delay 0 hole 1 delay 0.1", "hole 1 is given twice"},
      {"hole 1 wait 0", "hole 1 must be followed by delay, got 'wait'"},
      {"primer middle", "primer must be bottom, top or a number from 0 to 1, got 'middle'"},
      {"primer 1.5", "primer must be bottom, top or a number from 0 to 1, got '1.5'"},
      {"pulse no gas no", "pulse no and gas no leave no load"},
      {"borehole_model impedance_matched",
       "hole 1: borehole_model impedance_matched needs rock_impedance [Pa s/m]"},
      {"pulse_shape triangular", "pulse_end [s] is needed with pulse_shape triangular"},
      {"pulse_shape triangular pulse_end 1e-5", "pulse_end must be > rise_time s, got '1e-05'"},
      {"pulse_shape itasca", "pulse_half_time [s] is needed with pulse_shape itasca"},
      {"pulse_shape duvall pulse_ratio 1", "pulse_ratio must be > 1 and <= 1000, got '1'"},
      {"pulse_shape table", "pulse_table, a CSV file, is needed with pulse_shape table"},
      {"pulse_shape table pulse_table none",
       "pulse_table, a CSV file, is needed with pulse_shape table"},
      {"venting flow", "stemming_length [m] is needed with gas yes and venting flow"},
      {"venting flow stemming_length 3",
       "crack_delay [s] is needed with gas yes and venting flow (about 1e-3 s per metre of "
       "burden)"},
      {"venting flow stemming_length 3 crack_delay 0 gas_gamma 1",
       "hole 1: gas_gamma must be > 1 with venting flow, got '1'"},
      {"charge_diameter 0.1", "hole 1: charge_diameter must be at most hole_diameter m, got '0.1'"},
      {"charge_length 10",
       "hole 1: charge_length must be at most the length of its hole's axis m, got '10'"},
      {"attenuation liu_katsabanis", "attenuation liu_katsabanis needs rock_p_wave_speed [m/s]"},
      {"attenuation shock attenuation_exponent 2",
       "attenuation_exponent and attenuation shock exclude each other"},
      {"expansion jwl gas_gamma_dense 3", "gas_gamma_dense needs expansion two_stage"},
      {"expansion jwl",
       "hole 1: expansion jwl needs JWL parameters, explosive 'as typed' has none; take an "
       "explosive_table that has them (columns jwl_a_Pa ...), the keyword jwl, or expansion "
       "covolume"},
      {"borehole_model jwl",
       "hole 1: borehole_model jwl needs JWL parameters, explosive 'as typed' has none; take an "
       "explosive_table that has them (columns jwl_a_Pa ...), the keyword jwl, or another "
       "borehole_model"},
      {"borehole_model explosion_state_gamma",
       "hole 1: borehole_model explosion_state_gamma needs explosive_gamma"},
      {"borehole_model chapman_jouguet borehole_pressure 1e9",
       "borehole_pressure and borehole_model exclude each other"},
  };
  for (const WrongInput& wrong : cases) {
    EXPECT_EQ(message(kCharge + kGas + " " + wrong.words), kWhere + ": " + wrong.message);
  }
}

const std::string kFlow = " venting flow stemming_length 3 crack_delay 0";
const std::string kTnt =
    "explosive tnt hole_diameter 0.09 poisson_ratio 0.22 expansion jwl gas_gamma 1";

TEST(BlastOptions, GasFlowsWithTheExponentOfItsLaw) {
  EXPECT_EQ(gas_gamma(read(kCharge + kFlow)), 1.4);
  EXPECT_EQ(gas_gamma(read(kCharge + kFlow + " gas_gamma 1.25")), 1.25);
  // omega 0.3; gas_gamma is of the other law, and 1 would be refused with flow
  EXPECT_DOUBLE_EQ(gas_gamma(read(kTnt + kFlow)), 1.3);
  EXPECT_EQ(message(kTnt + kFlow), "");
}

TEST(BlastOptions, GasOfHolesMustHaveOneExponent) {
  const testing::TemporaryFolder folder;
  const std::string table = testing::write_text(
      folder.path() / "holes.csv",
      "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,explosive\n"
      "a,0,0,9,0,0,0,0.09,tnt\nb,5,0,9,5,0,0,0.09,emulsion_dense\n");
  const std::string words = "explosive tnt poisson_ratio 0.22 hole_table " + table + kFlow;
  EXPECT_EQ(gas_gamma(read(words)), 1.4);
  EXPECT_EQ(
      input_error_of([&] { (void)gas_gamma(read(words + " expansion jwl")); }),
      kWhere + ": gas in joints must have one exponent, got 1.3 of hole 1 and 1.15 of hole 2");
}

TEST(BlastOptions, FlowLeavesTheTimesOpen) {
  const BlastOptions options = read(kCharge + kFlow);
  EXPECT_FALSE(options.vent_time || options.vent_decay);
  EXPECT_EQ(read(kCharge + kFlow + kGas).vent_decay, 4.5e-3);
}

TEST(BlastOptions, ChecksTheNumbersThatMayBeLeftOut) {
  const std::string bare = "explosive_density 1100 vod 4500 hole_diameter 0.09";
  EXPECT_EQ(message(bare + " poisson_ratio 0.5" + kGas),
            kWhere + ": poisson_ratio must be >= 0 and < 0.5, got '0.5'");
  EXPECT_EQ(message(kCharge + " vent_time 0.01 vent_decay 0"),
            kWhere + ": vent_decay must be > 0 and <= 60 s, got '0'");
  EXPECT_EQ(message(kCharge + kGas + " borehole_pressure -1"),
            kWhere + ": borehole_pressure must be >= 1e+05 and <= 1e+12 Pa, got '-1'");
}

/// A slip of the unit or of a finger, not a charge.
TEST(BlastOptions, RefusesNumbersFarOutOfRange) {
  const std::string bare = "hole_diameter 0.09 poisson_ratio 0.25" + kGas;
  for (const char* word : {"explosive_density",
                           "vod",
                           "explosive_energy",
                           "explosive_gamma",
                           "energy_share",
                           "gas_volume",
                           "borehole_pressure",
                           "rock_impedance",
                           "charge_diameter",
                           "charge_length",
                           "coupling_exponent",
                           "decoupling_exponent",
                           "impact_factor",
                           "rise_time",
                           "pulse_ratio",
                           "pulse_end",
                           "pulse_half_time",
                           "rock_p_wave_speed",
                           "attenuation_exponent",
                           "peak_pressure",
                           "gas_switch_pressure",
                           "gas_gamma_dense",
                           "gas_gamma",
                           "stemming_length",
                           "stemming_density",
                           "stemming_shear",
                           "collar_discharge",
                           "crack_delay",
                           "crack_discharge",
                           "interval",
                           "hole 1 delay"}) {
    const std::string text = message("explosive emulsion " + bare + " " + word + " 1e300");
    EXPECT_NE(text.find(kWhere + ": " + word + " must be "), std::string::npos)
        << word << ": " << text;
    EXPECT_NE(text.find("got '1e300'"), std::string::npos) << word << ": " << text;
  }
  EXPECT_EQ(message("explosive emulsion " + bare + " borehole_pressure 2.78"),
            kWhere + ": borehole_pressure must be >= 1e+05 and <= 1e+12 Pa, got '2.78'");
}

TEST(BlastOptions, SaysWhatIsMissing) {
  EXPECT_EQ(message(kCharge),
            kWhere + ": vent_time [s] is needed with gas yes (about 3.3e-3 s per metre of burden)");
  EXPECT_EQ(message("explosive_density 1100 vod 4500 hole_diameter 0.09 attenuation shock" + kGas),
            kWhere + ": attenuation shock needs poisson_ratio");
  EXPECT_EQ(message("explosive_density 1100 vod 4500 hole_diameter 0.09" + kGas), "");
  EXPECT_EQ(message(kCharge + kGas, {}),
            kWhere + ": there is no hole to load; give create_blocks a hole");
  EXPECT_EQ(message(kCharge + " gas no"), "");
}

TEST(BlastOptions, RefusesAHoleWiderThanItsCrushedZone) {
  EXPECT_EQ(message("explosive_density 1100 vod 4500 hole_diameter 0.3 poisson_ratio 0.22" + kGas),
            kWhere +
                ": hole_diameter must not exceed that of the crushed zone of hole 1, 0.27 [m], "
                "got '0.3'");
}

TEST(HoleBlast, AWallMovedBeforeItsHoleFiresNeitherCompressesNorExpandsItsGas) {
  const HoleBlast blast = hole_blasts(read(kCharge + kGas + " interval 0.1"), {kZone, kZone})[1];
  const double volume = blast.load().charge_volume();
  GasState pushed, pulled;
  blast.advance(pushed, -20.0 * volume, 0.0999, 1e-4);
  blast.advance(pulled, 3.0 * volume, 0.0999, 1e-4);
  EXPECT_NEAR(blast.gas_pressure(-20.0 * volume, 0.1, pushed), 200e6, 1.0);
  EXPECT_NEAR(blast.pulse_limit(-20.0 * volume, 0.1, pushed), 2.784375e9, 10.0);
  EXPECT_NEAR(blast.gas_volume(-20.0 * volume, pushed), blast.load().start_volume(), 1e-12);
  // pushed in afterwards, its gas is compressed
  blast.advance(pushed, -21.0 * volume, 0.1, 1e-4);
  EXPECT_NEAR(blast.gas_pressure(-21.0 * volume, 0.1, pushed),
              2.784375e9 / std::pow(blast.load().start_volume() / volume - 1.0, 3), 100.0);
  EXPECT_NEAR(blast.gas_pressure(3.0 * volume, 0.1, pulled), 200e6, 1.0);
  // opened by three more: (2784.4/200)^(1/3) = 2.40565: 200 (2.40565/5.40565)^1.4 = 64.4 MPa
  EXPECT_NEAR(blast.gas_pressure(6.0 * volume, 0.1, pulled), 64.4e6, 0.1e6);
}

TEST(HoleBlast, IsOverOnlyAfterTheLastLoadHasGone) {
  const HoleBlast blast = hole_blasts(read(kCharge + kGas + " interval 0.1"), {kZone, kZone})[1];
  EXPECT_EQ(blast.gas_pressure(0.0, 0.0999), 0.0);
  EXPECT_FALSE(blast.over(0.0, 0.0));     // not fired
  EXPECT_FALSE(blast.over(0.1015, 0.0));  // column still detonating
  EXPECT_FALSE(blast.over(0.1030, 0.0));  // pulse 1 ms after the last arrival: 4 x 2^-10 P1
  EXPECT_FALSE(blast.over(0.2, 1e6));     // gas left
  EXPECT_TRUE(blast.over(0.2, 1e3));
}

}  // namespace
}  // namespace muckpile
