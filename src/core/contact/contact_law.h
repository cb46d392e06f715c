// SPDX-License-Identifier: GPL-2.0-or-later
// Force between two touching spheres: normal (Hertz or linear), friction with history, rolling.
// Scope: pure functions of the motion at one contact, or at one in each lane, and its stored state;
// SI units. No cohesion.
#pragma once

#include <experimental/simd>

#include "contact/contact_step_bound.h"
#include "math/lanes.h"
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

/// What the contact law needs to know of the motion, one contact per lane of Number. `first` and
/// `second` are the two spheres; the caller orders them by atom tag, so that both ranks of a shared
/// contact compute the same.
template <class Number>
struct ContactMotionOf {
  VectorOf<Number> normal;             ///< unit vector from the first to the second centre
  Number overlap;                      ///< radius sum minus distance of the centres [m]
  Number radius_first, radius_second;  ///< [m]
  Number reduced_mass;                 ///< m1 m2 / (m1 + m2) of the two BLOCKS [kg]
  VectorOf<Number> relative_velocity;  ///< of the first against the second at the point [m/s]
  VectorOf<Number> relative_spin;      ///< that of the first minus that of the second [rad/s]
};

/// What a contact remembers from step to step.
template <class Number>
struct ContactStateOf {
  VectorOf<Number> slide;             ///< elongation of the tangential spring [m]
  VectorOf<Number> roll;              ///< angle of the rolling spring [rad]
  Number overlap_offset = 0.0;        ///< overlap that carries no force [m]
  Number tangential_stiffness = 0.0;  ///< of the last step [N/m]; 0 for a new contact
};

template <class Number>
struct ContactResponseOf {
  VectorOf<Number> force_on_first;   ///< [N]; the second gets the opposite, at the same point
  VectorOf<Number> torque_on_first;  ///< of the rolling spring only [N m]; the second: the opposite
  Number elastic_energy;             ///< stored in the three springs [J]
  Number friction_loss;              ///< by sliding and rolling in this step [J]
  Number damping_loss;               ///< by the dashpots in this step [J]
  VectorOf<Number> dashpot_on_first;  ///< part of the force that the dashpots make [N]
};

// The same of one contact.
struct ContactMotion {
  Vec3 normal;
  double overlap, radius_first, radius_second, reduced_mass;
  Vec3 relative_velocity, relative_spin;
};
struct ContactState {
  Vec3 slide = Vec3::Zero(), roll = Vec3::Zero();
  double overlap_offset = 0.0, tangential_stiffness = 0.0;
};
struct ContactResponse {
  Vec3 force_on_first, torque_on_first;
  double elastic_energy, friction_loss, damping_loss;
  Vec3 dashpot_on_first;
};

class ContactLaw {
 public:
  /// Throws InputError for a value out of range.
  explicit ContactLaw(const ContactParameters& parameters);

  /// Force of this step; `state` is taken to the end of the step. `time_step` [s] may be 0
  /// (forces of an unchanged state). A contact seen for the first time must pass through
  /// `begin_contact` before.
  template <class Number>
  [[nodiscard]] ContactResponseOf<Number> evaluate(const ContactMotionOf<Number>& motion,
                                                   double time_step,
                                                   ContactStateOf<Number>& state) const;
  [[nodiscard]] ContactResponse evaluate(const ContactMotion& motion, double time_step,
                                         ContactState& state) const;

