// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where it is bonded: tractions, breaking, and what breaking costs.
// Scope: see facet_network.h; formulas are there.
#include <algorithm>
#include <cmath>

#include "bond/network/facet_lanes.h"
#include "bond/network/facet_network.h"

namespace muckpile {

/// Jumps at the points, less what they have slipped [m].
LaneVec FacetNetwork::elastic_jump(std::size_t f, const Motion& motion) const {
  const FacetTraces& memory = traces_[f];
  if (!memory.slipping.any()) return motion.jump();
  const LaneVec slipped = rotated(motion.axes(), lanes_of(contacts_.get(f).offset));
  return motion.jump() - choose(where_slipping(memory), Lanes(1.0), 0.0) * slipped;
}

/// Mean over the facet of the elastic jump where it is in the dilatations [m].
Vec3 FacetNetwork::bonded_jump(std::size_t f, const Motion& motion) const {
  if (states_[f] == FacetState::intact) return motion.mean_jump();
  const LaneMask holds = is_point() && !where_contact(traces_[f]);
  return sum(choose(holds, Lanes(1.0 / kFacetPoints), 0.0) * elastic_jump(f, motion));
}

/// The part of a facet in the dilatation of its blocks.
void FacetNetwork::open_facet(std::size_t f) {
  const Bond bond = bond_of(f);
  const Motion motion = motion_of(f);
  const Openings openings = openings_of(f, motion.scale);
  const Vec3 bonded = bonded_jump(f, motion);
  sums_[static_cast<std::size_t>(i_of(f))].bonded += bond.area_i * openings.i.dot(bonded);
  sums_[static_cast<std::size_t>(j_of(f))].bonded += bond.area_j * openings.j.dot(bonded);
}

void FacetNetwork::tractions(double dt) {
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  std::fill(torque_.begin(), torque_.end(), Vec3::Zero());
  newly_cracked_ = newly_let_go_ = false;
  if (slanted()) pull_slanted();
  work_groups(dt);
  ++calls_;
  load_faces();
  if (has_gas()) add_gas_forces();
  if (newly_cracked_) book_fracture();
}

/// Part of the traction that is the same at all points: of the bulk stresses and the slant [Pa].
Vec3 FacetNetwork::bulk_traction(std::size_t f, const Openings& openings) const {
  const Bond bond = bond_of(f);
  const Vec3 bulk = bond.bulk_i * bulk_stress_[static_cast<std::size_t>(i_of(f))] * openings.i +
                    bond.bulk_j * bulk_stress_[static_cast<std::size_t>(j_of(f))] * openings.j;
  return slanted() ? Vec3(bulk + slant_traction_[f]) : bulk;
}

[[gnu::always_inline]] inline FacetNetwork::Pull FacetNetwork::bonded_pull(
    std::size_t f, const Motion& motion) const {
  const Bond bond = bond_of(f);
  Pull pull(motion);
  const LaneVec jump = elastic_jump(f, motion);
  const LinearClosure<Lanes> closure{bond.shear, bond.normal_extra};
  pull.traction =
      closure.traction(pull.normal, jump) + LaneVec(bulk_traction(f, openings_of(f, motion.scale)));
  return pull;
}

Vec3 FacetNetwork::mean_traction(std::size_t f) const {
  const Bond bond = bond_of(f);
  const Motion motion = motion_of(f);
  return bond.traction(motion.normal, motion.mean_jump()) +
         bulk_traction(f, openings_of(f, motion.scale));
}

[[gnu::always_inline]] inline void FacetNetwork::apply(std::size_t f, double point_area,
                                                       const Pull& pull) {
  const auto i = static_cast<std::size_t>(i_of(f)), j = static_cast<std::size_t>(j_of(f));
  const LaneVec at_points = choose(is_point(), Lanes(point_area), 0.0) * pull.traction;
  const Vec3 force = sum(at_points), moment = sum(cross(pull.arm, at_points));
  force_[i] += force;
  torque_[i] += moment;
  force_[j] -= force;
  torque_[j] -= moment + (state_[i].centre - state_[j].centre).cross(force);
}

/// Forces of any facet: breaks points, and handles broken and damped ones.
void FacetNetwork::work_facet(std::size_t f, double dt) {
  const Motion motion = motion_of(f);
  const Contact contact = contact_of(f);
  const bool bonded = bonded_points_[f] > 0;
  if (!bonded && !closes(f, motion, contact, dt)) return;
  Pull pull = bonded ? bonded_pull(f, motion) : Pull(motion);
  const BlockState& si = state_[static_cast<std::size_t>(i_of(f))];
  const BlockState& sj = state_[static_cast<std::size_t>(j_of(f))];
  // The velocity that block j's rock would have at the centre of block i, less that of block i.
  const Vec3 slip = sj.velocity - si.velocity + sj.spin.cross(si.centre - sj.centre);
  pull.rate = LaneVec(slip) + cross(LaneVec(Vec3(sj.spin - si.spin)), pull.arm);
  if (bonded) {
    work_bonded(f, motion, contact, pull, dt);
    if (bonded_points_[f] == 0 && !closes(f, motion, contact, dt)) return;
  }
  if (bonded_points_[f] < kFacetPoints) add_contact(f, motion, contact, pull, dt);
  if (softens_) add_cohesion(f, motion, pull, dt);
  apply(f, contact.point_area, pull);
}

/// Breaks points that fail, damps the others; the traction of points that have left the dilatations
/// is no longer true.
void FacetNetwork::work_bonded(std::size_t f, const Motion& motion, const Contact& contact,
                               Pull& pull, double dt) {
  const FacetTraces& memory = traces_[f];
  const bool smooth = contact.shear == 0.0;  // a mirror: see slid_along()
  const bool away = (smooth || memory.slipping.any()) && slid_away(motion, contact);
  const bool torn = motion.turned(kTurnStart) || (smooth && away);
  const LaneMask slipping = where_slipping(memory);
  const LaneMask fails =
      torn ? is_point() : failing(f, pull, slipping) || (slipping && LaneMask(away));
  for (int p = 0; p < kFacetPoints; ++p) {
    const auto q = static_cast<std::size_t>(p);
    if (memory.is_contact(q) || !fails[q]) continue;
    const Vec3 traction = pull.traction.at(p);
    const Break broken = {motion.normal,
                          pull.jump.at(p),
                          elastic_jump(f, motion).at(p),
                          traction,
                          pull.rate.at(p),
                          openings_of(f, motion.scale),
                          motion.axes(),
                          torn};
    pull.add(p, -break_point(f, p, broken, dt));
  }
  if (damping_ != 0.0 && !ground_memory(f).yields) {  // that ground has a dashpot itself
    const LaneMask bonded = is_point() && !where_broken(memory);
    const LaneVec rate = choose(bonded, Lanes(1.0), 0.0) * pull.rate;
    pull.traction += Lanes(damping_) * rate;
    losses_.damping += contact.weight * contact.point_area * damping_ * dt * sum(dot(rate, rate));
  }
  if (memory.slipping.any()) rub(f, motion, contact, pull, dt);
}

/// How stiff a facet is against slip through its blocks, over its spring [-].
FacetNetwork::ThroughBlocks FacetNetwork::slip_through_blocks(std::size_t f) const {
  const Bond bond = bond_of(f);
  const Vec3 normal = at_lane(group_of(f).normal, lane_of(f));
  ThroughBlocks sum{0.0, 0.0};
  const auto add = [&](std::size_t side, int block, double area, const Vec3& opening) {
    const double share =
        area * area /
        (blocks_[static_cast<std::size_t>(block)].volume * bond.shear * this->area(f));
    const Vec3 in_plane = opening - normal.dot(opening) * normal;
    sum.dilatations += share * material().lame_lambda() * in_plane.squaredNorm();
    if (!facets_[f].slanted()[side]) return;
    const double m = opening.norm(), g = slants_[f].lean[side].norm();
    sum.slant += share * 2.0 * material().shear_modulus() * m * (m + 2.0 * g);
  };
  add(0, i_of(f), bond.area_i, bond.opening_i);
  add(1, j_of(f), bond.area_j, bond.opening_j);
  return sum;
}

/// Slivers beside large blocks may not: friction would take too many steps to catch up with them.
bool FacetNetwork::may_slip(std::size_t f) const {
  constexpr double kMost = 3.0;  // [-]
  return facets_[f].kind == FacetKind::joint && slip_through_blocks(f).most() < kMost;
}

/// A point that fails in shear while it is closed slips from then on: its traction stays that of
/// the bonded point, with the shear that friction holds. Once it opens, slides away or turns it
/// becomes a contact, as all others do that break.
FacetNetwork::Remnant FacetNetwork::remnant_of(std::size_t f, int p, const Break& broken) const {
  const Contact contact = contact_of(f);
  const Vec3& n = broken.normal;
  const bool first = !traces_[f].broken[static_cast<std::size_t>(p)];
  const double normal = n.dot(broken.traction);
  const Vec3 shear = broken.traction - normal * n;
  Remnant left{};
  left.held = std::min(normal, 0.0);
  const SlipFriction<double> friction{residual_friction(f)};
  const double limit = friction.limit(left.held), size = shear.norm();
  left.shear = (size > limit ? limit / size : 1.0) * shear;
  left.dropped = broken.traction - left.held * n - left.shear;
  if (softens_ && first) {
    const Mat3 to_axes = broken.axes.transpose();
    left.cohesion = cohesion_after(to_axes * left.dropped, to_axes * broken.jump,
                                   contact.closure.normal, contact.shear, material().parameters());
  }
  left.slips = first && normal < 0.0 && !broken.torn && may_slip(f);
  left.lost = broken.elastic;
  if (left.slips)
    left.lost = left.dropped / (contact.shear * (1.0 + slip_through_blocks(f).dilatations));
  return left;
}

/// Returns what the point no longer carries [Pa].
Vec3 FacetNetwork::break_point(std::size_t f, int p, const Break& broken, double dt) {
  const auto q = static_cast<std::size_t>(p);
  const Contact contact = contact_of(f);
  const Remnant left = remnant_of(f, p, broken);
  FacetTraces& memory = traces_[f];
  if (left.cohesion.holds()) rare_.made(f).cohesion[q] = left.cohesion;
  // The contact starts with the compression that the joint carried and the shear that friction can;
  // open by what a point that softens has parted, or one that slipped since its force was none.
  const double normal = memory.broken[q] ? broken.normal.dot(broken.traction) : left.held;
  Vec3 spring = (contact.closure.gap(normal) + left.cohesion.first * left.cohesion.direction.x()) *
                broken.normal;
  if (contact.shear > 0.0) spring += left.shear / contact.shear;
  const Vec3 rests_at = left.slips ? left.lost : Vec3(broken.jump - spring);
  contacts_.set_offset(f, q, broken.axes.transpose() * rests_at);
  memory.broken.set(q);
  memory.slipping.set(q, left.slips);
  if (memory.state == FacetState::intact) {
    memory.state = states_[f] = FacetState::cracked;
    memory.gas = keeps_gas_;  // let go, it stays so when further points break
  }
  newly_cracked_ = true;
  book_break(f, broken, left, dt);
  drop_from_dilatation(f, broken, left);
  return left.dropped;
}

void FacetNetwork::book_break(std::size_t f, const Break& broken, const Remnant& left, double dt) {
  const Bond bond = bond_of(f);
  const Contact contact = contact_of(f);
  const auto bonded_energy = [&](const Vec3& jump) {  // twice, per area [J/m2]
    return bond.twice_energy(jump.squaredNorm(), broken.normal.dot(jump));
  };
  double after = left.slips ? bonded_energy(broken.elastic - left.lost)
                            : contact.closure.twice_energy_of(left.held);
  if (!left.slips && contact.shear > 0.0) after += left.shear.squaredNorm() / contact.shear;
  // The half kick to the present step used the traction before, the one from it uses that after:
  // the blocks did the work of their mean over the step's path, the springs' account assumes the
  // first. What slips may have shed less than its force has lost, for the path after, too.
  const bool softens = left.cohesion.holds();
  const Vec3 ahead = left.slips ? Vec3(left.dropped - contact.shear * left.lost) : Vec3::Zero();
  const double undone = softens ? 0.0 : (left.dropped + ahead).dot(broken.rate) * dt;
  if (softens) {
    // The sides have parted by `first` beside the stretch of the spring that friction holds.
    const double rubbed = left.shear.dot(left.dropped) / contact.shear;
    losses_.friction += contact.weight * bond.point_area * rubbed;
    after += 2.0 * (left.cohesion.energy(left.cohesion.first) + rubbed);
  }
  losses_.fracture +=
      0.5 * contact.weight * bond.point_area * (bonded_energy(broken.elastic) - after - undone);
  if (left.slips) return;
  const Coupling coupling = coupling_of(f);
  const double uneven =
      theta_[static_cast<std::size_t>(coupling.i)] - theta_[static_cast<std::size_t>(coupling.j)];
  const double uncoupled = coupling.sharpening / bonded_points_[f];
  losses_.fracture += 0.5 * contact.weight * uncoupled * uneven * uneven;
  group_of(f).sharpening[lane_of(f)] = coupling.sharpening - uncoupled;
  if (--bonded_points_[f] == 0) ++changed_since_;
}

void FacetNetwork::drop_from_dilatation(std::size_t f, const Break& broken, const Remnant& left) {
  const Bond bond = bond_of(f);
  const auto drop = [&](int block, double area_share, const Vec3& opening, double depth) {
    const auto b = static_cast<std::size_t>(block);
    dropped_.push_back({b, area_share * opening.dot(left.lost) / kFacetPoints,
                        left.slips ? 0.0 : bond.point_area * depth / blocks_[b].volume});
  };
  const auto [depth_i, depth_j] = depths(f);
  drop(i_of(f), bond.area_i, broken.openings.i, depth_i);
  drop(j_of(f), bond.area_j, broken.openings.j, depth_j);
  if (slanted()) drop_from_slant(f, broken, left);
}

void FacetNetwork::book_fracture() {
  const std::vector<double> theta_before = theta_;
  std::ranges::stable_sort(dropped_, {}, &Dropped::block);
  for (auto part = dropped_.begin(); part != dropped_.end();) {
    const std::size_t b = part->block;
    double bonded = 0.0, unbonded = 0.0;
    for (; part != dropped_.end() && part->block == b; ++part) {
      bonded += part->bonded;
      unbonded += part->unbonded;
    }
    const BlockSums before = sums_[b];
    sums_[b].bonded -= bonded;
    sums_[b].unbonded += unbonded;
    if (!blocks_[b].owned) continue;
    losses_.fracture += block_potential(b, before) - block_potential(b, sums_[b]);
    theta_[b] = theta_of(b);
  }
  dropped_.clear();
  book_sharpening(theta_before);
  if (slanted()) book_slant();
  bulk_stresses();
}

/// Books what the energy of uneven dilatation loses as breaking changes theta. The part of a block
/// of another rank is booked there; only the product of both changes is left out.
void FacetNetwork::book_sharpening(const std::vector<double>& theta_before) {
  each_facet(bonded_, [&](std::size_t f) {
    const Coupling coupling = coupling_of(f);
    const auto i = static_cast<std::size_t>(coupling.i), j = static_cast<std::size_t>(coupling.j);
    const double before = theta_before[i] - theta_before[j], after = theta_[i] - theta_[j];
    losses_.fracture += 0.5 * coupling.sharpening * (before * before - after * after);
  });
}

}  // namespace muckpile
