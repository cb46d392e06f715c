// SPDX-License-Identifier: GPL-2.0-or-later
// Joints with linear closure and Coulomb's strength: their numbers from a material, keywords.
// Scope: see the header.
#include "bond/law/coulomb.h"

#include <numbers>

#include "bond/law/joint_law_table.h"

namespace muckpile {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// The upper end stands for a joint that does not break.
Range strengths() { return Range::closed(0.0, 1e12); }
Range angles() { return Range::right_open(0.0, 90.0); }
Range stiffnesses() { return Range::closed(0.0, 1e15); }

JointClass make(const ArgValues& args, const std::string& /*where*/) {
  JointClass joint;
  joint.tension = args.real("tension");
  joint.cohesion = args.real("cohesion");
  joint.friction_angle = args.real("friction_angle") * kDegree;
  joint.residual_friction_angle = args.real("residual_friction_angle") * kDegree;
  joint.normal_stiffness = rigid_if_0(args.real("normal_stiffness"));
  joint.shear_stiffness = rigid_if_0(args.real("shear_stiffness"));
  joint.wall_strength = args.real("wall_strength");
  return joint;
}

}  // namespace

Coulomb coulomb_of(const JointMaterial& joints) {
  const JointParameters& p = joints.parameters();
  return {{p.tension, p.cohesion, joints.tan_friction(), joints.tan_residual_friction()},
          {p.normal_stiffness}};
}

JointLawMaker coulomb_law() {
  return [](const JointMaterial& joints) {
    return std::make_shared<JointLawOf<Coulomb>>(coulomb_of(joints));
  };
}

JointLawEntry coulomb_entry() {
  return {"coulomb",
          joint_class_table("coulomb")
              .real("tension", "Pa", strengths(), 0.0, "tensile strength (cut-off)")
              .real("cohesion", "Pa", strengths(), 0.0, "shear strength without normal stress")
              .real("friction_angle", "deg", angles(), std::nullopt, "of the unbroken joint")
              .real("residual_friction_angle", "deg", angles(), 35.0, "of the broken joint")
              .real("normal_stiffness", "Pa/m", stiffnesses(), 0.0,
                    "of the joint alone, in series with the rock; 0: rigid")
              .real("shear_stiffness", "Pa/m", stiffnesses(), 0.0,
                    "of the joint alone, in series with the rock; 0: rigid")
              .real("wall_strength", "Pa", strengths(), 0.0,
                    "pressure at which the walls of the broken joint crush, JCS; 0: that of the "
                    "rock"),
          make};
}

}  // namespace muckpile
