// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: the loop over contacts of each step.
// Scope: the law of one contact is core's.
#include <atom.h>
#include <update.h>

#include <algorithm>
#include <cmath>

#include "engine/particle_vectors.h"
#include "pair_muckpile_block.h"

namespace muckpile {

PairMuckpileBlock::AtomArrays PairMuckpileBlock::arrays() const {
  return {atom->x[0],      atom->v[0],   atom->omega[0], atom->f[0],
          atom->torque[0], atom->radius, atom->rmass,    atom->nlocal};
}

void PairMuckpileBlock::step_contacts() {
  ledger_.elastic_J = ledger_.power_W = ledger_.contacts = ledger_.max_overlap_ratio = 0.0;
  if (list_.block_pairs().empty()) return;
  const AtomArrays atoms = arrays();
  // Set-up of a run computes the forces of a state that a step has already reached.
  const double history_step = update->setupflag != 0 ? 0.0 : update->dt;
  hear_pairs();
  for (const std::size_t k : working_) {
    if (list_.idle(k)) continue;
    BlockPair& pair = list_.block_pairs()[k];
    if (list_.moved(pair)) list_.look_up(pair, spheres(), free_contacts_);
    step_block_pair(pair, atoms, history_step);
  }
}

void PairMuckpileBlock::step_block_pair(const BlockPair& block_pair, const AtomArrays& atoms,
                                        double history_step) {
  const double* const x = atoms.x;
  for (SpherePair& pair : near_spheres(block_pair)) {
    const double* a = x + 3 * pair.first;
    const double* b = x + 3 * pair.second;
    const double dx = b[0] - a[0], dy = b[1] - a[1], dz = b[2] - a[2];
    const double squared = dx * dx + dy * dy + dz * dz;
    if (squared < pair.reach * pair.reach) {
      touch(pair, Vec3(dx, dy, dz), std::sqrt(squared), atoms, history_step);
    } else if (pair.contact >= 0) {
      free_contacts_.push_back(pair.contact);
      pair.contact = -1;
    }
  }
}

ContactMotion PairMuckpileBlock::motion_of(const SpherePair& pair, const Vec3& to_second,
                                           double distance, const AtomArrays& atoms) const {
  const int i = pair.first, j = pair.second;  // by tag: both ranks of a contact compute the same
  const Vec3 normal = distance > 0.0 ? Vec3(to_second / distance) : Vec3::UnitX();
  const double overlap = pair.reach - distance;
  const double arm_i = atoms.radius[i] - 0.5 * overlap, arm_j = atoms.radius[j] - 0.5 * overlap;
  const Vec3 v_i = engine::vector_of(atoms.v, i), v_j = engine::vector_of(atoms.v, j);
  const Vec3 spin_i = engine::vector_of(atoms.omega, i), spin_j = engine::vector_of(atoms.omega, j);
  const Vec3 arm_spin = arm_i * spin_i + arm_j * spin_j;
  return {normal,
          overlap,
          atoms.radius[i],
          atoms.radius[j],
          atoms.mass[i] * atoms.mass[j] / (atoms.mass[i] + atoms.mass[j]),
          v_i - v_j + arm_spin.cross(normal),
          spin_i - spin_j};
}

void PairMuckpileBlock::touch(SpherePair& pair, const Vec3& to_second, double distance,
                              const AtomArrays& atoms, double history_step) {
  const int i = pair.first, j = pair.second;
  const ContactMotion motion = motion_of(pair, to_second, distance, atoms);
  if (pair.contact < 0) pair.contact = new_contact(ContactLaw::begin_contact(motion, update->dt));
  ContactState& state = contacts_[static_cast<std::size_t>(pair.contact)];
  const ContactResponse response = law_->evaluate(motion, history_step, state);

  const double arm_i = atoms.radius[i] - 0.5 * motion.overlap;
  const double arm_j = atoms.radius[j] - 0.5 * motion.overlap;
  const Vec3 lever = motion.normal.cross(response.force_on_first);
  if (i < atoms.owned)
    apply(atoms, i, response.force_on_first, arm_i * lever + response.torque_on_first);
  if (j < atoms.owned)
    apply(atoms, j, -response.force_on_first, arm_j * lever - response.torque_on_first);

  const double share = i < atoms.owned && j < atoms.owned ? 1.0 : 0.5;  // the other rank: the rest
  ledger_.contacts += share;
  ledger_.elastic_J += share * response.elastic_energy;
  if (history_step > 0.0) {
    losses_.friction += share * response.friction_loss;
    losses_.damping += share * response.damping_loss;
  }
  ledger_.max_overlap_ratio = std::max(ledger_.max_overlap_ratio,
                                       motion.overlap / std::min(atoms.radius[i], atoms.radius[j]));
}

void PairMuckpileBlock::apply(const AtomArrays& atoms, int target, const Vec3& pair_force,
                              const Vec3& pair_torque) {
  engine::add_to(atoms.f, target, pair_force);
  engine::add_to(atoms.torque, target, pair_torque);
  ledger_.power_W += pair_force.dot(engine::vector_of(atoms.v, target)) +
                     pair_torque.dot(engine::vector_of(atoms.omega, target));
}

}  // namespace muckpile
