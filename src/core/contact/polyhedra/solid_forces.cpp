// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of a step between polyhedral blocks.
// Scope: see the header.
#include "contact/polyhedra/solid_forces.h"

#include <algorithm>

namespace muckpile {

void SolidForces::begin(const SolidContactLaw& law, const MovingSpheres& keys,
                        ContactStates& contacts, double time_step, double memory_step) {
  law_ = &law;
  keys_ = keys;
  contacts_ = &contacts;
  time_step_ = time_step;
  memory_step_ = memory_step;
  sums_ = {};
}

double SolidForces::add(SpherePair& pair, const SolidBody& first, const SolidBody& second,
                        Vec3& axis) {
  const bool is_new = pair.contact < 0;
  ContactState state = is_new ? ContactState{} : (*contacts_)[pair.contact];
  SolidResponse response;
  const SolidContact::Outcome outcome =
      contact_.step(*law_, first, second, time_step_, memory_step_, is_new, axis, state, response);
  if (!outcome.lasts) {
    if (!is_new) contacts_->free().push_back(pair.contact);
    pair.contact = -1;
    return outcome.gap;
  }
  if (is_new)
    pair.contact = contacts_->add(state);
  else
    (*contacts_)[pair.contact] = state;
  book(pair, response);
  const Vec3 force = factor_ * response.force, moment = factor_ * response.moment;
  const Vec3 between = second.pose.centre - first.pose.centre;
  push(pair.first, first, force, moment);
  push(pair.second, second, -force, between.cross(force) - moment);
  if (keys_.loads == nullptr) return 0.0;
  const Vec3& centre = first.pose.centre;
  const std::array<Vec3, 4> about_origin{
      force, moment + centre.cross(force), response.dashpot_force,
      response.dashpot_moment + centre.cross(response.dashpot_force)};
  load(pair.first, 1.0, about_origin);
  load(pair.second, -1.0, about_origin);
  return 0.0;
}

void SolidForces::book(const SpherePair& pair, const SolidResponse& response) {
  const double share =
      0.5 * ((pair.first < keys_.owned ? 1.0 : 0.0) + (pair.second < keys_.owned ? 1.0 : 0.0));
  sums_.contacts += share;
  sums_.elastic += share * response.elastic_energy;
  sums_.friction += share * response.friction_loss;
  sums_.damping += share * response.damping_loss;
  sums_.largest_overlap_ratio = std::max(sums_.largest_overlap_ratio, contact_.largest_strain());
}

/// `moment` about the body's centre; the engine takes it about the key.
void SolidForces::push(int key, const SolidBody& body, const Vec3& force, const Vec3& moment) {
  if (key >= keys_.owned) return;
  const std::ptrdiff_t at = 3 * static_cast<std::ptrdiff_t>(key);
  const Vec3 arm = Vec3::Map(keys_.positions + at) - body.pose.centre;
  Vec3::Map(keys_.forces + at) += force;
  Vec3::Map(keys_.torques + at) += moment - arm.cross(force);
}

void SolidForces::load(int key, double sign, const std::array<Vec3, 4>& about_origin) {
  if (key >= keys_.owned) return;
  const int block = keys_.blocks[key];
  ContactLoad& load = keys_.loads[block];
  for (std::size_t k = 0; k < about_origin.size(); ++k)
    Vec3::Map(load.numbers.data() + 3 * k) += sign * about_origin[k];
  if (!load.listed) loaded_.push_back(block);
  load.listed = true;
}

}  // namespace muckpile
