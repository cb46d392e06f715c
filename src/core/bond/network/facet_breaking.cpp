// SPDX-License-Identifier: GPL-2.0-or-later
// Points of facets that break: what they still carry and what that costs.
// Scope: see the header.
#include "bond/network/facet_breaking.h"

#include <algorithm>
#include <cmath>

#include "bond/network/border_relief.h"
#include "bond/network/joint_points.h"

namespace muckpile {

SlipThroughBlocks slip_through_blocks(const FacetKinematics& facets, const LeaningFaces* leaning,
                                      std::size_t f) {
  const FacetTables& tables = facets.tables;
  const BondConstants bond = tables.bond(f);
  const Vec3 normal = tables.normal(f);
  SlipThroughBlocks sum{0.0, 0.0};
  const auto add = [&](std::size_t side, int block, double area, const Vec3& opening) {
    const auto b = static_cast<std::size_t>(block);
    const double volume = facets.blocks.volume(b);
    const double share = area * area / (volume * bond.shear * tables.area(f));
    const Vec3 in_plane = opening - normal.dot(opening) * normal;
    sum.dilatations += share * facets.blocks.rock[b].lame_lambda * in_plane.squaredNorm();
    if (!tables.name(f).slanted()[side]) return;
    const double m = opening.norm(), g = leaning->facet(f).lean[side].norm();
    sum.leaning += share * facets.blocks.rock[b].two_g * m * (m + 2.0 * g);
  };
  add(0, tables.i_of(f), bond.area_i, bond.opening_i);
  add(1, tables.j_of(f), bond.area_j, bond.opening_j);
  return sum;
}

namespace {

/// Behind a mirror the image parts by as much, so a block pays half of what a facet takes.
JointParameters toughness_of(const FacetTables& tables, std::size_t f) {
  JointParameters own = tables.parameters(f);
  if (tables.name(f).kind == FacetKind::mirror) own.fracture_energy_tension *= 0.5;
  return own;
}

}  // namespace

struct FacetBreaking::Remnant {
  double normal;      // traction along the normal, not positive [Pa]
  Vec3 shear;         // [Pa]
  Vec3 dropped;       // the rest [Pa]
  Vec3 lost;          // jump that leaves the dilatations [m]
  Vec3 strain_lost;   // what of it counts there [m]
  Cohesion cohesion;  // of a point that softens
  bool slips;         // stays in the dilatations
};

/// Slivers beside large blocks may not: friction would take too many steps to catch up with them.
bool FacetBreaking::may_slip(std::size_t f) const {
  constexpr double kMost = 3.0;  // [-]
  return facets_.tables.is_joint(f) &&
         slip_through_blocks(facets_, parts_.leaning, f).most() < kMost;
}

/// A point that fails in shear while it is closed slips from then on: its traction stays that of
/// the bonded point, with the shear that friction holds. Once it opens, slides away or turns it
/// becomes a contact, as all others do that break.
FacetBreaking::Remnant FacetBreaking::remnant_of(std::size_t f, const PointBreak& broken) const {
  const FacetTables& tables = facets_.tables;
  const ContactConstants contact = tables.contact(f);
  const Vec3& n = broken.normal;
  const auto q = static_cast<std::size_t>(broken.point);
  const bool first = !facets_.history.traces(f).broken[q];
  const double normal = n.dot(broken.traction);
  const Vec3 shear = broken.traction - normal * n;
  Remnant left{};
  left.normal = std::min(normal, 0.0);
  const double limit = friction_of(facets_, f).limit(left.normal, 0.0)[q], size = shear.norm();
  left.shear = (size > limit ? limit / size : 1.0) * shear;
  left.dropped = broken.traction - left.normal * n - left.shear;
  if (tables.laws().softens() && first) left.cohesion = cohesion_of(f, broken, left.dropped);
  left.slips = first && normal < 0.0 && !broken.torn && may_slip(f);
  left.lost = broken.elastic;
  if (left.slips)
    left.lost =
        left.dropped /
        (contact.shear * (1.0 + slip_through_blocks(facets_, parts_.leaning, f).dilatations));
  left.strain_lost = strain_lost(f, broken, left);
  return left;
}

/// What of the jump that leaves the dilatations counts there [m].
Vec3 FacetBreaking::strain_lost(std::size_t f, const PointBreak& broken,
                                const Remnant& left) const {
  const LaneVec normal(broken.normal), jump(broken.elastic), lost(left.lost);
  return of_bonded(facets_, f,
                   [&](const auto& points) {
                     return left.slips ? points.strain_lost(normal, jump, lost)
                                       : points.strained(normal, jump);
                   })
      .at(broken.point);
}

/// What a point that breaks holds on to.
Cohesion FacetBreaking::cohesion_of(std::size_t f, const PointBreak& broken,
                                    const Vec3& dropped) const {
  const ContactConstants contact = facets_.tables.contact(f);
  const Mat3 to_axes = broken.axes.transpose();
  const Vec3 in_axes = to_axes * dropped;
  const Lanes pulled = of_contact(facets_, f, contact, 1.0, [&](const auto& closure) {
    return closure.stiffness_to(Lanes(in_axes.x()));
  });
  const double normal = pulled[static_cast<std::size_t>(broken.point)];
  // At a mirror, which has no shear, nothing along it is dropped: any stiffness will do.
  const double along = contact.shear > 0.0 ? contact.shear : contact.closure.normal;
  return cohesion_after(in_axes, to_axes * broken.jump, normal, along,
                        toughness_of(facets_.tables, f));
}

Vec3 FacetBreaking::break_point(std::size_t f, const PointBreak& broken, double dt) {
  const auto q = static_cast<std::size_t>(broken.point);
  FacetHistory& history = parts_.history;
  const ContactConstants contact = facets_.tables.contact(f);
  const Remnant left = remnant_of(f, broken);
  if (left.cohesion.holds()) history.cohesion_of_point(f, q) = left.cohesion;
  // The contact starts with the compression that the joint carried and the shear that friction can;
  // open by what a point that softens has parted, or one that slipped since its force was none.
  const double normal =
      history.traces(f).broken[q] ? broken.normal.dot(broken.traction) : left.normal;
  Vec3 spring = (contact_gap(facets_, f, contact, normal)[q] +
                 left.cohesion.first * left.cohesion.direction.x()) *
                broken.normal;
  if (contact.shear > 0.0) spring += left.shear / contact.shear;
  const Vec3 rests_at = left.slips ? left.lost : Vec3(broken.jump - spring);
  history.contacts().set_offset(f, q, broken.axes.transpose() * rests_at);
  if (!history.traces(f).broken[q])
    remember_break(facets_, history, f, q, broken.normal, broken.elastic, normal, left.slips);
  parts_.books.losses.fracture += facets_.tables.weight(f) * border_energy(facets_, f);  // it ends
  history.break_point(f, q, left.slips, parts_.keeps_gas);
  parts_.books.newly_cracked = true;
  book_break(f, broken, left, dt);
  drop_from_dilatation(f, broken, left);
  return left.dropped;
}

void FacetBreaking::book_break(std::size_t f, const PointBreak& broken, const Remnant& left,
                               double dt) {
  const BondConstants bond = facets_.tables.bond(f);
  const ContactConstants contact = facets_.tables.contact(f);
  JointLosses& losses = parts_.books.losses;
  const auto q = static_cast<std::size_t>(broken.point);
  const LaneVec facet_normal(broken.normal);
  const auto while_bonded = [&](const Vec3& jump) -> double {  // twice, per area [J/m2]
    return bonded_energy(facets_, f, facet_normal, LaneVec(jump))[q];
  };
  const auto apart = [&]() -> double {
    Vec3 spring = contact_gap(facets_, f, contact, left.normal)[q] * broken.normal;
    if (contact.shear > 0.0) spring += left.shear / contact.shear;
    return contact_energy_of(facets_, f, contact, 1.0, facet_normal, LaneVec(spring))[q];
  };
  double after = left.slips ? while_bonded(broken.elastic - left.lost) : apart();
  // The half kick to the present step used the traction before, the one from it uses that after:
  // the blocks did the work of their mean over the step's path, the springs' account assumes the
  // first. What slips may have shed less than its force has lost, for the path after, too.
  const bool softens = left.cohesion.holds();
  const Vec3 ahead = left.slips ? Vec3(left.dropped - contact.shear * left.lost) : Vec3::Zero();
  const double undone = softens ? 0.0 : (left.dropped + ahead).dot(broken.rate) * dt;
  if (softens) {
    // The sides have parted by `first` beside the stretch of the spring that friction holds.
    const double rubbed = contact.shear > 0.0 ? left.shear.dot(left.dropped) / contact.shear : 0.0;
    losses.friction += contact.weight * bond.point_area * rubbed;
    after += 2.0 * (left.cohesion.energy(left.cohesion.first) + rubbed);
  }
  losses.fracture +=
      0.5 * contact.weight * bond.point_area * (while_bonded(broken.elastic) - after - undone);
  if (left.slips) return;
  const DilatationCoupling coupling = facets_.tables.coupling(f);
  const std::vector<double>& theta = facets_.blocks.theta;
  const double uneven =
      theta[static_cast<std::size_t>(coupling.i)] - theta[static_cast<std::size_t>(coupling.j)];
  const double uncoupled = coupling.sharpening / facets_.history.bonded_points(f);
  losses.fracture += 0.5 * contact.weight * uncoupled * uneven * uneven;
  parts_.tables.set_sharpening(f, coupling.sharpening - uncoupled);
  parts_.history.lose_bonded_point(f);
  if (facets_.history.bonded_points(f) == 0) parts_.schedule.note_change();
}

void FacetBreaking::drop_from_dilatation(std::size_t f, const PointBreak& broken,
                                         const Remnant& left) {
  const BondConstants bond = facets_.tables.bond(f);
  const auto drop = [&](int block, double area_share, const Vec3& opening, double depth) {
    const auto b = static_cast<std::size_t>(block);
    parts_.books.dropped.push_back(
        {b, area_share * opening.dot(left.strain_lost) / kFacetPoints,
         left.slips ? 0.0 : bond.point_area * depth / facets_.blocks.volume(b)});
  };
  const auto [depth_i, depth_j] = facets_.tables.depths(f);
  drop(facets_.tables.i_of(f), bond.area_i, broken.openings.i, depth_i);
  drop(facets_.tables.j_of(f), bond.area_j, broken.openings.j, depth_j);
  if (parts_.leaning != nullptr) parts_.leaning->drop(facets_, f, {left.strain_lost, left.slips});
}

void FacetBreaking::book_step() {
  BlockFields& blocks = parts_.blocks;
  std::vector<JointBooks::Dropped>& dropped = parts_.books.dropped;
  const std::vector<double> theta_before = blocks.theta;
  std::ranges::stable_sort(dropped, {}, &JointBooks::Dropped::block);
  for (auto part = dropped.begin(); part != dropped.end();) {
    const std::size_t b = part->block;
    double bonded = 0.0, unbonded = 0.0;
    for (; part != dropped.end() && part->block == b; ++part) {
      bonded += part->bonded;
      unbonded += part->unbonded;
    }
    const BlockSums before = blocks.sums[b];
    blocks.sums[b].bonded -= bonded;
    blocks.sums[b].unbonded += unbonded;
    if (!blocks.owned(b)) continue;
    parts_.books.losses.fracture +=
        blocks.potential(b, before) - blocks.potential(b, blocks.sums[b]);
    blocks.theta[b] = blocks.dilatation(b);
  }
  dropped.clear();
  note_losses(theta_before);
  book_sharpening(theta_before);
  book_borders(facets_, theta_before, parts_.books.losses);
  if (parts_.leaning != nullptr) parts_.leaning->book(blocks, parts_.books.losses);
}

void FacetBreaking::note_losses(const std::vector<double>& theta_before) {
  BlockFields& blocks = parts_.blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    blocks.theta_lost[b] = blocks.owned(b) ? theta_before[b] - blocks.theta[b] : 0.0;
}

/// The energies are quadratic in both thetas: each rank has booked what follows from the change of
/// its own block alone, and the product of both changes is left.
void FacetBreaking::book_shared_changes() {
  const BlockFields& blocks = parts_.blocks;
  const auto product = [&](std::size_t f) {
    const auto [i, j] = facets_.tables.blocks_of(f);
    return blocks.owned(i) == blocks.owned(j)
               ? 0.0
               : facets_.tables.weight(f) * blocks.theta_lost[i] * blocks.theta_lost[j];
  };
  each_facet(parts_.schedule.bonded(), [&](std::size_t f) {
    parts_.books.losses.fracture += facets_.tables.coupling(f).sharpening * product(f);
  });
  book_shared_borders(facets_, product, parts_.books.losses);
}

/// Books what the energy of uneven dilatation loses as breaking changes theta. The part of a block
/// of another rank is booked there.
void FacetBreaking::book_sharpening(const std::vector<double>& theta_before) {
  const std::vector<double>& theta = facets_.blocks.theta;
  each_facet(parts_.schedule.bonded(), [&](std::size_t f) {
    const DilatationCoupling coupling = facets_.tables.coupling(f);
    const auto i = static_cast<std::size_t>(coupling.i), j = static_cast<std::size_t>(coupling.j);
    const double before = theta_before[i] - theta_before[j], after = theta[i] - theta[j];
    parts_.books.losses.fracture += 0.5 * coupling.sharpening * (before * before - after * after);
  });
}

}  // namespace muckpile
