// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/impulse: the kicks of the integrator, force by force.
// Scope: see the header. fix multisphere gives half a kick as a step begins and half as it ends,
// both with the sum of forces that its own final_integrate() found; it clears them as it moves on,
// so the forces are read behind it, and kept for the half that follows.
#include "fixes/output/fix_muckpile_impulse.h"

#include <fix_gravity.h>
#include <fix_multisphere.h>
#include <modify.h>
#include <update.h>

#include <string>

#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/force_parts.h"
#include "fixes/interfaces/resting_blocks.h"

namespace muckpile {

FixMuckpileImpulse::FixMuckpileImpulse(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg) {
  const std::string where = engine::name_of(*this);
  engine::refuse_second_fix(*lmp, where, "muckpile/impulse");
  if (narg != 3) engine::stop(*lmp, where + ": takes no keywords, got '" + arg[3] + "'");
  if (engine::find_multisphere(*lmp) == nullptr)
    engine::stop(*lmp, where + ": needs 'fix ID all multisphere' before it");
}

int FixMuckpileImpulse::setmask() {
  return LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::FINAL_INTEGRATE;
}

void FixMuckpileImpulse::init() {
  multisphere_ = engine::find_multisphere(*lmp);
  gravity_ = static_cast<LAMMPS_NS::FixGravity*>(modify->find_fix_style("gravity", 0));
  joints_ = engine::find_view<ForceParts>(*lmp);
  sleep_ = engine::find_view<RestingBlocks>(*lmp);
  if (engine::place_of<ForceParts>(*lmp) > modify->find_fix(id))
    engine::stop(*lmp, engine::name_of(*this) + ": must be defined after fix muckpile/joint");
}

/// The forces of joints are known from their set-up on, and fixes are set up in their order.
void FixMuckpileImpulse::setup(int) {
  read_forces();
  if (!begun_) begin();
}

void FixMuckpileImpulse::initial_integrate(int) { sums_.kick(0.5 * update->dt); }

void FixMuckpileImpulse::final_integrate() {
  read_forces();
  sums_.kick(0.5 * update->dt);
}

void FixMuckpileImpulse::begin() {
  begun_ = true;
  const engine::Bodies bodies(*multisphere_);
  std::vector<Vec3> momenta;
  for (int b = 0; b < bodies.count(); ++b) momenta.push_back(bodies.mass(b) * bodies.velocity(b));
  sums_.begin(momenta);
}

void FixMuckpileImpulse::read_forces() {
  const engine::Bodies bodies(*multisphere_);
  tags_.clear();
  for (int b = 0; b < bodies.count(); ++b) tags_.push_back(bodies.tag(b));
  const std::span<ByPart> forces = sums_.forces_on(tags_);
  if (joints_ != nullptr) joints_->forces_by_part(forces);
  Vec3 pull = Vec3::Zero();
  if (gravity_ != nullptr) gravity_->get_gravity(pull.data());
  for (int b = 0; b < bodies.count(); ++b) {
    ByPart& on = forces[static_cast<std::size_t>(b)];
    if (sleep_ != nullptr && sleep_->body_rests(b)) {  // it is held, whatever acts on it
      on = {};
      continue;
    }
    on[ImpulsePart::weight] = bodies.mass(b) * pull;
    on[ImpulsePart::contacts] = Vec3(bodies.force(b)) - on.sum();
  }
}

}  // namespace muckpile
