// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: energies, steps and counts that other styles and scripts ask for.
// Scope: values of this rank.
#include <atom.h>
#include <domain.h>
#include <fix_multisphere.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "contact/contact_step_bound.h"
#include "engine/bodies.h"
#include "engine/particle_vectors.h"
#include "pair_muckpile_block.h"

namespace muckpile {

/// Of contacts that may come: one, with a small overlap, per sphere.
double PairMuckpileBlock::step_of_light_contacts() const {
  double step = std::numeric_limits<double>::infinity();
  for (int k = 0; k < atom->nlocal; ++k)
    step = std::min(step, law_->stable_time_step(atom->rmass[k], atom->radius[k]));
  return step;
}

ContactStepBound PairMuckpileBlock::present_contacts() {
  const engine::Bodies bodies(*bodies_);
  ContactStepBound bound;
  for (const BlockPair& block_pair : list_.block_pairs())
    for (const SpherePair& pair : near_spheres(block_pair)) {
      if (pair.contact < 0) continue;
      const Vec3 first = engine::vector_of(atom->x[0], pair.first);
      const Vec3 between = engine::vector_of(atom->x[0], pair.second) - first;
      ContactMotion motion{};
      motion.overlap = pair.reach - between.norm();
      motion.radius_first = atom->radius[pair.first];
      motion.radius_second = atom->radius[pair.second];
      const double m1 = atom->rmass[pair.first], m2 = atom->rmass[pair.second];
      motion.reduced_mass = m1 * m2 / (m1 + m2);
      const ContactResistance resistance =
          law_->resistance(motion, contacts_[static_cast<std::size_t>(pair.contact)]);
      const Vec3 point = first + (motion.radius_first / pair.reach) * between;
      for (const bool second : {false, true}) {
        const int body =
            bodies_->data().map(bodies_->belongs_to(second ? pair.second : pair.first));
        if (body < 0) continue;  // the other rank's
        Vec3 arm = point - bodies.centre(body);
        domain->minimum_image(arm.x(), arm.y(), arm.z());
        bound.add(static_cast<std::size_t>(body),
                  {bodies.mass(body), bodies.inertia_in_space(body)}, resistance,
                  between.normalized(), arm, second ? m1 : m2);
      }
    }
  return bound;
}

double PairMuckpileBlock::resting_energy() {
  double energy = 0.0;
  const AtomArrays atoms = arrays();
  for (const std::size_t k : left_alone_)
    for (const SpherePair& pair : near_spheres(list_.block_pairs()[k])) {
      if (pair.contact < 0) continue;
      const Vec3 to_second =
          engine::vector_of(atoms.x, pair.second) - engine::vector_of(atoms.x, pair.first);
      ContactState state = contacts_[static_cast<std::size_t>(pair.contact)];
      const double share = pair.first < atoms.owned && pair.second < atoms.owned ? 1.0 : 0.5;
      energy +=
          share * law_->evaluate(motion_of(pair, to_second, to_second.norm(), atoms), 0.0, state)
                      .elastic_energy;
    }
  return energy;
}

void* PairMuckpileBlock::extract(const char* name, int& dim) {
  dim = 0;
  const std::string_view key(name);
  if (key == "elastic_J") {
    ledger_.all_elastic_J = ledger_.elastic_J + resting_energy();
    return &ledger_.all_elastic_J;
  }
  if (key == "friction_J") return &losses_.friction;
  if (key == "damping_J") return &losses_.damping;
  if (key == "power_W") return &ledger_.power_W;
  if (key == "contacts") return &ledger_.contacts;
  if (key == "max_overlap_ratio") return &ledger_.max_overlap_ratio;
  if (key == "steps_s") {
    dim = 1;
    const ContactStepBound present = present_contacts();
    ledger_.steps_s = {present.step(), present.spring_step(), step_of_light_contacts()};
    return ledger_.steps_s.data();
  }
  if (key == "rebuild_s") return &ledger_.rebuild_s;
  if (key == "rebuilds") return &ledger_.rebuilds;
  return nullptr;
}

double PairMuckpileBlock::memory_usage() {
  return list_.bytes() + static_cast<double>(contacts_.capacity() * sizeof(ContactState));
}

}  // namespace muckpile
