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

/// Set-up of a run computes the forces of a state that a step has already reached.
ContactPace::Act PairMuckpileBlock::act_of_step() {
  if (update->setupflag == 0) return pace_.go_on(update->ntimestep, update->dt);
  return {pace_.strength(), update->dt};
}

bool PairMuckpileBlock::act_for_several() const { return pace_.strength() > 1.0; }

/// There are no other forces on spheres yet. A set-up at a step without an act leaves none, but the
/// energies.
void PairMuckpileBlock::strengthen() {
  if (act_.strength == 1.0 || atom->nlocal == 0) return;
  const std::size_t numbers = 3 * static_cast<std::size_t>(atom->nlocal);
  for (double* const forces : {atom->f[0], atom->torque[0]})
    for (std::size_t k = 0; k < numbers; ++k) forces[k] *= act_.strength;
}

void PairMuckpileBlock::step_contacts() {
  last_ = {};
  if (solids_ != nullptr) solids_->blocks.update(engine::Bodies(*bodies_));
  if (list_.block_pairs().empty()) return;
  const double memory_step = update->setupflag != 0 ? 0.0 : act_.elapsed;
  activate_parted_pairs();
  if (solids_ != nullptr) {
    step_solids(memory_step);
    return strengthen();
  }
  forces_.begin(*law_, moving_spheres(), contacts_, act_.elapsed, memory_step);
  awake_.clear();
  const SphereSet all = spheres();
  for (const std::size_t k : working_)
    if (list_.wake(k, all, contacts_.free())) awake_.push_back(k);
  // Only now, as a look moves the lists of spheres.
  for (const std::size_t k : awake_)
    if (!forces_.add(list_.candidates(k))) list_.rest(k, all.positions);
  last_ = forces_.finish();
  add_losses(memory_step);
  strengthen();
}

void PairMuckpileBlock::add_losses(double memory_step) {
  if (memory_step == 0.0) return;
  losses_.friction += last_.friction;
  if (!watched_) losses_.damping += last_.damping;  // else end_step() knows better
}

}  // namespace muckpile
