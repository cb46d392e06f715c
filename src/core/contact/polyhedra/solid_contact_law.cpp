// SPDX-License-Identifier: GPL-2.0-or-later
// Force between two overlapping polyhedra.
// Scope: see the header.
#include "contact/polyhedra/solid_contact_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muckpile {
namespace {

/// A spring with a dashpot that bears no more than a limit.
struct Friction {
  Vec3 stretch;  ///< at the end of the step
  Vec3 pull;     ///< of the spring
  Vec3 damped;   ///< with the dashpot
  double energy, loss;
};

/// Keeps the length of what lies in the plane, or along the normal.
Vec3 with_length_of(const Vec3& part, const Vec3& whole) {
  const double length = part.norm();
  return length > 1e-6 * whole.norm() ? Vec3(whole.norm() / length * part) : Vec3(Vec3::Zero());
}

/// As in the contact of spheres: a spring whose stiffness grows keeps its
/// force, one whose stiffness falls keeps its length (Elata and Berryman 1996);
/// the loss is what leapfrog takes from the bodies less what the spring gains.
Friction stick_or_slip(const Vec3& old, const Vec3& rate, double before, double stiffness,
                       double damping, double limit, double time_step) {
  const double shrink = stiffness > before && before > 0.0 ? before / stiffness : 1.0;
  const Vec3 path = time_step * rate;
  Friction f;
  f.stretch = shrink * old + path;
  const double trial = stiffness * f.stretch.norm();
  const bool slips = trial > limit;
  if (slips) f.stretch *= limit / trial;
  f.pull = -stiffness * f.stretch;
  f.damped = f.pull;
  if (!slips) {
    f.damped -= damping * rate;
    const double size = f.damped.norm();
    if (size > limit) f.damped *= limit / size;
  }
  f.energy = 0.5 * stiffness * f.stretch.squaredNorm();
  f.loss = 0.5 * (before * old - f.pull).dot(path) - (f.energy - 0.5 * before * old.squaredNorm());
  return f;
}

}  // namespace

SolidContactLaw::SolidContactLaw(const ContactParameters& p)
    : damping_ratio_(ContactLaw(p).damping_ratio()), friction_(p.friction) {
  const double nu = p.poisson_ratio;
  half_modulus_ = 0.25 * p.youngs_modulus / (1.0 - nu * nu);
  tangential_ratio_ = 2.0 * (1.0 - nu) / (2.0 - nu);
}

/// The dashpot: with F = K d^n and W = K d^(n+1) / (n+1), c = 2 z F sqrt(m / (2
/// W)) makes of every n the same damped oscillator, that of n = 1 (Antypov and
/// Elliott 2011 for n = 3/2).
SolidContactLaw::Normal SolidContactLaw::normal_part(const SolidOverlap& overlap,
                                                     double reduced_mass) const {
  const double area = overlap.push.norm();
  Normal n{half_modulus_, half_modulus_ * area,
           Vec3::UnitX(), half_modulus_ * overlap.energy,
           0.0,           half_modulus_ * overlap.stiffness};
  if (!(area > 0.0)) return n;
  n.direction = -overlap.push / area;
  // No force grows faster than the stiffness, so the energy is at least F^2 /
  // (2 k): that holds where rounding leaves nothing of the integral.
  const double least = 0.5 * n.force * n.force / n.stiffness;
  n.slowness = 2.0 * damping_ratio_ * std::sqrt(0.5 * reduced_mass / std::max(n.energy, least));
  return n;
}

/// Elastic force and dashpots, of the closing speed all over the pressed
/// surface, so that rocking is damped too. Total normal force [N].
double SolidContactLaw::press(const SolidOverlap& overlap, const SolidMotion& motion,
                              const Normal& normal, SolidResponse& response, double time_step) {
  const Vec3 &n = normal.direction, &at = overlap.point;
  const double closing = motion.at(at).dot(n);
  // Rock does not stick: the dashpot may cancel the spring, never pull.
  const double damped = normal.force * std::max(-1.0, normal.slowness * closing);
  // The closing speed grows by slope.r; it moves the centre of pressure, within
  // the surface.
  const Vec3 slope = n.cross(motion.spin_first - motion.spin_second);
  Vec3 moved = normal.slowness * (overlap.spread * slope);
  const double far = moved.norm();
  if (far > overlap.arm) moved *= overlap.arm / far;
  response.dashpot_force = -damped * n;
  response.dashpot_moment = -(damped * at + normal.force * moved).cross(n);
  response.force = normal.modulus * overlap.push + response.dashpot_force;
  response.moment = normal.modulus * overlap.moment + response.dashpot_moment;
  response.elastic_energy = normal.energy;
  response.damping_loss = time_step * (damped * closing + normal.force * moved.dot(slope));
  return normal.force + damped;
}

SolidResponse SolidContactLaw::evaluate(const SolidOverlap& overlap, const SolidMotion& motion,
                                        double time_step, ContactState& state) const {
  SolidResponse response;
  const Normal normal = normal_part(overlap, motion.reduced_mass);
  const double force = press(overlap, motion, normal, response, time_step);

  const Vec3& n = normal.direction;
  const double stiffness = tangential_ratio_ * normal.stiffness;
  const double damping = std::sqrt(tangential_ratio_) * normal.slowness * normal.force;
  const double limit = friction_ * force, squared_arm = motion.twist_arm * motion.twist_arm;
  const Vec3 speed = motion.at(overlap.point), spin = motion.spin_first - motion.spin_second;
  const Vec3 slide = with_length_of(state.slide - state.slide.dot(n) * n, state.slide);
  const Vec3 twist = with_length_of(state.roll.dot(n) * n, state.roll);
  const double before = state.tangential_stiffness;
  const Friction shear =
      stick_or_slip(slide, speed - speed.dot(n) * n, before, stiffness, damping, limit, time_step);
  const Friction turn =
      stick_or_slip(twist, spin.dot(n) * n, squared_arm * before, squared_arm * stiffness,
                    squared_arm * damping, limit * overlap.arm, time_step);
  response.force += shear.damped;
  response.moment += overlap.point.cross(shear.damped) + turn.damped;
  const Vec3 drag = shear.damped - shear.pull, torque = turn.damped - turn.pull;
  response.dashpot_force += drag;
  response.dashpot_moment += overlap.point.cross(drag) + torque;
  response.damping_loss -= time_step * (drag.dot(speed) + torque.dot(spin));
  response.elastic_energy += shear.energy + turn.energy;
  response.friction_loss = shear.loss + turn.loss;
  state = {shear.stretch, turn.stretch, state.overlap_offset, stiffness};
  return response;
}

SolidResistance SolidContactLaw::resistance(const SolidOverlap& overlap,
                                            const SolidMotion& motion) const {
  const Normal normal = normal_part(overlap, motion.reduced_mass);
  SolidResistance r;
  const double damping = normal.slowness * normal.force;
  r.springs.normal_stiffness = normal.stiffness;
  r.springs.tangential_stiffness = tangential_ratio_ * normal.stiffness;
  r.springs.normal_damping = damping;
  r.springs.tangential_damping = std::sqrt(tangential_ratio_) * damping;
  r.normal = normal.direction;
  r.point = overlap.point;
  r.spread = std::sqrt(overlap.mean_square);
  r.twist_arm = motion.twist_arm;
  return r;
}

double SolidContactLaw::stable_time_step(double mass, double stiffest) const {
  constexpr double kShareOfPeriod = 0.2;
  return kShareOfPeriod * std::sqrt(mass / (2.0 * half_modulus_ * stiffest));
}

}  // namespace muckpile
