// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block, shape polyhedra: the step, and what is asked of a contact.
// Scope: lists, exchange and history are those of spheres, of which one stands for each block.
#include <atom.h>
#include <comm.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "fixes/contact/pair_muckpile_block.h"
#include "fixes/contact/shared_step_bound.h"
#include "fixes/contact/solid_parts.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/style_args.h"

namespace muckpile {

void PairMuckpileBlock::take_shapes() {
  solids_->blocks.plan(*bodies_, block_tag_, world);
  const int missing = engine::sum_over_ranks(solids_->blocks.without_shape(), world);
  if (missing > 0)
    engine::stop(*lmp, std::string(kStyle) +
                           ": shape polyhedra needs the shape of every block, got " +
                           std::to_string(missing) +
                           " without one; give it before create_blocks, or before the run that "
                           "wrote the restart file");
  require_keys();
  solids_->blocks.update(engine::Bodies(*bodies_));
}

void PairMuckpileBlock::require_keys() {
  const engine::Bodies bodies(*bodies_);
  int without = bodies.count();
  for (int k = 0; k < atom->nlocal; ++k) {
    const int tag = bodies_->belongs_to(k);
    const ShapedBlock* const shape = tag < 0 ? nullptr : solids_->shapes->shape(tag);
    if (shape != nullptr && shape->key == atom->tag[k]) --without;
  }
  without = engine::sum_over_ranks(without, world);
  if (without > 0)
    engine::stop(*lmp, std::string(kStyle) +
                           ": shape polyhedra needs the spheres' numbers as create_blocks gave "
                           "them, got " +
                           std::to_string(without) +
                           " blocks with others; use delete_atoms with 'compress no'");
}

void PairMuckpileBlock::step_solids(double memory_step) {
  SolidParts& solids = *solids_;
  const engine::Bodies bodies(*bodies_);
  const SphereSet all = spheres();
  solids.axes.resize(list_.block_pairs().size(), Vec3::Zero());
  solids.forces.begin(solids.law, moving_spheres(), contacts_, act_.elapsed, memory_step);
  solids.blocks.begin_step();
  const auto body = [&](int key) -> const SolidBody& {
    return solids.blocks.body_of_step(bodies, *atom, atom_block_[static_cast<std::size_t>(key)],
                                      key);
  };
  for (const std::size_t k : working_) {
    if (!list_.wake(k, all, contacts_.free())) continue;
    for (SpherePair& pair : list_.candidates(k)) {
      const double gap =
          solids.forces.add(pair, body(pair.first), body(pair.second), solids.axes[k]);
      if (gap > 0.0) list_.rest(k, gap);
    }
  }
  last_ = solids.forces.finish();
  add_losses(memory_step);
}

double PairMuckpileBlock::solid_energy(const SpherePair& pair) {
  const engine::Bodies bodies(*bodies_);
  const auto body = [&](int key) {
    return solids_->blocks.body(bodies, *atom, atom_block_[static_cast<std::size_t>(key)], key);
  };
  return solids_->look.energy(solids_->law, body(pair.first), body(pair.second),
                              contacts_[pair.contact]);
}

/// Normal springs of a quarter each about its point resist turns as the whole face does, tangential
/// ones of a half each resist spin about the normal as the spring against it does.
void PairMuckpileBlock::add_solid_contact(SharedStepBound& shared, const SpherePair& pair) {
  const engine::Bodies bodies(*bodies_);
  const auto body = [&](int key) {
    return solids_->blocks.body(bodies, *atom, atom_block_[static_cast<std::size_t>(key)], key);
  };
  const SolidResistance whole = solids_->look.resistance(
      solids_->law, body(pair.first), body(pair.second), contacts_[pair.contact]);
  const ContactResistance& s = whole.springs;
  const ContactResistance quarter{0.25 * s.normal_stiffness, 0.0, 0.0, 0.25 * s.normal_damping};
  const ContactResistance half{0.0, 0.5 * s.tangential_stiffness, 0.0, 0.0,
                               0.5 * s.tangential_damping};
  const Vec3 along = whole.normal.unitOrthogonal(), across = whole.normal.cross(along);
  const double out = std::sqrt(2.0) * whole.spread;
  const auto add = [&](const ContactResistance& part, const Vec3& arm) {
    for (const auto& [key, other] :
         {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)})
      if (key < atom->nlocal)
        shared.add(bodies_->belongs_to(key),
                   {part, whole.normal, whole.point + arm, atom->rmass[other]});
  };
  for (const double side : {-1.0, 1.0}) {
    add(quarter, side * out * along);
    add(quarter, side * out * across);
    add(half, side * whole.twist_arm * along);
  }
}

double PairMuckpileBlock::step_of_light_solids() const {
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < static_cast<std::size_t>(atom->nlocal); ++k) {
    if (k >= atom_block_.size() || atom_block_[k] < 0) continue;
    const double stiffest = solids_->blocks.solid(atom_block_[k]).stiffest();
    step = std::min(step, solids_->law.stable_time_step(atom->rmass[k], stiffest));
  }
  return step;
}

const std::vector<int>& PairMuckpileBlock::loaded_blocks() const {
  return solids_ != nullptr ? solids_->forces.loaded() : forces_.loaded();
}

void PairMuckpileBlock::forget_loads() {
  forces_.forget_loads();
  if (solids_ != nullptr) solids_->forces.forget_loads();
}

void PairMuckpileBlock::spoil(double share) {
  forces_.spoil(share);
  if (solids_ != nullptr) solids_->forces.spoil(share);
}

double PairMuckpileBlock::memory_usage() { return list_.bytes() + contacts_.bytes(); }

}  // namespace muckpile
