// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: energies, steps and counts that other styles and scripts ask for.
// Scope: values of this rank.
#include <atom.h>
#include <domain.h>
#include <fix_multisphere.h>
#include <modify.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "fixes/contact/pair_muckpile_block.h"
#include "fixes/contact/shared_step_bound.h"
#include "fixes/contact/solid_parts.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/particle_vectors.h"
#include "fixes/interfaces/standing_contacts.h"

namespace muckpile {
namespace {

/// Calls visit() for each fix that blocks touch.
template <class Visit>
void for_walls(const LAMMPS_NS::Modify& modify, const Visit& visit) {
  for (int f = 0; f < modify.nfix; ++f)
    if (const auto* const wall = dynamic_cast<const StandingContacts*>(modify.fix[f])) visit(*wall);
}

}  // namespace

/// Of contacts that may come: one, with a small overlap, per sphere.
double PairMuckpileBlock::step_of_light_contacts() const {
  double step = std::numeric_limits<double>::infinity();
  if (solids_ != nullptr) step = step_of_light_solids();
  for (int k = 0; solids_ == nullptr && k < atom->nlocal; ++k)
    step = std::min(step, law_->stable_time_step(atom->rmass[k], atom->radius[k]));
  for_walls(*modify, [&](const StandingContacts& w) { step = std::min(step, w.light_step()); });
  return step;
}

/// Two spheres as if they did not move.
ContactMotion PairMuckpileBlock::held_still(const SpherePair& pair) const {
  const Vec3 between =
      engine::vector_of(atom->x[0], pair.second) - engine::vector_of(atom->x[0], pair.first);
  const double distance = between.norm();
  const double m1 = atom->rmass[pair.first], m2 = atom->rmass[pair.second];
  return {distance > 0.0 ? Vec3(between / distance) : Vec3::UnitX(),
          pair.reach - distance,
          atom->radius[pair.first],
          atom->radius[pair.second],
          m1 * m2 / (m1 + m2),
          Vec3::Zero(),
          Vec3::Zero()};
}

ContactStepBound PairMuckpileBlock::bodies_without_contacts() const {
  const engine::Bodies bodies(*bodies_);
  std::vector<char> joined(static_cast<std::size_t>(bodies.count()), 0);
  if (joints_ != nullptr) joints_->mark_joined_bodies(joined);
  std::vector<ContactStepBound::Body> all;
  all.reserve(joined.size());
  for (int b = 0; b < bodies.count(); ++b)
    all.push_back({bodies.mass(b), bodies.inertia(b), bodies.axes(b),
                   joined[static_cast<std::size_t>(b)] != 0});
  return ContactStepBound(std::move(all));
}

/// Contacts of this rank's own spheres; each contact counts for both of its spheres, so what two
/// ranks share counts once for either.
ContactStepBound PairMuckpileBlock::present_contacts() {
  SharedStepBound shared(*bodies_, *domain, bodies_without_contacts());
  if (solids_ != nullptr) solids_->blocks.update(engine::Bodies(*bodies_));  // since the last act
  for (const BlockPair& block_pair : list_.block_pairs())
    for (const SpherePair& pair : near_spheres(block_pair)) {
      if (pair.contact < 0) continue;
      if (solids_ != nullptr) {
        add_solid_contact(shared, pair);
        continue;
      }
      const ContactMotion motion = held_still(pair);
      const ContactResistance resistance = law_->resistance(motion, contacts_[pair.contact]);
      const double inside = motion.radius_first * (1.0 - motion.overlap / pair.reach);
      const Vec3 point = engine::vector_of(atom->x[0], pair.first) + inside * motion.normal;
      const auto add = [&](int sphere, int other) {
        if (sphere < atom->nlocal)
          shared.add(bodies_->belongs_to(sphere),
                     {resistance, motion.normal, point, atom->rmass[other]});
      };
      add(pair.first, pair.second);
      add(pair.second, pair.first);
    }
  add_walls(shared);
  return shared.of_all_ranks(world);
}

/// What stands still is a body without end.
void PairMuckpileBlock::add_walls(SharedStepBound& shared) const {
  const auto take = [&](int sphere, const StandingContact& contact) {
    shared.add(bodies_->belongs_to(sphere), {contact.resistance, contact.normal, contact.point,
                                             std::numeric_limits<double>::infinity()});
  };
  for_walls(*modify, [&](const StandingContacts& wall) { wall.visit_contacts(take); });
}

double PairMuckpileBlock::resting_energy() {
  double energy = 0.0;
  for (const std::size_t k : left_alone_)
    for (const SpherePair& pair : near_spheres(list_.block_pairs()[k])) {
      if (pair.contact < 0) continue;
      ContactState state = contacts_[pair.contact];
      const bool shared = pair.first >= atom->nlocal || pair.second >= atom->nlocal;
      energy += (shared ? 0.5 : 1.0) *
                (solids_ != nullptr ? solid_energy(pair)
                                    : law_->evaluate(held_still(pair), 0.0, state).elastic_energy);
    }
  return energy;
}

void* PairMuckpileBlock::extract(const char* name, int& dim) {
  dim = 0;
  const std::string_view key(name);
  if (key == "elastic_J") {
    ledger_.all_elastic_J = last_.elastic + resting_energy();
    return &ledger_.all_elastic_J;
  }
  if (key == "friction_J") return &losses_.friction;
  if (key == "damping_J") return &losses_.damping;
  if (key == "contacts") return &last_.contacts;
  if (key == "max_overlap_ratio") return &last_.largest_overlap_ratio;
  if (key == "steps_s") {
    dim = 1;
    const ContactStepBound bound = present_contacts();
    const ContactStepBound::Steps free = bound.steps(false), joined = bound.steps(true);
    ledger_.steps_s = {free.with_dashpots, free.springs, joined.with_dashpots, joined.springs,
                       step_of_light_contacts()};
    return ledger_.steps_s.data();
  }
  if (key == "rebuild_s") return &ledger_.rebuild_s;
  if (key == "rebuilds") return &ledger_.rebuilds;
  return nullptr;
}

}  // namespace muckpile
