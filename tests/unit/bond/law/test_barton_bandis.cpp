// SPDX-License-Identifier: GPL-2.0-or-later
// Barton and Bandis' joint by itself: closure, hysteresis, strength, friction and apertures against
// the formulas, and the words of a joint class.
// Scope: one point at width one; four at once are the same code.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "args/input_error.h"
#include "bond/law/barton_bandis.h"
#include "bond/law/joint_law_table.h"

namespace muckpile::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0, kRounding = 1e-12;

BartonBandis joint() {
  BartonBandis law;
  law.initial_stiffness = 1e10;  // 10 MPa/mm
  law.closure_limit = 1e-4;
  law.roughness = 10.0;
  law.wall_strength = 100e6;
  law.residual_angle = 30.0 * kDegree;
  law.largest_angle = 70.0 * kDegree;
  law.initial_aperture = barton_bandis_aperture(10.0, 100e6, 100e6);
  return law;
}

/// Pressure of the joint alone at that closure.
double pressure_at(const BartonBandis& law, double closure, double largest) {
  constexpr double kStiff = 1e25;  // rock that does not give way
  return law.close(closure, kStiff, largest).pressure;
}

TEST(BartonBandis, ClosesAlongTheHyperbola) {
  // k c/(1 - c/V): 10 MPa/mm x 0.05 mm / (1 - 0.5) = 1 MPa, x 0.09 mm / (1 - 0.9) = 9 MPa
  EXPECT_NEAR(pressure_at(joint(), 5e-5, 0.0) / 1e6, 1.0, 1e-9);
  EXPECT_NEAR(pressure_at(joint(), 9e-5, 0.0) / 9e6, 1.0, 1e-9);
  EXPECT_NEAR(pressure_at(joint(), -1e-5, 0.0) / -1e5, 1.0, 1e-9);  // pulled: k c
  double worst = 0.0;
  for (double w = 1e-7; w < 1e-2; w *= 1.3) {
    constexpr double kRock = 6e10;
    const JointClosure<double> at = joint().close(w, kRock, 0.0);
    const double formula = 1e10 * at.closure / (1.0 - at.closure / 1e-4);
    worst = std::max({worst, std::abs(at.pressure / formula - 1.0),
                      std::abs(at.pressure / (kRock * (w - at.closure)) - 1.0)});
    EXPECT_NEAR(joint().jump_at(at.pressure, kRock, 0.0) / w, 1.0, 1e-11);
  }
  RecordProperty("worst relative error of the pressure", std::to_string(worst));
  EXPECT_LT(worst, 1e-9) << worst;  // differences of numbers close to each other
}

TEST(BartonBandis, FourPointsAtOnceAreTheSame) {
  const Lanes jumps([](auto lane) { return 1e-5 * (1.0 + lane) - 1.5e-5; });
  const JointClosure<Lanes> at = joint().close(jumps, 6e10, Lanes(2e-5));
  for (std::size_t k = 0; k < kLanes; ++k) {
    const JointClosure<double> one = joint().close(double{jumps[k]}, 6e10, 2e-5);
    EXPECT_NEAR(at.pressure[k], one.pressure, kRounding * std::abs(one.pressure));
    EXPECT_NEAR(at.rate[k], one.rate, kRounding * one.rate);
  }
}

TEST(BartonBandis, RatesAreDerivatives) {
  BartonBandis law = joint();
  law.irrecoverable = 0.3;
  for (const double w : {-1e-5, 2e-5, 6e-5, 2e-4}) {
    const double d = 1e-10, rock = 6e10, largest = 5e-5;
    const auto more = law.close(w + d, rock, largest), less = law.close(w - d, rock, largest);
    const auto at = law.close(w, rock, largest);
    EXPECT_NEAR((more.closure - less.closure) / (2 * d) / at.rate, 1.0, 1e-5);
    const double tangent = (more.pressure - less.pressure) / (more.closure - less.closure);
    EXPECT_NEAR(rock / (rock + tangent) / at.rate, 1.0, 1e-5);
  }
}

