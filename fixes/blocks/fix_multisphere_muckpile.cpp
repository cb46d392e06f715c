// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/muckpile: the step of the bodies, their spheres, and the forces on them.
// Scope: see the header. Leapfrog as in the base class; src/core/motion does the work.
#include "fixes/blocks/fix_multisphere_muckpile.h"

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
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "fixes/blocks/fix_muckpile_blocks.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"

namespace muckpile {
namespace {

/// Along x, y and z, whether each body moves or turns.
const bool* const* flags(LAMMPS_NS::Multisphere& data, const char* name) {
  return data.prop().getElementProperty<LAMMPS_NS::VectorContainer<bool, 3>>(name)->begin();
}

}  // namespace

FixMultisphereMuckpile::FixMultisphereMuckpile(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : FixMultisphere(engine, narg, arg) {
  if (narg != 3) {
    engine::stop(*engine, engine::name_of(*this) + ": takes no keywords, got '" + arg[3] +
                              "'; fix multisphere has some");
  }
}

void FixMultisphereMuckpile::post_create() {
  FixMultisphere::post_create();
  engine::require_id_of_restart(*lmp, engine::name_of(*this), *this);
  if (modify->have_restart_data(this) && modify->have_restart_data_style("muckpile/blocks"))
    FixMuckpileBlocks::find_or_make(*lmp);
}

void FixMultisphereMuckpile::init() {
  FixMultisphere::init();
  resting_ = engine::find_view<RestingBlocks>(*lmp);
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
  members_known_ = false;
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
  double mine = 0.0;  // sphere's surface nearest to its body's centre [m]
  for (int k = 0; k < atom->nlocal; ++k) {
    if (body_[k] >= 0) mine = std::max(mine, Vec3::Map(displace_[k]).norm() - atom->radius[k]);
  }
  return 2.0 * engine::greatest_over_ranks(mine, world);  // LIGGGHTS takes half of it
}

/// A box that follows the spheres must hold the bodies' centres, too: LIGGGHTS drops a body whose
/// centre is outside, and the centre of the outermost may lie farther out than those of its
/// spheres.
void FixMultisphereMuckpile::box_extent(double& xlo, double& xhi, double& ylo, double& yhi,
                                        double& zlo, double& zhi) {
  const engine::Bodies bodies(*this);
  for (int b = 0; b < bodies.count(); ++b) {
    const Vec3 at = bodies.centre(b);
    xlo = std::min(xlo, at.x()), xhi = std::max(xhi, at.x());
    ylo = std::min(ylo, at.y()), yhi = std::max(yhi, at.y());
    zlo = std::min(zlo, at.z()), zhi = std::max(zhi, at.z());
  }
}

void FixMultisphereMuckpile::pre_neighbor() {
  FixMultisphere::pre_neighbor();
  members_known_ = false;
}

bool FixMultisphereMuckpile::velocities_are_read() const {
  const auto reads = [now = update->ntimestep](int every) { return now % every == 0; };
  return output->next == update->ntimestep || std::ranges::any_of(readers_, reads);
}

/// They stay the same until neighbours are looked for again.
void FixMultisphereMuckpile::list_members() {
  members_known_ = true;
  placed_version_ = rests_version_ = 0;
  const std::vector<BodySphere> spheres = members();
  motion_ = BodyMotion(constants(), spheres);
  own_messages_ = !periodic() && comm->nprocs > 1;
  if (own_messages_) list_border_spheres(spheres);
}

bool FixMultisphereMuckpile::periodic() const {
  return domain->xperiodic + domain->yperiodic + domain->zperiodic > 0;
}

/// Spheres, ghosts among them, whose body this rank moves.
std::vector<BodySphere> FixMultisphereMuckpile::members() {
  std::vector<BodySphere> spheres;
  spheres.reserve(static_cast<std::size_t>(atom->nlocal + atom->nghost));
  const Vec3 box(domain->xprd, domain->yprd, domain->zprd);
  for (int k = 0; k < atom->nlocal + atom->nghost; ++k) {
    const int body = body_[k] < 0 ? -1 : map(body_[k]);
    if (body < 0) continue;
    BodySphere sphere{body, k, Vec3::Map(displace_[k])};
    sphere.counts = domain->is_owned_or_first_ghost(k);
    if (periodic()) {
      const auto image = atom->image[k];
      const Vec3 images(static_cast<double>((image & IMGMASK) - IMGMAX),
                        static_cast<double>((image >> IMGBITS & IMGMASK) - IMGMAX),
                        static_cast<double>((image >> IMG2BITS) - IMGMAX));
      sphere.image = -images.cwiseProduct(box);
    }
    spheres.push_back(sphere);
  }
  return spheres;
}

std::vector<BodyConstants> FixMultisphereMuckpile::constants() {
  const engine::Bodies bodies(*this);
  const auto three = [](const bool* flags) { return std::array{flags[0], flags[1], flags[2]}; };
  const auto moves = flags(multisphere_, "fflag"), turns = flags(multisphere_, "tflag");
  std::vector<BodyConstants> all(static_cast<std::size_t>(bodies.count()));
  for (int b = 0; b < bodies.count(); ++b) {
    all[static_cast<std::size_t>(b)] = {bodies.mass(b), bodies.inertia(b), three(moves[b]),
                                        three(turns[b])};
  }
  return all;
}

void FixMultisphereMuckpile::list_border_spheres(const std::vector<BodySphere>& members) {
  std::vector<int> lent, strange;
  for (const BodySphere& member : members) {
    if (member.sphere >= atom->nlocal) lent.push_back(member.sphere);
  }
  for (int k = 0; k < atom->nlocal; ++k) {
    if (body_[k] >= 0 && map(body_[k]) < 0) strange.push_back(k);
  }
  border_ = engine::BorderSpheres(std::move(lent), std::move(strange), atom->tag, world);
}

SphereRows FixMultisphereMuckpile::sphere_rows() const {
  return {*atom->x, *atom->v, *atom->omega, *atom->f, *atom->torque};
}

Vec3 FixMultisphereMuckpile::gravity() const {
  Vec3 pull = Vec3::Zero();
  if (fix_gravity_ != nullptr) fix_gravity_->get_gravity(pull.data());
  return pull;
}

/// Which bodies rest changes seldom.
void FixMultisphereMuckpile::follow_rests() {
  const std::uint64_t version = any_rests() ? resting_->rests_version() : 0;
  if (version == rests_version_) return;
  rests_version_ = version;
  std::vector<char> resting(any_rests() ? static_cast<std::size_t>(multisphere_.n_body()) : 0);
  for (std::size_t b = 0; b < resting.size(); ++b)
    resting[b] = resting_->body_rests(static_cast<int>(b)) ? 1 : 0;
  motion_.let_rest(resting);
}

void FixMultisphereMuckpile::initial_integrate(int vflag) {
  if (!plain_ || vflag != 0) {
    FixMultisphere::initial_integrate(vflag);
    return;
  }
  evflag = 0;
  if (!members_known_) list_members();
  follow_rests();
  // Spheres of resting bodies stay where they are. They are placed once more after their body came
  // to rest, so that their velocities are 0.
  const bool place_resting = placed_version_ != rests_version_;
  placed_version_ = rests_version_;
  motion_.advance(engine::Bodies(*this).rows(), sphere_rows(), {dtv, dtf}, place_resting);
  if (own_messages_) {
    border_.to_spheres({atom->x, atom->v, atom->omega});
  } else {
    rev_comm_flag_ = MS_COMM_REV_X_V_OMEGA;
    reverse_comm();
  }
}

/// Resting bodies are stopped before their forces, which are incomplete, can become velocities.
void FixMultisphereMuckpile::calc_force(bool setupflag) {
  if (plain_) {
    if (!members_known_) list_members();
    motion_.sum_forces(engine::Bodies(*this).rows(), sphere_rows(), gravity());
  } else {
    FixMultisphere::calc_force(setupflag);
  }
  if (any_rests()) hold_resting();
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
  if (plain_) follow_rests();
  if (!plain_ || velocities_are_read()) {
    FixMultisphere::final_integrate();
    return;
  }
  motion_.finish(engine::Bodies(*this).rows(), sphere_rows(), gravity(), {dtv, dtf});
  if (any_rests()) hold_resting();
}

/// The forces on resting blocks are incomplete, since those between two of them are left out.
void FixMultisphereMuckpile::hold_resting() {
  engine::Bodies bodies(*this);
  for (int b = 0; b < bodies.count(); ++b) {
    if (resting_->body_rests(b)) bodies.hold(b);
  }
}

}  // namespace muckpile