  /// State of a new contact. Where the spheres overlapped already one step ago (a facet between
  /// two blocks has just been retired, or they were created so), the overlap is stored as offset:
  /// the contact starts without force and no energy is injected. `time_step` [s] as of the run.
  [[nodiscard]] static ContactState begin_contact(const ContactMotion& motion, double time_step);
  /// Of that state, all of which but this is zero [m].
  template <class Number>
  [[nodiscard]] static Number first_offset(const ContactMotionOf<Number>& motion, double time_step);

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
  template <class Number>
  struct Normal {
    Number elastic_force;         ///< [N]
    Number energy;                ///< [J]
    Number damping;               ///< [N s/m]
    Number tangential_stiffness;  ///< [N/m]
    Number tangential_damping;    ///< [N s/m]
  };
  template <class Number>
  struct Spring {
    VectorOf<Number> stretch;  ///< [m] or [rad]
    VectorOf<Number> pull;     ///< [N] or [N m]
    typename Number::mask_type slips;
  };
  template <class Number>
  [[nodiscard]] Normal<Number> normal_part(const ContactMotionOf<Number>& motion,
                                           const Number& reduced_radius,
                                           const Number& overlap) const;
  template <class Number>
  [[nodiscard]] Number linear_stiffness(const Number& radius_first,
                                        const Number& radius_second) const;
  template <class Number>
  [[nodiscard]] static Spring<Number> limited(const VectorOf<Number>& stretch,
                                              const Number& stiffness, const Number& limit);

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

/// Springs follow the tangent plane as it turns: the normal part is removed, the length kept; of
/// one along the normal nothing is left.
template <class Number>
[[nodiscard, gnu::always_inline]] inline VectorOf<Number> turned_into_plane(
    const VectorOf<Number>& spring, const VectorOf<Number>& normal) {
  const VectorOf<Number> in_plane = spring - dot(spring, normal) * normal;
  const Number before = dot(spring, spring), after = dot(in_plane, in_plane);
  return choose(after > 1e-12 * before, before * inverse_root(before * after), 0.0) * in_plane;
}

template <class Number>
[[gnu::always_inline]] inline Number ContactLaw::first_offset(const ContactMotionOf<Number>& motion,
                                                              double time_step) {
  const Number one_step_ago =
      motion.overlap - time_step * dot(motion.relative_velocity, motion.normal);
  return choose(one_step_ago > 0.0, motion.overlap, 0.0);
}

template <class Number>
[[gnu::always_inline]] inline Number ContactLaw::linear_stiffness(
    const Number& radius_first, const Number& radius_second) const {
  constexpr double kPi = 3.14159265358979323846;
  const Number least = min(radius_first, radius_second);
  return youngs_modulus_ * kPi * least * least / (radius_first + radius_second);
}

template <class Number>
[[gnu::always_inline]] inline ContactLaw::Normal<Number> ContactLaw::normal_part(
    const ContactMotionOf<Number>& motion, const Number& reduced_radius,
    const Number& overlap) const {
  constexpr double kTsuji = 1.8257418583505538;  // 2 sqrt(5/6)
  if (model_ == NormalModel::linear) {
    const Number stiffness = linear_stiffness(motion.radius_first, motion.radius_second);
    const Number critical = root(stiffness * motion.reduced_mass);
    return {stiffness * overlap, 0.5 * stiffness * overlap * overlap,
            2.0 * damping_ratio_ * critical, tangential_ratio_ * stiffness,
            kTsuji * damping_ratio_ * std::sqrt(tangential_ratio_) * critical};
  }
  const Number contact_radius = root(reduced_radius * overlap);  // [m]
  const Number slope = 2.0 * young_star_ * contact_radius;       // dF/d(overlap) [N/m]
  const Number damping = kTsuji * damping_ratio_ * root(slope * motion.reduced_mass);
  const double tangential = 4.0 * shear_star_ / young_star_;  // over the normal slope
  return {(2.0 / 3.0) * slope * overlap, (4.0 / 15.0) * slope * overlap * overlap, damping,
          tangential * slope, std::sqrt(tangential) * damping};
}

/// A spring that bears no more than the limit.
template <class Number>
[[gnu::always_inline]] inline ContactLaw::Spring<Number> ContactLaw::limited(
    const VectorOf<Number>& stretch, const Number& stiffness, const Number& limit) {
  const Number length = root(dot(stretch, stretch)), trial = stiffness * length;
  const auto slips = trial > limit;
  const Number keep = choose(slips, limit / trial, 1.0);
  const VectorOf<Number> kept = keep * stretch;
  return {kept, -stiffness * kept, slips};
}

template <class Number>
[[gnu::always_inline]] inline ContactResponseOf<Number> ContactLaw::evaluate(
    const ContactMotionOf<Number>& motion, double time_step, ContactStateOf<Number>& state) const {
  using Vector = VectorOf<Number>;
  const Number dt = time_step;
  const Number reduced_radius =
      motion.radius_first * motion.radius_second / (motion.radius_first + motion.radius_second);
  state.overlap_offset = min(state.overlap_offset, motion.overlap);
  const Normal<Number> normal =
      normal_part(motion, reduced_radius, motion.overlap - state.overlap_offset);
  const Number closing_speed = dot(motion.relative_velocity, motion.normal);
  // Rock does not stick: the dashpot may cancel the spring, never pull.
  const Number normal_force =
      max(Number(0.0), normal.elastic_force + normal.damping * closing_speed);

  // A spring whose stiffness grows keeps its force, one whose stiffness falls keeps its length:
  // either way its energy only falls (Elata and Berryman, Mech. Mater. 24 (1996) 229).
  const Number stiffness = normal.tangential_stiffness;
  const Number before = state.tangential_stiffness;
  const Number shrink = choose(stiffness > before && before > 0.0, before / stiffness, 1.0);
  const Number squared_radius = reduced_radius * reduced_radius;
  const Number rolling_stiffness = stiffness * squared_radius;
  const Number old_energy =
      0.5 * before * (dot(state.slide, state.slide) + squared_radius * dot(state.roll, state.roll));
  const Vector old_slide = turned_into_plane(state.slide, motion.normal);
  const Vector old_roll = turned_into_plane(state.roll, motion.normal);

  const Vector sliding = motion.relative_velocity - closing_speed * motion.normal;
  const Number limit = friction_ * normal_force;
  const Vector path = dt * sliding;
  const Spring<Number> shear = limited(shrink * old_slide + path, stiffness, limit);
  const Vector damped = shear.pull - normal.tangential_damping * sliding;
  const Number share = min(limit * inverse_root(dot(damped, damped)), Number(1.0));
  const Vector tangential = choose(shear.slips, shear.pull, share * damped);
  const Vector dashpots =
      (tangential - shear.pull) + (normal.elastic_force - normal_force) * motion.normal;

  // Elastic-plastic rolling spring, stiffness k_t R*^2: Ai et al., Powder Technology 206 (2011)
  // 269, model C; Wensrich and Katterfeld, Powder Technology 217 (2012) 409.
  const Vector rolling =
      motion.relative_spin - dot(motion.relative_spin, motion.normal) * motion.normal;
  const Vector turned = dt * rolling;
  const Spring<Number> turn = limited(shrink * old_roll + turned, rolling_stiffness,
                                      rolling_friction_ * reduced_radius * normal_force);
  const Number energy = 0.5 * (stiffness * dot(shear.stretch, shear.stretch) +
                               rolling_stiffness * dot(turn.stretch, turn.stretch));
  // What leapfrog takes from the two blocks along the path of the step, by the mean of the forces
  // before and after it, less what the springs have gained.
  const Number taken = 0.5 * (dot(before * old_slide - shear.pull, path) +
                              dot((before * squared_radius) * old_roll - turn.pull, turned));

  state = {shear.stretch, turn.stretch, state.overlap_offset, stiffness};
  return {tangential - normal_force * motion.normal,
          turn.pull,
          normal.energy + energy,
          taken - (energy - old_energy),
          -dt * dot(dashpots, motion.relative_velocity),
          dashpots};
}

}  // namespace muckpile
