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

/// As between spheres: the length of the spring is kept.
Vec3 turned_into_plane(const Vec3& spring, const Vec3& normal) {
  const Vec3 in_plane = spring - spring.dot(normal) * normal;
  const double before = spring.norm(), after = in_plane.norm();
  return after > 1e-6 * before ? Vec3(before / after * in_plane) : Vec3::Zero();
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

WallLaw::WallLaw(const ContactParameters& parameters, bool torsion) : law_(parameters) {
  if (!torsion) return;
  ContactParameters without_rolling = parameters;
  without_rolling.rolling_friction = 0.0;
  law_ = ContactLaw(without_rolling);
  turning_friction_ = parameters.rolling_friction;
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
    const WallContact before = contact;
    if (turning_friction_ > 0.0) contact.state.roll.setZero();  // its energy is counted by turn()
    const ContactResponse response = law_.evaluate(motion, memory_step, contact.state);
    const Turn turned = turn(before, memory_step * sphere.spin,
                             response.force_on_first.dot(touch.normal), sphere.radius, contact);
    sum.force += response.force_on_first;
    sum.torque += response.torque_on_first - arm * touch.normal.cross(response.force_on_first) +
                  turned.torque;
    sum.elastic += response.elastic_energy + turned.elastic;
    sum.friction += response.friction_loss + turned.friction;
    sum.damping += response.damping_loss;
    sum.largest_overlap_ratio = std::max(sum.largest_overlap_ratio, touch.overlap / sphere.radius);
  }
  sum.contacts = static_cast<int>(k);
  contacts.resize(k);
  return sum;
}

/// The rolling spring of ContactLaw with the spin about the normal in it. Of all torques within the
/// limit that is the one which takes most from the spin, so its direction is that of the spring.
WallLaw::Turn WallLaw::turn(const WallContact& before, const Vec3& angle, double normal_force,
                            double radius, WallContact& contact) const {
  if (turning_friction_ == 0.0) return {};
  const Vec3& normal = contact.normal;
  const double first = before.state.tangential_stiffness, last = contact.state.tangential_stiffness;
  const double old_stiffness = first * radius * radius, stiffness = last * radius * radius;
  const Vec3 old = turned_into_plane(before.state.roll, normal) + before.twist * normal;
  const Vec3 trial = (last > first && first > 0.0 ? first / last : 1.0) * old + angle;
  const double pull = stiffness * trial.norm(), limit = turning_friction_ * radius * normal_force;
  const Vec3 kept = (pull > limit ? limit / pull : 1.0) * trial;
  contact.twist = kept.dot(normal);
  contact.state.roll = kept - contact.twist * normal;
  const double energy = 0.5 * stiffness * kept.squaredNorm();
  const double old_energy = 0.5 * old_stiffness * old.squaredNorm();
  const double taken = 0.5 * (old_stiffness * old + stiffness * kept).dot(angle);
  return {-stiffness * kept, energy, taken - (energy - old_energy)};
}

ContactResistance WallLaw::resistance(const WallSphere& sphere, const WallContact& contact) const {
  const double arm = arm_length(sphere.radius, contact.overlap);
  ContactResistance of_contact =
      law_.resistance(motion_at(sphere, contact.normal, contact.overlap, arm), contact.state);
  if (turning_friction_ > 0.0) of_contact.torsional_stiffness = of_contact.rolling_stiffness;
  return of_contact;
}

Vec3 WallLaw::arm(double radius, const WallContact& contact) {
  return -arm_length(radius, contact.overlap) * contact.normal;
}

}  // namespace muckpile
