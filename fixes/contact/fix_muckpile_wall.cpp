// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/wall: which spheres are near the wall, and its forces on them.
// Scope: see the header and docs/styles/fix_muckpile_wall.md. What travels with the spheres and
// what is looked at beside the forces are in files of their own.
#include "fixes/contact/fix_muckpile_wall.h"

#include <atom.h>
#include <domain.h>
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

/// Spheres are listed with their reach when neighbours are looked for, which must not come too
/// late.
void require_neighbours_in_time(LAMMPS_NS::LAMMPS& lmp, const std::string& where) {
  const LAMMPS_NS::Neighbor& neighbor = *lmp.neighbor;
  if (neighbor.delay == 0 && neighbor.every == 1 && neighbor.dist_check != 0) return;
  engine::stop(lmp, where + ": needs 'neigh_modify delay 0 every 1 check yes', got delay " +
                        std::to_string(neighbor.delay) + " every " +
                        std::to_string(neighbor.every) + " check " +
                        (neighbor.dist_check != 0 ? "yes" : "no"));
}

/// Sides of `boundary s` and `m` go with the spheres.
WallBox box_of(const LAMMPS_NS::Domain& domain) {
  constexpr int kShrinkWrapped = 2;  // and 3, with a least size
  WallBox box{Vec3::Map(domain.boxlo), Vec3::Map(domain.boxhi)};
  for (std::size_t c = 0; c < 3; ++c) {
    box.lo_follows[c] = domain.boundary[c][0] >= kShrinkWrapped;
    box.hi_follows[c] = domain.boundary[c][1] >= kShrinkWrapped;
  }
  return box;
}

}  // namespace

FixMuckpileWall::FixMuckpileWall(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(engine::name_of(*this)) {
  engine::require_id_of_restart(*lmp, where_, *this);
  const ArgValues args = engine::read_args(*lmp, wall_table(), where_, narg, arg, 3);
  options_ =
      engine::or_engine_error(*lmp, [&] { return wall_options(args, box_of(*domain), where_); });
  engine::print_once(*lmp, options_.told);
  if (engine::find_multisphere(*lmp) == nullptr)
    engine::stop(*lmp, where_ + ": needs 'fix ID all multisphere' before it: it holds the blocks");
  vector_flag = 1;
  size_vector = 9;
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
  law_ = engine::or_engine_error(*lmp, where_, [&] {
    return WallLaw(options_.parameters(blocks->contact_parameters()), options_.torsion);
  });
  resting_ = engine::find_view<RestingBlocks>(*lmp);
}

/// The forces of a state that a step has already reached.
void FixMuckpileWall::setup(int) {
  if (!looked_for_faults_) refuse_spheres_in_the_ground();
  looked_for_faults_ = true;
  step(0.0);
}

void FixMuckpileWall::post_force(int) { step(update->dt); }

void FixMuckpileWall::pre_neighbor() {
  listed_ = false;
  warn_of_let_go();
}

void FixMuckpileWall::list_candidates() {
  listed_ = true;
  sorted_ = false;
  candidates_.clear();
  parts_.clear();
  light_step_ = least_light_step();
  std::vector<std::size_t> near;
  for (int k = 0; k < atom->nlocal; ++k) {
    const Vec3 centre = engine::vector_of(atom->x[0], k);
    double gap = HUGE_VAL;
    if ((atom->mask[k] & groupbit) != 0) {
      const double reach = atom->radius[k] + neighbor->skin;
      gap = options_.surface->distance(centre, reach, near) - atom->radius[k];
    }
    if (gap > 0.0) end_contacts(k);
    if (gap == HUGE_VAL) continue;
    const std::size_t first = parts_.size();
    parts_.insert(parts_.end(), near.begin(), near.end());
    candidates_.push_back({k, first, parts_.size(), centre, gap});
  }
}

void FixMuckpileWall::end_contacts(int sphere) {
  if (is_behind(sphere)) look_whether_let_go(sphere);
  contacts_[static_cast<std::size_t>(sphere)].clear();
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
  const std::uint64_t version = resting_ == nullptr ? 0 : resting_->rests_version();
  if (!sorted_ || version != rests_version_) sort_out_resting();
  rests_version_ = version;
  sums_ = resting_sums_;
  for (const std::size_t c : awake_) {
    const Candidate& candidate = candidates_[c];
    if (still_apart(candidate))
      end_contacts(candidate.sphere);
    else
      work_on(candidate, memory_step);
  }
}

/// Those of resting blocks are left alone until blocks fall asleep or wake, or are listed anew.
void FixMuckpileWall::sort_out_resting() {
  sorted_ = true;
  awake_.clear();
  resting_sums_ = {};
  const bool some_rest = resting_ != nullptr && resting_->any_rests();
  const std::span<const char> rests =
      some_rest ? resting_->resting_spheres() : std::span<const char>{};
  for (std::size_t c = 0; c < candidates_.size(); ++c) {
    if (some_rest && rests[static_cast<std::size_t>(candidates_[c].sphere)] != 0) {
      leave_alone(candidates_[c]);
    } else {
      candidates_[c].resting = -1.0;
      awake_.push_back(c);
    }
  }
}

void FixMuckpileWall::work_on(const Candidate& candidate, double memory_step) {
  const auto k = static_cast<std::size_t>(candidate.sphere);
  const bool behind = is_behind(candidate.sphere);
  const WallPush pushed = push(candidate, memory_step, contacts_[k]);
  if (pushed.contacts == 0) {
    if (behind) look_whether_let_go(candidate.sphere);
    return;
  }
  Vec3::Map(atom->f[k]) += pushed.force;
  Vec3::Map(atom->torque[k]) += pushed.torque;
  sums_.contacts += pushed.contacts;
  sums_.elastic += pushed.elastic;
  sums_.force -= pushed.force;
  sums_.largest_overlap_ratio = std::max(sums_.largest_overlap_ratio, pushed.largest_overlap_ratio);
  if (memory_step == 0.0) return;
  books_.friction += pushed.friction;
  books_.damping += pushed.damping;
}

/// Its contacts stay as they are, with their energy; their force is not read.
void FixMuckpileWall::leave_alone(Candidate& candidate) {
  if (candidate.resting < 0.0) {
    std::vector<WallContact>& contacts = contacts_[static_cast<std::size_t>(candidate.sphere)];
    std::vector<WallContact> looked_at = contacts;
    candidate.resting = push(candidate, 0.0, looked_at).elastic;
    if (looked_at.size() == contacts.size())
      for (std::size_t c = 0; c < contacts.size(); ++c) contacts[c].overlap = looked_at[c].overlap;
  }
  resting_sums_.contacts +=
      static_cast<double>(contacts_[static_cast<std::size_t>(candidate.sphere)].size());
  resting_sums_.elastic += candidate.resting;
}

double FixMuckpileWall::compute_vector(int n) {
  const std::array sums{sums_.contacts,  0.0,
                        sums_.elastic,   books_.friction,
                        books_.damping,  sums_.force.x(),
                        sums_.force.y(), sums_.force.z(),
                        books_.let_go};
  if (n == 1) return engine::greatest_over_ranks(sums_.largest_overlap_ratio, world);
  return engine::sum_over_ranks(sums[static_cast<std::size_t>(n)], world);
}

}  // namespace muckpile
