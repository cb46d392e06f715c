// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/wall: which spheres are near the wall, and its forces on them.
// Scope: see the header and docs/styles/fix_muckpile_wall.md. What travels with the spheres is in a
// file of its own.
#include "fixes/contact/fix_muckpile_wall.h"

#include <atom.h>
#include <fix_multisphere.h>
#include <force.h>
#include <modify.h>
#include <neighbor.h>
#include <pair.h>
#include <update.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "args/numbers.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/particle_vectors.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/block_contact_view.h"
#include "fixes/interfaces/keyword_tables.h"

namespace muckpile {
namespace {

/// Spheres are listed with their reach when neighbours are looked for, which must not come too late.
void require_neighbours_in_time(LAMMPS_NS::LAMMPS& lmp, const std::string& where) {
  const LAMMPS_NS::Neighbor& neighbor = *lmp.neighbor;
  if (neighbor.delay == 0 && neighbor.every == 1 && neighbor.dist_check != 0) return;
  engine::stop(lmp, where + ": needs 'neigh_modify delay 0 every 1 check yes', got delay " +
                        std::to_string(neighbor.delay) + " every " +
                        std::to_string(neighbor.every) + " check " +
                        (neighbor.dist_check != 0 ? "yes" : "no"));
}

}  // namespace

FixMuckpileWall::FixMuckpileWall(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(engine::name_of(*this)) {
  engine::require_id_of_restart(*lmp, where_, *this);
  const ArgValues args = engine::read_args(*lmp, wall_table(), where_, narg, arg, 3);
  options_ = engine::or_engine_error(*lmp, [&] { return wall_options(args, where_); });
  if (engine::find_multisphere(*lmp) == nullptr)
    engine::stop(*lmp, where_ + ": needs 'fix ID all multisphere' before it: it holds the blocks");
  vector_flag = 1;
  size_vector = 8;
  global_freq = 1;
  extvector = 0;
  restart_peratom = restart_global = 1;
  create_attribute = 1;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

FixMuckpileWall::~FixMuckpileWall() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

int FixMuckpileWall::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return PRE_EXCHANGE | PRE_NEIGHBOR | POST_FORCE;
}

/// The pair style may have been given anew.
void FixMuckpileWall::init() {
  const auto* const blocks = dynamic_cast<const BlockContactView*>(force->pair);
  if (blocks == nullptr)
    engine::stop(*lmp, where_ + ": needs pair_style muckpile/block, whose law it follows");
  require_neighbours_in_time(*lmp, where_);
  law_ = engine::or_engine_error(
      *lmp, where_, [&] { return WallLaw(options_.parameters(blocks->contact_parameters())); });
  resting_ = engine::find_view<RestingBlocks>(*lmp);
}

/// The forces of a state that a step has already reached.
void FixMuckpileWall::setup(int) {
  if (!looked_for_faults_) refuse_spheres_in_the_ground();
  looked_for_faults_ = true;
  step(0.0);
}

void FixMuckpileWall::post_force(int) { step(update->dt); }

/// What is deeper in the ground than its radius before the first step was put there by the script:
/// most often the normals are turned.
void FixMuckpileWall::refuse_spheres_in_the_ground() const {
  double deepest = 0.0;
  Vec3 place = Vec3::Zero();
  for (int k = 0; k < atom->nlocal; ++k) {
    if ((atom->mask[k] & groupbit) == 0) continue;
    const Vec3 centre = engine::vector_of(atom->x[0], k);
    const double depth = options_.surface->depth(centre);
    if (depth > atom->radius[k] && depth > deepest) deepest = depth, place = centre;
  }
  const double of_all = engine::greatest_over_ranks(deepest, world);
  if (of_all == 0.0) return;
  std::array told{place.x(), place.y(), place.z()};
  if (deepest != of_all) told.fill(-HUGE_VAL);
  engine::reduce_over_ranks(told, MPI_MAX, world);
  engine::stop(*lmp, where_ +
                         ": rock must lie where the normals of the wall point to, got a sphere " +
                         number_text(of_all) + " m behind it, at " + number_text(told[0]) + " " +
                         number_text(told[1]) + " " + number_text(told[2]) +
                         " m; turn the normals, or leave what lies there out of the fix's group");
}

void FixMuckpileWall::list_candidates() {
  listed_ = true;
  candidates_.clear();
  parts_.clear();
  std::vector<std::size_t> near;
  for (int k = 0; k < atom->nlocal; ++k) {
    std::vector<WallContact>& contacts = contacts_[static_cast<std::size_t>(k)];
    const Vec3 centre = engine::vector_of(atom->x[0], k);
    double gap = HUGE_VAL;
    if ((atom->mask[k] & groupbit) != 0) {
      const double reach = atom->radius[k] + neighbor->skin;
      gap = options_.surface->distance(centre, reach, near) - atom->radius[k];
    }
    if (gap > 0.0) contacts.clear();
    if (gap == HUGE_VAL) continue;
    const std::size_t first = parts_.size();
    parts_.insert(parts_.end(), near.begin(), near.end());
    candidates_.push_back({k, first, parts_.size(), centre, gap});
  }
}

/// It has not moved far enough to touch since it was listed.
bool FixMuckpileWall::still_apart(const Candidate& candidate) const {
  const Vec3 way = engine::vector_of(atom->x[0], candidate.sphere) - candidate.place;
  return candidate.gap > 0.0 && way.squaredNorm() < candidate.gap * candidate.gap;
}

WallSphere FixMuckpileWall::sphere(int k) const {
  return {engine::vector_of(atom->x[0], k), engine::vector_of(atom->v[0], k),
          engine::vector_of(atom->omega[0], k), atom->radius[k], atom->rmass[k]};
}

WallPush FixMuckpileWall::push(const Candidate& candidate, double memory_step,
                               std::vector<WallContact>& contacts) const {
  const WallSphere ball = sphere(candidate.sphere);
  const std::span<const std::size_t> parts(parts_.data() + candidate.first,
                                           candidate.last - candidate.first);
  WallTouches touches;
  options_.surface->find_touches(ball.centre, ball.radius, parts, touches);
  return law_->push(ball, touches, update->dt, memory_step, contacts);
}

void FixMuckpileWall::step(double memory_step) {
  if (!listed_) list_candidates();
  sums_ = {};
  const bool some_rest = resting_ != nullptr && resting_->any_rests();
  const std::span<const char> rests =
      some_rest ? resting_->resting_spheres() : std::span<const char>{};
  for (Candidate& candidate : candidates_) {
    if (still_apart(candidate))
      contacts_[static_cast<std::size_t>(candidate.sphere)].clear();
    else if (some_rest && rests[static_cast<std::size_t>(candidate.sphere)] != 0)
      leave_alone(candidate);
    else
      work_on(candidate, memory_step);
  }
}

void FixMuckpileWall::work_on(Candidate& candidate, double memory_step) {
  const auto k = static_cast<std::size_t>(candidate.sphere);
  const WallPush pushed = push(candidate, memory_step, contacts_[k]);
  candidate.resting = -1.0;
  if (pushed.contacts == 0) return;
  Vec3::Map(atom->f[k]) += pushed.force;
  Vec3::Map(atom->torque[k]) += pushed.torque;
  sums_.contacts += pushed.contacts;
  sums_.elastic += pushed.elastic;
  sums_.force -= pushed.force;
  sums_.largest_overlap_ratio = std::max(sums_.largest_overlap_ratio, pushed.largest_overlap_ratio);
  if (memory_step == 0.0) return;
  losses_.friction += pushed.friction;
  losses_.damping += pushed.damping;
}

/// Its contacts stay as they are, with their energy; their force is not read.
void FixMuckpileWall::leave_alone(Candidate& candidate) {
  if (candidate.resting < 0.0) {
    std::vector<WallContact> as_they_are = contacts_[static_cast<std::size_t>(candidate.sphere)];
    candidate.resting = push(candidate, 0.0, as_they_are).elastic;
  }
  sums_.contacts +=
      static_cast<double>(contacts_[static_cast<std::size_t>(candidate.sphere)].size());
  sums_.elastic += candidate.resting;
}

double FixMuckpileWall::compute_vector(int n) {
  const std::array sums{sums_.contacts,  0.0,
                        sums_.elastic,   losses_.friction,
                        losses_.damping, sums_.force.x(),
                        sums_.force.y(), sums_.force.z()};
  if (n == 1) return engine::greatest_over_ranks(sums_.largest_overlap_ratio, world);
  return engine::sum_over_ranks(sums[static_cast<std::size_t>(n)], world);
}

}  // namespace muckpile
