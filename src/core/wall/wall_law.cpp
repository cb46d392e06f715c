// SPDX-License-Identifier: GPL-2.0-or-later
// Force of a wall on a sphere.
// Scope: see the header.
#include "wall/wall_law.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muckpile {
namespace {

/// As between spheres.
double arm_length(double radius, double overlap) { return std::max(0.0, radius - 0.5 * overlap); }

/// Two spheres of twice the radius have the sphere's own as reduced radius, and their linear spring
/// is that of half a bar of two such spheres: E pi R, twice as stiff as between two spheres.
ContactMotion motion_at(const WallSphere& sphere, const Vec3& normal, double overlap, double arm) {
  return {-normal,
          overlap,
          2.0 * sphere.radius,
          2.0 * sphere.radius,
          sphere.mass,
          sphere.velocity - arm * sphere.spin.cross(normal),
          sphere.spin};
}

/// Moves the memory for a touch to place k of `contacts`; false: there is none, and there is a new
/// place.
bool recall(const WallTouch& touch, std::size_t k, std::vector<WallContact>& contacts) {
  std::size_t best = k;
  double likeness = WallTouches::kSameTouch;
  for (std::size_t j = k; j < contacts.size(); ++j) {
    const double like = contacts[j].normal.dot(touch.normal);
    if (like > likeness) best = j, likeness = like;
  }
  if (likeness > WallTouches::kSameTouch)
    std::swap(contacts[k], contacts[best]);
  else
    contacts.insert(contacts.begin() + static_cast<std::ptrdiff_t>(k), WallContact{});
  contacts[k].normal = touch.normal;
  contacts[k].overlap = touch.overlap;
  return likeness > WallTouches::kSameTouch;
}

}  // namespace

double modulus_against(double rock_modulus, double ground_modulus) {
  return 2.0 / (1.0 / rock_modulus + 1.0 / ground_modulus);
}

WallPush WallLaw::push(const WallSphere& sphere, const WallTouches& touches, double time_step,
                       double memory_step, std::vector<WallContact>& contacts) const {
  WallPush sum;
  std::size_t k = 0;
  for (const WallTouch& touch : touches.all()) {
    const bool known = recall(touch, k, contacts);
    WallContact& contact = contacts[k++];
    const double arm = arm_length(sphere.radius, touch.overlap);
    const ContactMotion motion = motion_at(sphere, touch.normal, touch.overlap, arm);
    if (!known) contact.state = ContactLaw::begin_contact(motion, time_step);
    const double before = contact.state.tangential_stiffness;
    const ContactResponse response = law_.evaluate(motion, memory_step, contact.state);
    const Twist twist = turn(memory_step * sphere.spin.dot(touch.normal), before,
                             response.force_on_first.dot(touch.normal), sphere.radius, contact);
    sum.force += response.force_on_first;
    sum.torque += response.torque_on_first - arm * touch.normal.cross(response.force_on_first) +
                  twist.torque * touch.normal;
    sum.elastic += response.elastic_energy + twist.elastic;
    sum.friction += response.friction_loss + twist.friction;
    sum.damping += response.damping_loss;
    sum.largest_overlap_ratio = std::max(sum.largest_overlap_ratio, touch.overlap / sphere.radius);
  }
  sum.contacts = static_cast<int>(k);
  contacts.resize(k);
  return sum;
}

/// The rolling spring of ContactLaw about the normal: as stiff, and with the same limit.
WallLaw::Twist WallLaw::turn(double angle, double stiffness_before, double normal_force,
                             double radius, WallContact& contact) const {
  if (torsion_friction_ == 0.0) return {};
  const double squared = radius * radius, after = contact.state.tangential_stiffness;
  const double old_stiffness = stiffness_before * squared, stiffness = after * squared;
  const double old_twist = contact.twist;
  const bool grew = after > stiffness_before && stiffness_before > 0.0;
  const double trial = (grew ? stiffness_before / after : 1.0) * old_twist + angle;
  const double limit = torsion_friction_ * radius * normal_force;
  contact.twist = stiffness > 0.0 ? std::clamp(trial, -limit / stiffness, limit / stiffness) : 0.0;
  const double torque = -stiffness * contact.twist;
  const double energy = 0.5 * stiffness * contact.twist * contact.twist;
  const double old_energy = 0.5 * old_stiffness * old_twist * old_twist;
  const double taken = 0.5 * (old_stiffness * old_twist - torque) * angle;
  return {torque, energy, taken - (energy - old_energy)};
}

ContactResistance WallLaw::resistance(const WallSphere& sphere, const WallContact& contact) const {
  const double arm = arm_length(sphere.radius, contact.overlap);
  ContactResistance of_contact =
      law_.resistance(motion_at(sphere, contact.normal, contact.overlap, arm), contact.state);
  if (torsion_friction_ > 0.0) of_contact.torsional_stiffness = of_contact.rolling_stiffness;
  return of_contact;
}

Vec3 WallLaw::arm(double radius, const WallContact& contact) {
  return -arm_length(radius, contact.overlap) * contact.normal;
}

}  // namespace muckpile