TEST(BartonBandis, UnloadsToTheClosureThatStays) {
  BartonBandis law = joint();
  law.irrecoverable = 0.4;
  const double largest = 8e-5;
  EXPECT_NEAR(pressure_at(law, 0.4 * largest, largest), 0.0, 1e-3);
  EXPECT_NEAR(pressure_at(law, largest, largest) / pressure_at(law, largest, 0.0), 1.0, 1e-9);
  EXPECT_LT(pressure_at(law, 0.9 * largest, largest), pressure_at(law, 0.9 * largest, 0.0));
  EXPECT_NEAR(pressure_at(law, 9e-5, largest) / 9e6, 1.0, 1e-9);  // beyond: first loading
}

TEST(BartonBandis, ACycleTakesWhatTheLawSays) {
  BartonBandis law = joint();
  law.irrecoverable = 0.4;
  const double largest = 8e-5, step = 1e-9;
  double work = 0.0, given_back = 0.0;
  for (double c = 0.5 * step; c < largest; c += step) {
    work += step * pressure_at(law, c, 0.0);
    if (c > 0.4 * largest) given_back += step * pressure_at(law, c, largest);
  }
  const double taken = law.taken(largest);
  std::printf("cycle: taken %.6g J/m2, integrated %.6g, error %.2g\n", taken, work - given_back,
              taken / (work - given_back) - 1.0);
  EXPECT_GT(taken, 0.1 * work);
  EXPECT_NEAR(taken / (work - given_back), 1.0, 1e-6);  // midpoints of 1e-5 of the way
  EXPECT_NEAR(law.stored(largest, largest) / given_back, 1.0, 1e-6);
  EXPECT_EQ(joint().taken(largest), 0.0);
}

TEST(BartonBandis, StrengthIsThatOfRoughnessAndWall) {
  double worst = 0.0;
  // JRC log10(JCS/s) + phi_r: 10 log10(100/1) + 30 = 50 degrees, 10 x 1 + 30, 10 x 3 + 30
  for (const auto& [pressure, angle] : {std::pair{1e6, 50.0},
                                        {10e6, 40.0},
                                        {0.1e6, 60.0},
                                        {1e3, 70.0},       // capped: 80 without
                                        {200e6, 30.0}}) {  // not below phi_r
    const double shear = pressure * std::tan(angle * kDegree);
    EXPECT_FALSE(joint().fails(-pressure, std::pow(0.9999 * shear, 2))) << pressure;
    EXPECT_TRUE(joint().fails(-pressure, std::pow(1.0001 * shear, 2))) << pressure;
    const double found = pressure * joint().tan_angle(pressure, 10.0);
    worst = std::max(worst, std::abs(found / shear - 1.0));
  }
  std::printf("strength: worst error %.2g\n", worst);
  EXPECT_LT(worst, 1e-12);
  EXPECT_TRUE(joint().fails(1.0, 0.0));  // no tension
}

TEST(BartonBandis, TensionCutOffMovesTheCurve) {
  BartonBandis law = joint();
  law.tension = 1e6;
  EXPECT_FALSE(law.fails(0.99e6, 0.0));
  EXPECT_TRUE(law.fails(1.01e6, 0.0));
  const double shear = 1e6 * std::tan(50.0 * kDegree);  // as under 1 MPa
  EXPECT_FALSE(law.fails(0.0, std::pow(0.999 * shear, 2)));
  EXPECT_TRUE(law.fails(0.0, std::pow(1.001 * shear, 2)));
}

TEST(BartonBandis, RoughnessWearsOffWithSlip) {
  BartonBandis law = joint();
  EXPECT_NEAR(law.friction(1e6, 0.0), std::tan(30.0 * kDegree), kRounding);  // at once
  law.peak_slip = 1e-3;
  EXPECT_NEAR(law.friction(1e6, 0.0), std::tan(50.0 * kDegree), kRounding);
  // (1/10)^0.381 = 0.41591: 30 + 0.41591 x 20 degrees
  EXPECT_NEAR(law.friction(1e6, 9e-3), std::tan(38.3182 * kDegree), 1e-5);
}

