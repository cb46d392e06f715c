// SPDX-License-Identifier: GPL-2.0-or-later
// Natural joints by Barton and Bandis: keywords, apertures.
// Scope: see the header.
#include "bond/law/barton_bandis.h"

#include <algorithm>

#include "args/input_error.h"
#include "args/numbers.h"
#include "bond/law/hydraulic_aperture.h"
#include "bond/law/joint_law_table.h"

namespace muckpile {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

ArgTable keywords() {
  return joint_class_table("barton_bandis")
      .real("initial_stiffness", "Pa/m", Range::closed(1e6, 1e15), std::nullopt,
            "normal stiffness without pressure, k_ni")
      .real("closure_limit", "m", Range::closed(1e-7, 0.1), std::nullopt,
            "closure under endless pressure, V_m")
      .real("roughness", "", Range::closed(0.1, 20.0), std::nullopt,
            "joint roughness coefficient JRC, of joints as long as the blocks")
      .real("wall_strength", "Pa", Range::closed(1e5, 1e9), std::nullopt,
            "joint wall compressive strength JCS, of joints as long as the blocks")
      .real("residual_friction_angle", "deg", Range::right_open(0.0, 90.0), std::nullopt, "phi_r")
      .real("irrecoverable_closure", "", Range::closed(0.0, 0.9), 0.0,
            "share of the largest closure so far that unloading does not give back")
      .real("peak_slip", "m", Range::closed(0.0, 1.0), 0.0,
            "slip up to the peak; roughness wears off beyond it. 0: it falls at once")
      .real("largest_angle", "deg", Range::right_open(1.0, 90.0), 70.0,
            "cap of the whole friction angle")
      .real("tension", "Pa", Range::closed(0.0, 1e12), 0.0, "tensile strength (cut-off)")
      .real("shear_stiffness", "Pa/m", Range::closed(0.0, 1e15), 0.0,
            "in series with the rock; 0: rigid")
      .real("compressive_strength", "Pa", Range::closed(0.0, 1e10), 0.0,
            "of the rock, UCS, for the initial aperture; 0: as wall_strength")
      .real("initial_aperture", "m", Range::closed(0.0, 0.1), 0.0,
            "mechanical, without pressure; 0: JRC/5 (0.2 UCS/JCS - 0.1) mm");
}

JointClass make(const ArgValues& args, const std::string& where) {
  BartonBandis law;
  law.initial_stiffness = args.real("initial_stiffness");
  law.closure_limit = args.real("closure_limit");
  law.irrecoverable = args.real("irrecoverable_closure");
  law.roughness = args.real("roughness");
  law.wall_strength = args.real("wall_strength");
  law.residual_angle = args.real("residual_friction_angle") * kDegree;
  law.largest_angle = args.real("largest_angle") * kDegree;
  law.tension = args.real("tension");
  law.peak_slip = args.real("peak_slip");
  const double given = args.real("initial_aperture"), ucs = args.real("compressive_strength");
  law.initial_aperture = given > 0.0 ? given
                                     : barton_bandis_aperture(law.roughness, law.wall_strength,
                                                              ucs > 0.0 ? ucs : law.wall_strength);
  if (law.largest_angle < law.residual_angle)
    throw InputError(where + ": largest_angle must be >= residual_friction_angle, got '" +
                     number_text(args.real("largest_angle")) + "'");
  if (law.initial_aperture <= law.closure_limit)
    throw InputError(where + ": closure_limit must be < the initial aperture of " +
                     number_text(law.initial_aperture) + " m, got '" +
                     number_text(law.closure_limit) + "'; give initial_aperture");
  return barton_bandis_class(law, rigid_if_0(args.real("shear_stiffness")));
}

}  // namespace

JointLawEntry barton_bandis_entry() { return {"barton_bandis", keywords(), make}; }

JointClass barton_bandis_class(const BartonBandis& law, double shear_stiffness) {
  JointClass joint;
  joint.tension = law.tension;  // whose fracture energy it takes
  joint.normal_stiffness = law.initial_stiffness;
  joint.shear_stiffness = shear_stiffness;
  joint.law = law_everywhere(law);
  return joint;
}

double barton_bandis_aperture(double roughness, double wall_strength, double compressive_strength) {
  return 1e-3 * roughness / 5.0 * (0.2 * compressive_strength / wall_strength - 0.1);
}

JointApertures BartonBandis::apertures(double closure) const {
  const double mechanical = initial_aperture - closure;
  return {mechanical, hydraulic_aperture(mechanical, smooth_from_aperture(roughness))};
}

BartonBandis BartonBandis::softened(double factor) const {
  BartonBandis soft = *this;
  soft.initial_stiffness *= factor;
  return soft;
}

}  // namespace muckpile
