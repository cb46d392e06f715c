// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/muckpile: the step of the bodies, their spheres, and the forces on them.
// Scope: see the header. Leapfrog and Richardson's rotation as in the base class.
#include "fix_multisphere_muckpile.h"

#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <fix_gravity.h>
#include <force.h>
#include <math_extra.h>
#include <modify.h>
#include <output.h>
#include <update.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "engine/bodies.h"
#include "engine/single_fix.h"
#include "engine/style_args.h"
#include "fix_muckpile_blocks.h"

namespace muckpile {
namespace {

using Flags = LAMMPS_NS::VectorContainer<bool, 3>;

/// Half a step's change of velocity and angular momentum.
class Kick {
 public:
  Kick(LAMMPS_NS::Multisphere& data, double half_step)
      : moves_(data.prop().getElementProperty<Flags>("fflag")->begin()),
        turns_(data.prop().getElementProperty<Flags>("tflag")->begin()),
        half_step_(half_step) {}
  void operator()(engine::Bodies& bodies, int b) const {
    for (int d = 0; d < 3; ++d) {
      if (moves_[b][d]) bodies.velocity(b)[d] += half_step_ / bodies.mass(b) * bodies.force(b)[d];
      if (turns_[b][d]) bodies.angular_momentum(b)[d] += half_step_ * bodies.torque(b)[d];
    }
  }