TEST(BartonBandis, GasFindsLessOfAClosedJoint) {
  // E_0 = 10/5 (0.2 - 0.1) mm = 0.2 mm; e = 200^2/10^2.5 = 126.49 um
  EXPECT_NEAR(joint().initial_aperture, 2e-4, 1e-18);
  EXPECT_NEAR(joint().apertures(0.0).hydraulic, 126.491e-6, 1e-9);
  EXPECT_NEAR(joint().apertures(1e-4).hydraulic, 31.6228e-6, 1e-10);  // half of it: a quarter
  EXPECT_NEAR(joint().apertures(-1e-3).hydraulic, 1.2e-3, 1e-15);     // never wider than it is
  EXPECT_NEAR(joint().apertures(1e-4).mechanical, 1e-4, 1e-18);
  double before = 1.0;
  for (double pressure = 0.0; pressure < 50e6; pressure += 1e6) {
    const double closure = joint().jump_at(pressure, 1e20, 0.0);
    const double now = joint().apertures(closure).hydraulic;
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST(BartonBandis, SofteningTakesPressureAtTheSameClosure) {
  EXPECT_NEAR(pressure_at(joint().softened(0.1), 5e-5, 0.0) / 1e5, 1.0, 1e-9);
}

const ArgTable& style() {
  static const ArgTable table =
      ArgTable("fix x")
          .real("tension", "Pa", Range::closed(0.0, 1e12), 0.0, "of the rock")
          .real("damping", "", Range::closed(0.0, 10.0), 0.0, "share");
  return table;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : line + " ") {
    if (c != ' ') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(word);
      word.clear();
    }
  }
  return words;
}

JointClassWords read(const std::string& line) {
  return read_joint_classes(style(), "fix x 'j'", split(line));
}

std::string refusal(const std::string& line) {
  try {
    static_cast<void>(read(line));
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

bool grouped(const JointClass& joint) {
  JointParameters rock;
  rock.youngs_modulus = 5e10;
  rock.density = 2600.0;
  return joint.law(JointMaterial(rock).with_joints(joint))->grouped();
}

TEST(JointClassWords, ClassesAreTakenOutOfTheWords) {
  const JointClassWords words = read(
      "tension 2 joint_class 2 law barton_bandis initial_stiffness 1e10 closure_limit 1e-4 "
      "roughness 10 wall_strength 1e8 residual_friction_angle 30 joint_class 1 law coulomb "
      "tension 5 friction_angle 45 damping 0.1");
  EXPECT_EQ(words.others, split("tension 2 damping 0.1"));
  ASSERT_EQ(words.classes.size(), 2u);
  EXPECT_EQ(words.classes[0].tension, 5.0);
  EXPECT_TRUE(grouped(words.classes[0]));
  EXPECT_NEAR(words.classes[0].friction_angle, 45.0 * kDegree, kRounding);
  EXPECT_TRUE(std::isinf(words.classes[0].normal_stiffness));
  EXPECT_FALSE(grouped(words.classes[1]));
  EXPECT_EQ(words.classes[1].normal_stiffness, 1e10);
}

TEST(JointClassWords, WhatIsWrongIsTold) {
  const std::string form = "as in 'joint_class 1 law coulomb";
  EXPECT_NE(refusal("joint_class 0 35 0 30 0 0").find(form), std::string::npos);
  EXPECT_NE(refusal("joint_class 1").find(form), std::string::npos);
  EXPECT_NE(
      refusal("joint_class 1 law barton_bandid roughness 3").find("law must be one of coulomb, "),
      std::string::npos);
  EXPECT_NE(refusal("joint_class 1 law coulomb").find("friction_angle is missing"),
            std::string::npos);
  EXPECT_NE(refusal("joint_class 1 law coulomb friction_angle 95").find("got '95'"),
            std::string::npos);
  EXPECT_NE(refusal("joint_class 1 law coulomb friction_angel 30").find("'friction_angle'"),
            std::string::npos);
  EXPECT_NE(refusal("joint_class 2 law coulomb friction_angle 30").find("joint_class 1 is missing"),
            std::string::npos);
  const std::string one = "joint_class 1 law coulomb friction_angle 30 ";
  EXPECT_NE(refusal(one + one).find("joint_class 1 is given twice"), std::string::npos);
  EXPECT_NE(refusal("joint_class 1 law barton_bandis initial_stiffness 1e10 closure_limit 1e-3 "
                    "roughness 10 wall_strength 1e8 residual_friction_angle 30")
                .find("closure_limit must be < the initial aperture of 2e-04 m"),
            std::string::npos)
      << refusal(
             "joint_class 1 law barton_bandis initial_stiffness 1e10 closure_limit 1e-3 "
             "roughness 10 wall_strength 1e8 residual_friction_angle 30");
}

}  // namespace
}  // namespace muckpile::test
