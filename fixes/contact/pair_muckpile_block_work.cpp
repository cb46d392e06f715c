// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: the work of its forces on the bodies, for the energy account.
// Scope: sums of the forces on each block are kept while somebody watches; blocks that nothing
// touches cost nothing.
#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <fix_multisphere.h>

#include <algorithm>

#include "fixes/contact/pair_muckpile_block.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/particle_vectors.h"

namespace muckpile {

/// The loads of the step before are forgotten.
void PairMuckpileBlock::begin_loads() {
  for (const int block : loaded_blocks()) loads_[static_cast<std::size_t>(block)] = {};
  forget_loads();
}

/// Blocks have got other numbers.
void PairMuckpileBlock::renumber_loads() {
  forget_loads();
  if (watched_) loads_.assign(block_tag_.size(), {});
}

/// Of a block, in the periodic image that it is; nullopt: no sphere of it is this rank's.
std::optional<engine::BodyState> PairMuckpileBlock::state_of(const engine::Bodies& bodies,
                                                             int block) const {
  const int tag = block_tag_[static_cast<std::size_t>(block)];
  const int body = bodies_->data().map(tag);
  const engine::BodyState* const strange = body < 0 ? strange_.find(tag) : nullptr;
  if (body < 0 && strange == nullptr) return std::nullopt;
  engine::BodyState state =
      body < 0 ? *strange
               : engine::BodyState{bodies.centre(body), bodies.velocity(body), bodies.spin(body)};
  if (domain->xperiodic + domain->yperiodic + domain->zperiodic > 0) {
    const Vec3 sphere =
        engine::vector_of(atom->x[0], first_sphere_[static_cast<std::size_t>(block)]);
    Vec3 arm = sphere - state.centre;
    domain->minimum_image(arm.x(), arm.y(), arm.z());
    state.centre = sphere - arm;
  }
  return state;
}

double PairMuckpileBlock::end_step(double time_step) {
  if (comm->nprocs > 1) strange_.update(*bodies_);
  const engine::Bodies bodies(*bodies_);
  double all = 0.0, dashpots = 0.0;  // [W]
  for (const int block : loaded_blocks()) {
    const std::optional<engine::BodyState> state = state_of(bodies, block);
    if (!state) continue;
    const ContactLoad& load = loads_[static_cast<std::size_t>(block)];
    const auto power = [&state](const Vec3& push, const Vec3& moment) {
      return push.dot(state->velocity) + (moment - state->centre.cross(push)).dot(state->spin);
    };
    all += power(load.force(), load.moment());
    dashpots += power(load.dashpot_force(), load.dashpot_moment());
  }
  losses_.damping -= dashpots * act_.strength * time_step;
  return all * act_.strength * time_step;
}

}  // namespace muckpile
