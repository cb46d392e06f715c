// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: the loop over contacts of each step.
// Scope: the contacts themselves are core's.
#include <atom.h>
#include <update.h>

#include "fixes/contact/pair_muckpile_block.h"
#include "fixes/contact/solid_parts.h"

namespace muckpile {

MovingSpheres PairMuckpileBlock::moving_spheres() {
  return {atom->x[0],         atom->v[0],
          atom->omega[0],     atom->radius,
          atom->rmass,        atom->f[0],
          atom->torque[0],    atom->nlocal,
          atom_block_.data(), loads_.empty() ? nullptr : loads_.data()};
}

void PairMuckpileBlock::step_contacts() {
  last_ = {};
  begin_loads();
  if (solids_ != nullptr) solids_->blocks.update(engine::Bodies(*bodies_));
  if (list_.block_pairs().empty()) return;
  // Set-up of a run computes the forces of a state that a step has already reached.
  const double memory_step = update->setupflag != 0 ? 0.0 : update->dt;
  activate_parted_pairs();
  if (solids_ != nullptr) return step_solids(memory_step);
  forces_.begin(*law_, moving_spheres(), contacts_, update->dt, memory_step);
  awake_.clear();
  const SphereSet all = spheres();
  for (const std::size_t k : working_)
    if (list_.wake(k, all, contacts_.free())) awake_.push_back(k);
  // Only now, as a look moves the lists of spheres.
  for (const std::size_t k : awake_)
    if (!forces_.add(list_.candidates(k))) list_.rest(k, all.positions);
  last_ = forces_.finish();
  add_losses(memory_step);
}

void PairMuckpileBlock::add_losses(double memory_step) {
  if (memory_step == 0.0) return;
  losses_.friction += last_.friction;
  if (!watched_) losses_.damping += last_.damping;  // else end_step() knows better
}

}  // namespace muckpile
