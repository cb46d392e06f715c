// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/muckpile: second half step of the bodies alone.
// Scope: see the header.
#include "fix_multisphere_muckpile.h"

#include <force.h>
#include <math_extra.h>
#include <modify.h>
#include <output.h>
#include <update.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/bodies.h"
#include "engine/style_args.h"

namespace muckpile {

FixMultisphereMuckpile::FixMultisphereMuckpile(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : FixMultisphere(engine, narg, arg) {
  if (narg != 3) {
    engine::stop(*engine, std::string("fix multisphere/muckpile '") + id +
                              "': takes no keywords, got '" + arg[3] +
                              "'; fix multisphere has some");
  }
}

void FixMultisphereMuckpile::init() {
  FixMultisphere::init();
  const auto ours = [](std::string_view name) { return name.starts_with("muckpile/"); };
  resting_ =
      dynamic_cast<const RestingBlocks*>(modify->find_fix_style_strict("muckpile/sleep", 0));
  read_every_step_ = fix_heat_ != nullptr;
  for (int f = 0; f < modify->nfix; ++f) {
    const bool at_end = (modify->fmask[f] & LAMMPS_NS::FixConst::END_OF_STEP) != 0;
    if (at_end && !ours(modify->fix[f]->style)) read_every_step_ = true;
  }
}

void FixMultisphereMuckpile::reset_dt() {
  dtv = update->dt;
  dtf = 0.5 * update->dt * force->ftm2v;
  dtq = 0.5 * update->dt;
}

bool FixMultisphereMuckpile::velocities_are_read() const {
  return read_every_step_ || output->next == update->ntimestep;
}

void FixMultisphereMuckpile::final_integrate() {
  if (velocities_are_read()) {
    FixMultisphere::final_integrate();
  } else {
    calc_force(false);
    integrate_bodies();
  }
  if (resting_ != nullptr && resting_->any_rests()) hold_resting();
}

/// What was left out between resting blocks makes the forces on them incomplete.
void FixMultisphereMuckpile::hold_resting() {
  engine::Bodies bodies(*this);
  for (int b = 0; b < bodies.count(); ++b) {
    if (resting_->body_rests(b)) bodies.hold(b);
  }
}

void FixMultisphereMuckpile::integrate_bodies() {
  using Flags = LAMMPS_NS::VectorContainer<bool, 3>;
  bool** const moves = multisphere_.prop().getElementProperty<Flags>("fflag")->begin();
  bool** const turns = multisphere_.prop().getElementProperty<Flags>("tflag")->begin();
  engine::Bodies bodies(*this);
  for (int b = 0; b < bodies.count(); ++b) {
    for (int d = 0; d < 3; ++d) {
      if (moves[b][d]) bodies.velocity(b)[d] += dtf / bodies.mass(b) * bodies.force(b)[d];
      if (turns[b][d]) bodies.angular_momentum(b)[d] += dtf * bodies.torque(b)[d];
    }
    const Mat3 axes = bodies.axes(b);
    const Vec3 in_body = axes.transpose() * bodies.angular_momentum(b);
    bodies.spin(b) = axes * in_body.cwiseQuotient(bodies.inertia(b));
  }
}

}  // namespace muckpile
