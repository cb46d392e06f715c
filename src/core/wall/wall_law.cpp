// SPDX-License-Identifier: GPL-2.0-or-later
// Force of a wall on a sphere.
// Scope: see the header.
#include "wall/wall_law.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muckpile {
namespace {

/// Two spheres of twice the radius have the sphere's own as reduced radius, and their linear spring
/// is that of half a bar of two such spheres: E pi R, twice as stiff as between two spheres.
ContactMotion motion_at(const WallSphere& sphere, const WallTouch& touch, double arm) {
  return {-touch.normal,       touch.overlap,
          2.0 * sphere.radius, 2.0 * sphere.radius,
          sphere.mass,         sphere.velocity - arm * sphere.spin.cross(touch.normal),
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
    const double arm = std::max(0.0, sphere.radius - 0.5 * touch.overlap);  // as between spheres
    const ContactMotion motion = motion_at(sphere, touch, arm);
    if (!known) contact.state = ContactLaw::begin_contact(motion, time_step);
    const ContactResponse response = law_.evaluate(motion, memory_step, contact.state);
    sum.force += response.force_on_first;
    sum.torque += response.torque_on_first - arm * touch.normal.cross(response.force_on_first);
    sum.elastic += response.elastic_energy;
    sum.friction += response.friction_loss;
    sum.damping += response.damping_loss;
    sum.largest_overlap_ratio = std::max(sum.largest_overlap_ratio, touch.overlap / sphere.radius);
  }
  sum.contacts = static_cast<int>(k);
  contacts.resize(k);
  return sum;
}

}  // namespace muckpile
