// SPDX-License-Identifier: GPL-2.0-or-later
// Constants of the contact law: checks, elastic moduli, damping ratio from restitution.
// Scope: the functions of many contacts at once are inline in the header.
#include "contact/contact_law.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "args/require.h"

namespace muckpile {

namespace {

constexpr double kLeastRestitution = 0.05;  // below, the dashpot alone would limit the time step

using One = std::experimental::simd<double, std::experimental::simd_abi::scalar>;

ContactMotionOf<One> lane_of(const ContactMotion& m) {
  return {VectorOf<One>(m.normal),
          m.overlap,
          m.radius_first,
          m.radius_second,
          m.reduced_mass,
          VectorOf<One>(m.relative_velocity),
          VectorOf<One>(m.relative_spin)};
}

}  // namespace

double restitution_of(double damping_ratio) {
  const double z = damping_ratio;
  const double s = 1.0 - z * z;
  if (std::abs(s) < 1e-12) return std::exp(-2.0);  // limit z -> 1
  const double phase = s > 0.0 ? std::acos(z) / std::sqrt(s) : std::acosh(z) / std::sqrt(-s);
  return std::exp(-2.0 * z * phase);
}

double damping_ratio_for(double restitution) {
  require(restitution >= kLeastRestitution && restitution <= 1.0,
          "contact law: restitution must lie between 0.05 and 1", restitution);
  double low = 0.0, high = 4.0;  // restitution_of(4) = 0.014
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (restitution_of(middle) > restitution ? low : high) = middle;
  }
  return restitution == 1.0 ? 0.0 : 0.5 * (low + high);
}

ContactLaw::ContactLaw(const ContactParameters& p)
    : model_(p.model),
      youngs_modulus_(p.youngs_modulus),
      damping_ratio_(damping_ratio_for(p.restitution)),
      friction_(p.friction),
      rolling_friction_(p.rolling_friction) {
  require(p.youngs_modulus > 0.0 && std::isfinite(p.youngs_modulus),
          "contact law: youngs_modulus must be > 0 Pa", p.youngs_modulus);
  require(p.poisson_ratio > -1.0 && p.poisson_ratio < 0.5,
          "contact law: poisson_ratio must lie in (-1, 0.5)", p.poisson_ratio);
  require(p.friction >= 0.0 && std::isfinite(p.friction), "contact law: friction must be >= 0",
          p.friction);
  require(p.rolling_friction >= 0.0 && std::isfinite(p.rolling_friction),
          "contact law: rolling_friction must be >= 0", p.rolling_friction);
  const double nu = p.poisson_ratio;
  const double shear_modulus = p.youngs_modulus / (2.0 * (1.0 + nu));
  young_star_ = p.youngs_modulus / (2.0 * (1.0 - nu * nu));
  shear_star_ = shear_modulus / (2.0 * (2.0 - nu));
  tangential_ratio_ = 2.0 * (1.0 - nu) / (2.0 - nu);
}

ContactState ContactLaw::begin_contact(const ContactMotion& motion, double time_step) {
  ContactState state;
  state.overlap_offset = first_offset(lane_of(motion), time_step)[0];
  return state;
}

ContactResponse ContactLaw::evaluate(const ContactMotion& motion, double time_step,
                                     ContactState& state) const {
  ContactStateOf<One> lane{VectorOf<One>(state.slide), VectorOf<One>(state.roll),
                           state.overlap_offset, state.tangential_stiffness};
  const ContactResponseOf<One> response = evaluate(lane_of(motion), time_step, lane);
  state = {lane.slide.at(0), lane.roll.at(0), lane.overlap_offset[0], lane.tangential_stiffness[0]};
  return {response.force_on_first.at(0), response.torque_on_first.at(0),
          response.elastic_energy[0],    response.friction_loss[0],
          response.damping_loss[0],      response.dashpot_on_first.at(0)};
}

double ContactLaw::normal_stiffness(double radius_first, double radius_second,
                                    double overlap) const {
  if (model_ == NormalModel::linear)
    return linear_stiffness(One(radius_first), One(radius_second))[0];
  const double reduced_radius = radius_first * radius_second / (radius_first + radius_second);
  return 2.0 * young_star_ * std::sqrt(reduced_radius * overlap);
}

ContactResistance ContactLaw::resistance(const ContactMotion& motion,
                                         const ContactState& state) const {
  const double reduced_radius =
      motion.radius_first * motion.radius_second / (motion.radius_first + motion.radius_second);
  const double overlap = std::max(motion.overlap - state.overlap_offset, 0.0);
  const Normal<One> normal = normal_part(lane_of(motion), One(reduced_radius), One(overlap));
  const double tangential = normal.tangential_stiffness[0];
  return {normal_stiffness(motion.radius_first, motion.radius_second, overlap), tangential,
          tangential * reduced_radius * reduced_radius, normal.damping[0],
          normal.tangential_damping[0]};
}

double ContactLaw::stable_time_step(double mass, double radius) const {
  constexpr double kOverlapRatio = 0.05, kShareOfPeriod = 0.2;
  // A plane is as stiff as two spheres of twice the radius are. Two equal spheres of the linear
  // model are half as stiff and have half the mass: their step is the same.
  const double stiffness = normal_stiffness(2.0 * radius, 2.0 * radius, kOverlapRatio * radius);
  return kShareOfPeriod * std::sqrt(mass / stiffness);
}

}  // namespace muckpile