 private:
  bool **moves_, **turns_;
  double half_step_;
};

}  // namespace

FixMultisphereMuckpile::FixMultisphereMuckpile(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : FixMultisphere(engine, narg, arg) {
  if (narg != 3) {
    engine::stop(*engine, std::string("fix multisphere/muckpile '") + id +
                              "': takes no keywords, got '" + arg[3] +
                              "'; fix multisphere has some");
  }
}

void FixMultisphereMuckpile::post_create() {
  FixMultisphere::post_create();
  engine::require_id_of_restart(*lmp, std::string("fix multisphere/muckpile '") + id + "'", *this);
  if (modify->have_restart_data(this) && modify->have_restart_data_style("muckpile/blocks"))
    FixMuckpileBlocks::find_or_make(*lmp);
}

void FixMultisphereMuckpile::init() {
  FixMultisphere::init();
  resting_ = dynamic_cast<const RestingBlocks*>(modify->find_fix_style_strict("muckpile/sleep", 0));
  const auto ours = [](std::string_view name) { return name.starts_with("muckpile/"); };
  readers_.clear();
  if (fix_heat_ != nullptr) readers_.push_back(1);
  for (int f = 0; f < modify->nfix; ++f) {
    const bool at_end = (modify->fmask[f] & LAMMPS_NS::FixConst::END_OF_STEP) != 0;
    if (at_end && !ours(modify->fix[f]->style)) readers_.push_back(modify->fix[f]->nevery);
  }
  plain_ = fix_heat_ == nullptr && !do_modify_body_forces_torques_ &&
           CAdd_ * fluidDensity_ == 0.0 && atom->quaternion == nullptr &&
           modify->n_fixes_style("insert/stream") == 0 && modify->n_fixes_style("couple/cfd") == 0;
  members_known_ = any_rests_ = false;
}

void FixMultisphereMuckpile::reset_dt() {
  dtv = update->dt;
  dtf = 0.5 * update->dt * force->ftm2v;
  dtq = 0.5 * update->dt;
}

/// A rank must know the spheres of its bodies; what its spheres can touch, the pair style asks for.
/// Ghosts are chosen by their surface, so less than LIGGGHTS' two bounding radii is enough.
double FixMultisphereMuckpile::extend_cut_ghost() {
  if (atom->radius == nullptr || !atom->radius_flag) return FixMultisphere::extend_cut_ghost();
  double mine = 0.0, farthest = 0.0;  // sphere's surface nearest to its body's centre [m]
  for (int k = 0; k < atom->nlocal; ++k) {
    if (body_[k] >= 0) mine = std::max(mine, Vec3::Map(displace_[k]).norm() - atom->radius[k]);
  }
  MPI_Allreduce(&mine, &farthest, 1, MPI_DOUBLE, MPI_MAX, world);
  return 2.0 * farthest;  // LIGGGHTS takes half of it
}

void FixMultisphereMuckpile::pre_neighbor() {
  FixMultisphere::pre_neighbor();
  members_known_ = false;
}

bool FixMultisphereMuckpile::velocities_are_read() const {
  const auto reads = [now = update->ntimestep](int every) { return now % every == 0; };
  return output->next == update->ntimestep || std::ranges::any_of(readers_, reads);
}

/// Spheres, ghosts among them, whose body this rank moves; they stay the same until neighbours are
/// looked for again.
void FixMultisphereMuckpile::list_members() {
  members_known_ = true;
  placed_version_ = 0;
  members_.clear();
  counts_.clear();
  shifts_.clear();
  const bool periodic = domain->xperiodic + domain->yperiodic + domain->zperiodic > 0;
  const Vec3 box(domain->xprd, domain->yprd, domain->zprd);
  for (int k = 0; k < atom->nlocal + atom->nghost; ++k) {
    const int body = body_[k] < 0 ? -1 : map(body_[k]);
    if (body < 0) continue;
    members_.push_back({k, body, Vec3(displace_[k][0], displace_[k][1], displace_[k][2])});
    counts_.push_back(domain->is_owned_or_first_ghost(k) ? 1 : 0);
    if (!periodic) continue;
    const auto image = atom->image[k];
    const Vec3 images(static_cast<double>((image & IMGMASK) - IMGMAX),
                      static_cast<double>((image >> IMGBITS & IMGMASK) - IMGMAX),
                      static_cast<double>((image >> IMG2BITS) - IMGMAX));
    shifts_.push_back(-images.cwiseProduct(box));
  }
  own_messages_ = !periodic && comm->nprocs > 1;
  if (own_messages_) list_border_spheres();
}

void FixMultisphereMuckpile::list_border_spheres() {
  std::vector<int> lent, strange;
  for (const Member& member : members_) {
    if (member.sphere >= atom->nlocal) lent.push_back(member.sphere);
  }
  for (int k = 0; k < atom->nlocal; ++k) {
    if (body_[k] >= 0 && map(body_[k]) < 0) strange.push_back(k);
  }
  border_ = engine::BorderSpheres(std::move(lent), std::move(strange), atom->tag, world);
}

void FixMultisphereMuckpile::initial_integrate(int vflag) {
  if (!plain_ || vflag != 0) {
    FixMultisphere::initial_integrate(vflag);
    return;
  }
  evflag = 0;
  if (!members_known_) list_members();
  any_rests_ = resting_ != nullptr && resting_->any_rests();
  move_bodies();
  place_spheres();
  if (own_messages_) {
    border_.to_spheres({atom->x, atom->v, atom->omega});
  } else {
    rev_comm_flag_ = MS_COMM_REV_X_V_OMEGA;
    reverse_comm();
  }
}

void FixMultisphereMuckpile::move_bodies() {
  const Kick kick(multisphere_, dtf);
  engine::Bodies bodies(*this);
  for (int b = 0; b < bodies.count(); ++b) {
    if (rests(b)) continue;
    kick(bodies, b);
    bodies.centre(b) += dtv * bodies.velocity(b);
    bodies.turn(b, dtq);
  }
}

/// Spheres of resting bodies stay where they are. They are placed once more after their body came
/// to rest, so that their velocities are 0.
void FixMultisphereMuckpile::place_spheres() {
  const bool all = !any_rests_ || !shifts_.empty() || resting_->rests_version() != placed_version_;
  if (any_rests_) placed_version_ = resting_->rests_version();
  const engine::Bodies bodies(*this);
  double** const x = atom->x;
  double** const v = atom->v;
  double** const omega = atom->omega;
  int last = -1;
  bool held = false;
  Mat3 axes = Mat3::Identity();
  Vec3 centre = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Member& member = members_[m];
    if (member.body != last) {
      last = member.body;
      held = !all && rests(last);
      if (held) continue;
      axes = bodies.axes(last);
      centre = bodies.centre(last);
      velocity = bodies.velocity(last);
      spin = bodies.spin(last);
    }
    if (held) continue;
    const Vec3 arm = axes * member.displacement;
    Vec3::Map(x[member.sphere]) = centre + arm;
    Vec3::Map(v[member.sphere]) = velocity + spin.cross(arm);
    Vec3::Map(omega[member.sphere]) = spin;
    if (!shifts_.empty()) Vec3::Map(x[member.sphere]) += shifts_[m];
  }
}

/// Resting bodies are held before their forces, which are incomplete, can become velocities.
void FixMultisphereMuckpile::calc_force(bool setupflag) {
  if (plain_)
    sum_forces();
  else
    FixMultisphere::calc_force(setupflag);
  if (any_rests_) hold_resting();
}

void FixMultisphereMuckpile::sum_forces() {
  if (!members_known_) list_members();
  engine::Bodies bodies(*this);
  for (std::size_t m = 0; m < members_.size();) {
    const int body = members_[m].body;
    if (any_rests_ && rests(body)) {  // held, whatever they are
      while (m < members_.size() && members_[m].body == body) ++m;
      continue;
    }
    const Mat3 axes = bodies.axes(body);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (; m < members_.size() && members_[m].body == body; ++m) {
      if (counts_[m] == 0) continue;
      const Vec3 pull = Vec3::Map(atom->f[members_[m].sphere]);
      sum += pull;
      moment += (axes * members_[m].displacement).cross(pull) +
                Vec3::Map(atom->torque[members_[m].sphere]);
    }
    bodies.force(body) += sum;
    bodies.torque(body) += moment;
  }
  if (fix_gravity_ == nullptr) return;
  Vec3 gravity;
  fix_gravity_->get_gravity(gravity.data());
  for (int b = 0; b < bodies.count(); ++b) bodies.force(b) += bodies.mass(b) * gravity;
}

/// Brings the forces on spheres that other ranks own to the ranks of their bodies.
void FixMultisphereMuckpile::pre_final_integrate() {
  if (plain_ && !members_known_) list_members();
  if (plain_ && own_messages_)
    border_.to_bodies({atom->f, atom->torque});
  else
    FixMultisphere::pre_final_integrate();
}

void FixMultisphereMuckpile::final_integrate() {
  any_rests_ = resting_ != nullptr && resting_->any_rests();
  if (velocities_are_read()) {
    FixMultisphere::final_integrate();
  } else {
    calc_force(false);
    kick_bodies();
  }
}

void FixMultisphereMuckpile::kick_bodies() {
  const Kick kick(multisphere_, dtf);
  engine::Bodies bodies(*this);
  for (int b = 0; b < bodies.count(); ++b) {
    if (rests(b)) continue;
    kick(bodies, b);
    const Mat3 axes = bodies.axes(b);
    const Vec3 in_body = axes.transpose() * bodies.angular_momentum(b);
    bodies.spin(b) = axes * in_body.cwiseQuotient(bodies.inertia(b));
  }
}

/// The forces on resting blocks are incomplete, since those between two of them are left out.
void FixMultisphereMuckpile::hold_resting() {
  engine::Bodies bodies(*this);
  for (int b = 0; b < bodies.count(); ++b) {
    if (rests(b)) bodies.hold(b);
  }
}

}  // namespace muckpile
