// SPDX-License-Identifier: GPL-2.0-or-later
// Force between two touching spheres: normal (Hertz or linear), friction with history, rolling.
// Scope: pure functions of the motion at one contact and its stored state; SI units. No cohesion.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/contact_step_bound.h"
#include "math/types.h"

namespace muckpile {

enum class NormalModel { hertz, linear };

/// Material of both spheres; all blocks are of one rock.
struct ContactParameters {
  NormalModel model = NormalModel::hertz;
  double youngs_modulus = 5e8;    ///< [Pa], > 0
  double poisson_ratio = 0.25;    ///< [-], -1 < nu < 0.5
  double restitution = 0.2;       ///< [-], 0.05 to 1: speed after / before a head-on impact
  double friction = 0.6;          ///< [-], >= 0: Coulomb coefficient
  double rolling_friction = 0.1;  ///< [-], >= 0: limit torque / (reduced radius * normal force)
};

/// What the contact law needs to know of the motion. `first` and `second` are the two spheres;
/// the caller orders them by atom tag, so that both ranks of a shared contact compute the same.
struct ContactMotion {
  Vec3 normal;             ///< unit vector from the first to the second centre
  double overlap;          ///< radius sum minus distance of the centres [m]
  double radius_first;     ///< [m]
  double radius_second;    ///< [m]
  double reduced_mass;     ///< m1 m2 / (m1 + m2) of the two BLOCKS [kg]
  Vec3 relative_velocity;  ///< of the first against the second at the contact point [m/s]
  Vec3 relative_spin;      ///< angular velocity of the first minus that of the second [rad/s]
};

/// What a contact remembers from step to step.
struct ContactState {
  Vec3 slide = Vec3::Zero();          ///< elongation of the tangential spring [m]
  Vec3 roll = Vec3::Zero();           ///< angle of the rolling spring [rad]
  double overlap_offset = 0.0;        ///< overlap that carries no force [m]
  double tangential_stiffness = 0.0;  ///< of the last step [N/m]; 0 for a new contact
};

struct ContactResponse {
  Vec3 force_on_first;    ///< [N]; the second gets the opposite, at the same point
  Vec3 torque_on_first;   ///< of the rolling spring only [N m]; the second gets the opposite
  double elastic_energy;  ///< stored in the three springs [J]
  double friction_loss;   ///< by sliding and rolling in this step [J]
  double damping_loss;    ///< by the dashpots in this step [J]
};

class ContactLaw {
 public:
  /// Throws InputError for a value out of range.
  explicit ContactLaw(const ContactParameters& parameters);

  /// Force of this step; `state` is taken to the end of the step. `time_step` [s] may be 0
  /// (forces of an unchanged state). A contact seen for the first time must pass through
  /// `begin_contact` before.
  [[nodiscard]] ContactResponse evaluate(const ContactMotion& motion, double time_step,
                                         ContactState& state) const;

  /// State of a new contact. Where the spheres overlapped already one step ago (a facet between
  /// two blocks has just been retired, or they were created so), the overlap is stored as offset:
  /// the contact starts without force and no energy is injected. `time_step` [s] as of the run.
  [[nodiscard]] static ContactState begin_contact(const ContactMotion& motion, double time_step);

  /// Slope of the elastic normal force at an overlap [N/m].
  [[nodiscard]] double normal_stiffness(double radius_first, double radius_second,
                                        double overlap) const;

  /// Springs and dashpots of a contact, sticking, for the time step that it bears.
  [[nodiscard]] ContactResistance resistance(const ContactMotion& motion,
                                             const ContactState& state) const;

  /// Dashpot strength: damping ratio of the equivalent linear oscillator [-].
  [[nodiscard]] double damping_ratio() const { return damping_ratio_; }

  /// Largest sensible time step [s] of a block of this mass [kg] that touches with a sphere of
  /// this radius [m]: a fifth of sqrt(m / k), k at an overlap of 5 % of the radius against a plane.
  [[nodiscard]] double stable_time_step(double mass, double radius) const;

 private:
  struct Normal {
    double elastic_force;         ///< [N]
    double energy;                ///< [J]
    double damping;               ///< [N s/m]
    double tangential_stiffness;  ///< [N/m]
  };
  [[nodiscard]] Normal normal_part(const ContactMotion& motion, double reduced_radius,
                                   double overlap) const;
  [[nodiscard]] double linear_stiffness(double radius_first, double radius_second) const;

