// SPDX-License-Identifier: GPL-2.0-or-later
// Joints of every law, and cubes with such joints between them, for what every law must do.
// Scope: tests only. A new law adds a line to joint_laws(); law() are figures of Barton and Bandis'
// for tests of closed forms.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "bond/law/barton_bandis.h"
#include "bond/law/joint_material.h"
#include "bond_scene.h"

namespace muckpile::test {

constexpr double kDegree = std::numbers::pi / 180.0;

inline BartonBandis law() {
  BartonBandis joint;
  joint.initial_stiffness = 1e10;
  joint.closure_limit = 1e-4;
  joint.roughness = 10.0;
  joint.wall_strength = 100e6;
  joint.residual_angle = 30.0 * kDegree;
  joint.largest_angle = 70.0 * kDegree;
  joint.initial_aperture = 2e-4;
  return joint;
}

inline BondScene cubes(int nx, int ny, const JointParameters& rock, const JointClass& joint) {
  return {cuboids(nx, ny, ny),
          rock,
          [](const Vec3&) { return Support::free; },
          {{joint}, {{Vec3(1, 0, 0), Vec3::UnitX(), 1}}}};
}
inline BondScene cubes(int nx, int ny, double poisson_ratio, const JointClass& joint) {
  return cubes(nx, ny, rock(poisson_ratio), joint);
}

/// A joint that closes over some 1e-4 m: its strength in tension and its cohesion [Pa], and whether
/// closure stays. A law without cohesion or hysteresis leaves these aside.
struct Wanted {
  double tension = 1e30, cohesion = 1e30;
  bool keeps_closure = false;
};
struct LawOfJoints {
  const char* name;
  JointClass (*joint)(const Wanted& wanted);
};
inline void PrintTo(const LawOfJoints& of, std::ostream* out) { *out << of.name; }

inline JointClass barton_bandis_joint(const Wanted& wanted) {
  BartonBandis joint = law();
  joint.tension = wanted.tension;
  joint.irrecoverable = wanted.keeps_closure ? 0.4 : 0.0;
  joint.peak_slip = 1e-3;
  return barton_bandis_class(joint, 2e10);
}

inline JointClass coulomb_joint(const Wanted& wanted) {
  JointClass joint;
  joint.tension = wanted.tension;
  joint.cohesion = wanted.cohesion;
  joint.friction_angle = 0.6;
  joint.residual_friction_angle = 0.5;
  joint.normal_stiffness = 5e10;
  joint.shear_stiffness = 2e10;
  return joint;
}

inline std::vector<LawOfJoints> joint_laws() {
  return {{"coulomb", coulomb_joint}, {"barton_bandis", barton_bandis_joint}};
}

/// Its law between two parts of that rock.
inline std::shared_ptr<const JointLaw> law_of(const JointClass& joint) {
  return joint.law(JointMaterial(rock(0.25)).with_joints(joint));
}

class EachJointLaw : public testing::TestWithParam<LawOfJoints> {
 protected:
  static JointClass joint(const Wanted& wanted) { return GetParam().joint(wanted); }
};
inline std::string name_of_law(const testing::TestParamInfo<LawOfJoints>& one) {
  return one.param.name;
}

}  // namespace muckpile::test
