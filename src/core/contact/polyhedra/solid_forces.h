// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of a step between polyhedral blocks, as ContactForces has them between
// spheres: one sphere of each block, its key, stands for it. Scope: one rank's
// pairs; SI units. Forces act on the keys of own blocks.
#pragma once

#include <span>
#include <vector>

#include "contact/contact_forces.h"
#include "contact/polyhedra/solid_contact.h"

namespace muckpile {

/// Use: begin(), then add() each pair of keys that are near, then finish().
class SolidForces {
 public:
  /// As ContactForces::begin; `keys` of the blocks are spheres among others.
  void begin(const SolidContactLaw& law, const MovingSpheres& keys, ContactStates& contacts,
             double time_step, double memory_step);
  /// Bodies of the pair's keys. Gap [m] between the two, not above 0 where they
  /// touch or none is found; `axis` as SolidContact::step has it.
  double add(SpherePair& pair, const SolidBody& first, const SolidBody& second, Vec3& axis);
  [[nodiscard]] const ContactSums& finish() const { return sums_; }
  /// As ContactForces has them.
  [[nodiscard]] const std::vector<int>& loaded() const { return loaded_; }
  void forget_loads() { loaded_.clear(); }
  void spoil(double share) { factor_ = 1.0 + share; }

 private:
  void book(const SpherePair& pair, const SolidResponse& response);
  void push(int key, const SolidBody& body, const Vec3& force, const Vec3& moment);
  void load(int key, double sign, const std::array<Vec3, 4>& about_origin);

  const SolidContactLaw* law_ = nullptr;
  MovingSpheres keys_{};
  ContactStates* contacts_ = nullptr;
  double time_step_ = 0.0, memory_step_ = 0.0, factor_ = 1.0;
  SolidContact contact_;
  ContactSums sums_;
  std::vector<int> loaded_;
};

}  // namespace muckpile