  NormalModel model_;
  double young_star_;        ///< E / (2 (1 - nu^2)) [Pa]
  double shear_star_;        ///< G / (2 (2 - nu)) [Pa]
  double youngs_modulus_;    ///< [Pa]
  double tangential_ratio_;  ///< k_t / k_n of the linear model (Mindlin) [-]
  double damping_ratio_;     ///< [-]
  double friction_;          ///< [-]
  double rolling_friction_;  ///< [-]
};

/// Restitution of a contact with this damping ratio that never pulls: the contact ends when its
/// force reaches zero. Linear: Schwager and Poeschel, Granular Matter 9 (2007) 465, eq. 19, here in
/// the shorter form exp(-2 z acos(z) / sqrt(1 - z^2)). The Hertz contact with a dashpot
/// proportional to overlap^(1/4) (Tsuji et al., Powder Technology 71 (1992) 239) maps onto it
/// exactly with y = overlap^(5/4) (Antypov and Elliott, EPL 94 (2011) 50004).
[[nodiscard]] double restitution_of(double damping_ratio);

/// Inverse of restitution_of for 0.05 <= restitution <= 1.
[[nodiscard]] double damping_ratio_for(double restitution);

/// Springs follow the tangent plane as it turns: the normal part is removed, the length kept.
[[nodiscard]] inline Vec3 turned_into_plane(const Vec3& spring, const Vec3& normal) {
  const double before = spring.squaredNorm();
  if (before == 0.0) return spring;
  const Vec3 in_plane = spring - spring.dot(normal) * normal;
  const double after = in_plane.squaredNorm();
  if (after <= 1e-12 * before) return Vec3::Zero();  // along the normal: no direction left
  return in_plane * std::sqrt(before / after);
}

inline ContactState ContactLaw::begin_contact(const ContactMotion& motion, double time_step) {
  ContactState state;
  const double one_step_ago =
      motion.overlap - time_step * motion.relative_velocity.dot(motion.normal);
  if (one_step_ago > 0.0) state.overlap_offset = motion.overlap;
  return state;
}

inline double ContactLaw::linear_stiffness(double radius_first, double radius_second) const {
  constexpr double kPi = 3.14159265358979323846;
  const double least = std::min(radius_first, radius_second);
  return youngs_modulus_ * kPi * least * least / (radius_first + radius_second);
}

inline ContactLaw::Normal ContactLaw::normal_part(const ContactMotion& motion,
                                                  double reduced_radius, double overlap) const {
  if (model_ == NormalModel::linear) {
    const double stiffness = linear_stiffness(motion.radius_first, motion.radius_second);
    return {stiffness * overlap, 0.5 * stiffness * overlap * overlap,
            2.0 * damping_ratio_ * std::sqrt(stiffness * motion.reduced_mass),
            tangential_ratio_ * stiffness};
  }
  const double contact_radius = std::sqrt(reduced_radius * overlap);  // [m]
  const double slope = 2.0 * young_star_ * contact_radius;            // dF/d(overlap) [N/m]
  constexpr double kTsuji = 1.8257418583505538;                       // 2 sqrt(5/6)
  return {(2.0 / 3.0) * slope * overlap, (4.0 / 15.0) * slope * overlap * overlap,
          kTsuji * damping_ratio_ * std::sqrt(slope * motion.reduced_mass),
          8.0 * shear_star_ * contact_radius};
}

inline ContactResponse ContactLaw::evaluate(const ContactMotion& motion, double time_step,
                                            ContactState& state) const {
  const double reduced_radius =
      motion.radius_first * motion.radius_second / (motion.radius_first + motion.radius_second);
  state.overlap_offset = std::min(state.overlap_offset, motion.overlap);
  const Normal normal = normal_part(motion, reduced_radius, motion.overlap - state.overlap_offset);
  const double closing_speed = motion.relative_velocity.dot(motion.normal);
  // Rock does not stick: the dashpot may cancel the spring, never pull.
  const double normal_force = std::max(0.0, normal.elastic_force + normal.damping * closing_speed);

  // A spring whose stiffness grows keeps its force, one whose stiffness falls keeps its length:
  // either way its energy only falls (Elata and Berryman, Mech. Mater. 24 (1996) 229).
  const double stiffness = normal.tangential_stiffness;
  const double before = state.tangential_stiffness;
  const double shrink = stiffness > before && before > 0.0 ? before / stiffness : 1.0;
  const double rolling_stiffness = stiffness * reduced_radius * reduced_radius;
  const double old_energy =
      0.5 * before *
      (state.slide.squaredNorm() + reduced_radius * reduced_radius * state.roll.squaredNorm());
  Vec3 slide = shrink * turned_into_plane(state.slide, motion.normal);
  Vec3 roll = shrink * turned_into_plane(state.roll, motion.normal);
  double friction_loss = old_energy - 0.5 * stiffness * slide.squaredNorm() -
                         0.5 * rolling_stiffness * roll.squaredNorm();

  const Vec3 sliding = motion.relative_velocity - closing_speed * motion.normal;
  slide += time_step * sliding;
  const double limit = friction_ * normal_force;
  Vec3 tangential = -stiffness * slide;
  const double trial = tangential.norm();
  double damping_loss = (normal_force - normal.elastic_force) * closing_speed * time_step;
  if (trial > limit) {  // slips: what the spring cannot take is lost
    const double keep = limit / trial;
    friction_loss += limit * (1.0 - keep) * slide.norm();
    slide *= keep;
    tangential *= keep;
  } else {
    constexpr double kTsuji = 1.8257418583505538;
    const double damping = kTsuji * damping_ratio_ * std::sqrt(stiffness * motion.reduced_mass);
    Vec3 damped = tangential - damping * sliding;
    const double size = damped.norm();
    if (size > limit) damped *= limit / size;
    damping_loss += (tangential - damped).dot(sliding) * time_step;
    tangential = damped;
  }

  // Elastic-plastic rolling spring, stiffness k_t R*^2: Ai et al., Powder Technology 206 (2011)
  // 269, model C; Wensrich and Katterfeld, Powder Technology 217 (2012) 409.
  const Vec3 rolling =
      motion.relative_spin - motion.relative_spin.dot(motion.normal) * motion.normal;
  roll += time_step * rolling;
  Vec3 torque = -rolling_stiffness * roll;
  const double torque_limit = rolling_friction_ * reduced_radius * normal_force;
  const double trial_torque = torque.norm();
  if (trial_torque > torque_limit) {
    const double keep = torque_limit / trial_torque;
    friction_loss += torque_limit * (1.0 - keep) * roll.norm();
    roll *= keep;
    torque *= keep;
  }

  state.slide = slide;
  state.roll = roll;
  state.tangential_stiffness = stiffness;
  return {tangential - normal_force * motion.normal, torque,
          normal.energy + 0.5 * stiffness * slide.squaredNorm() +
              0.5 * rolling_stiffness * roll.squaredNorm(),
          friction_loss, damping_loss};
}

}  // namespace muckpile
