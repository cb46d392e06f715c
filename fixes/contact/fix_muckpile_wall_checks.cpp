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
  const Vec3 centre = engine::vector_of(atom->x[0], sphere);
  const double depth = options_.surface->depth(centre);
  if (depth <= atom->radius[sphere]) return;
  books_.let_go += 1.0;
  if (depth > let_go_.depth) let_go_ = {atom->tag[sphere], depth, centre};
}

/// The first, and then whenever there are ten times as many.
void FixMuckpileWall::warn_of_let_go() {
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

/// Without the memory of its contacts, which is with its own rank.
std::vector<WallContact> FixMuckpileWall::contacts_of_ghost(int k) const {
  const Vec3 centre = engine::vector_of(atom->x[0], k);
  std::vector<std::size_t> near;
  std::vector<WallContact> contacts;
  WallTouches touches;
  if (options_.surface->distance(centre, atom->radius[k], near) >= atom->radius[k]) return contacts;
  options_.surface->find_touches(centre, atom->radius[k], near, touches);
  for (const WallTouch& touch : touches.all())
    contacts.push_back({touch.normal, {}, 0.0, touch.overlap});
  return contacts;
}

void FixMuckpileWall::visit_contacts(const Wanted& wanted, const Take& take) const {
  if (!law_) return;
  const auto tell = [&](int k, const std::vector<WallContact>& contacts) {
    for (const WallContact& contact : contacts) {
      const WallSphere ball = sphere(k);
      take(k, {law_->resistance(ball, contact), contact.normal,
               ball.centre + WallLaw::arm(ball.radius, contact)});
    }
  };
  for (int k = 0; k < atom->nlocal; ++k) {
    const std::vector<WallContact>& contacts = contacts_[static_cast<std::size_t>(k)];
    if (!contacts.empty() && wanted(k)) tell(k, contacts);
  }
  const bool named = atom->map_style != 0;
  for (int k = atom->nlocal; k < atom->nlocal + atom->nghost; ++k) {
    if ((atom->mask[k] & groupbit) == 0 || !wanted(k)) continue;
    if (named && atom->map(atom->tag[k]) < atom->nlocal) continue;  // a periodic image
    tell(k, contacts_of_ghost(k));
  }
}

double FixMuckpileWall::light_step() const {
  double step = std::numeric_limits<double>::infinity();
  if (!law_) return step;
  for (int k = 0; k < atom->nlocal; ++k)
    if ((atom->mask[k] & groupbit) != 0)
      step = std::min(step, law_->light_step(atom->rmass[k], atom->radius[k]));
  return step;
}

}  // namespace muckpile
