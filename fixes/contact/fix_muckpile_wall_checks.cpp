// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/wall: spheres that are too deep in the ground, and contacts for the time step.
// Scope: beside the forces; the warnings are collective.
#include <atom.h>
#include <comm.h>
#include <error.h>
#include <update.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "args/rounded_text.h"
#include "fixes/contact/fix_muckpile_wall.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/particle_vectors.h"
#include "fixes/engine/style_args.h"

namespace muckpile {
namespace {

std::string place_text(const Vec3& p) {
  return rounded_text(p.x()) + ' ' + rounded_text(p.y()) + ' ' + rounded_text(p.z()) + " m";
}

}  // namespace

/// The deepest; of equally deep ones that of the lowest tag.
FixMuckpileWall::Sunk FixMuckpileWall::deepest_over_ranks(const Sunk& mine) const {
  constexpr int kNone = std::numeric_limits<int>::max();
  Sunk all;
  all.depth = engine::greatest_over_ranks(mine.tag < 0 ? 0.0 : mine.depth, world);
  const int tag = mine.tag >= 0 && mine.depth == all.depth ? mine.tag : kNone;
  const int lowest = engine::least_over_ranks(tag, world);
  if (lowest == kNone) return {};
  all.tag = lowest;
  all.place = tag == lowest ? mine.place : Vec3::Constant(-HUGE_VAL);
  engine::reduce_over_ranks(std::span(all.place.data(), 3), MPI_MAX, world);
  return all;
}

/// What is deeper in the ground than its radius before the first step was put there by the script:
/// most often the normals are turned.
void FixMuckpileWall::refuse_spheres_in_the_ground() const {
  Sunk mine;
  for (int k = 0; k < atom->nlocal; ++k) {
    if ((atom->mask[k] & groupbit) == 0) continue;
    const Vec3 centre = engine::vector_of(atom->x[0], k);
    const double depth = options_.surface->depth(centre);
    if (depth <= atom->radius[k] || depth < mine.depth) continue;
    if (depth > mine.depth || atom->tag[k] < mine.tag) mine = {atom->tag[k], depth, centre};
  }
  const Sunk deepest = deepest_over_ranks(mine);
  if (deepest.tag < 0) return;
  engine::stop(*lmp,
               where_ + ": rock must lie where the normals of the wall point to, got a sphere " +
                   rounded_text(deepest.depth) + " m behind it, at " + place_text(deepest.place) +
                   "; turn the normals, or leave what lies there out of the fix's group");
}

/// Whether the centre of a sphere was behind a face in the last step.
bool FixMuckpileWall::is_behind(int sphere) const {
  const double radius = atom->radius[sphere];
  return std::ranges::any_of(contacts_[static_cast<std::size_t>(sphere)],
                             [&](const WallContact& c) { return c.overlap > radius; });
}

/// Of one that was behind a face, and that nothing holds any more.
void FixMuckpileWall::look_whether_let_go(int sphere) {
  if (!options_.surface->lets_go()) return;
  const Vec3 centre = engine::vector_of(atom->x[0], sphere);
  const double depth = options_.surface->depth(centre);
  if (depth <= atom->radius[sphere]) return;
  books_.let_go += 1.0;
  if (depth > let_go_.depth) let_go_ = {atom->tag[sphere], depth, centre};
}

/// The first, and then whenever there are ten times as many.
void FixMuckpileWall::warn_of_let_go() {
  if (!options_.surface->lets_go()) return;
  const double all = engine::sum_over_ranks(books_.let_go, world);
  if (all < 1.0 || all < 10.0 * told_let_go_) return;
  told_let_go_ = all;
  const Sunk deepest = deepest_over_ranks(let_go_);
  let_go_ = {};
  if (deepest.tag < 0 || comm->me != 0) return;
  const std::string text =
      where_ + ": " + rounded_text(all) +
      " spheres have been pressed deeper behind the wall than their radius, and it holds them no "
      "more, the deepest, sphere " +
      std::to_string(deepest.tag) + ", at " + place_text(deepest.place) + " before step " +
      std::to_string(update->ntimestep) +
      "; their blocks may fall through: a higher youngs_modulus or larger spheres hold more";
  error->warning(FLERR, text.c_str());
}

void FixMuckpileWall::visit_contacts(const Take& take) const {
  if (!law_) return;
  for (int k = 0; k < atom->nlocal; ++k) {
    const std::vector<WallContact>& contacts = contacts_[static_cast<std::size_t>(k)];
    if (contacts.empty()) continue;
    const WallSphere ball = sphere(k);
    for (const WallContact& contact : contacts)
      take(k, {law_->resistance(ball, contact), contact.normal,
               ball.centre + WallLaw::arm(ball.radius, contact)});
  }
}

/// Of all spheres of this rank that may touch.
double FixMuckpileWall::least_light_step() const {
  double step = HUGE_VAL;
  for (int k = 0; law_ && k < atom->nlocal; ++k)
    if ((atom->mask[k] & groupbit) != 0)
      step = std::min(step, law_->light_step(atom->rmass[k], atom->radius[k]));
  return step;
}

}  // namespace muckpile
