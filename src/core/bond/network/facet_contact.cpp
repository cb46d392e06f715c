// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where it is broken: plane contact while the two faces still match.
// Scope: see facet_network.h and docs/styles/fix_muckpile_joint.md.
#include <algorithm>
#include <cmath>

#include "bond/law/plane_contact.h"
#include "bond/network/facet_lanes.h"
#include "bond/network/facet_network.h"

namespace muckpile {
namespace {

/// Square of the mean slide of a facet's sides [m2].
double slid_squared(const LaneVec& apart, const Vec3& normal) {
  const double opened = dot(LaneVec(normal), apart)[0];
  return std::max(dot(apart, apart)[0] - opened * opened, 0.0);
}

}  // namespace

/// Tractions of the points that have left the dilatations.
void FacetNetwork::add_contact(std::size_t f, const Motion& motion, const Contact& contact,
                               Pull& pull, double dt) {
  FacetTraces& memory = traces_[f];
  const double fade = contacts_.fade(f), shear = fade * contact.shear;
  const Mat3 axes = motion.axes();
  const LaneMask broken = bonded_points_[f] == 0 ? is_point() : where_contact(memory);
  const LaneVec spring = pull.jump - rotated(axes, lanes_of(contacts_.get(f).offset));
  const auto at_points =
      plane_pull<Lanes>({{fade * contact.closure.normal},
                         shear,
                         fade * contact_damping_,
                         {residual_friction(f), slip_weakening_}},
                        {pull.normal, spring, pull.rate, broken, LaneMask(memory.open)}, dt);
  memory.open = false;
  pull.traction = choose(broken, at_points.traction, pull.traction);
  const double booked = contact.weight * contact.point_area;
  losses_.damping += booked * dt * sum(at_points.damped);
  losses_.friction += 0.5 * booked * shear * sum(at_points.rubbed);
  if (none_of(at_points.rests)) return;
  const LaneVec offset = rotated_back(axes, pull.jump - at_points.resting);
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (at_points.rests[p]) contacts_.set_offset(f, p, offset.at(static_cast<int>(p)));
}

/// Friction and the dashpot of the points that slip, which stay in the dilatations: their normal
/// law is that of the bonded point. Losses as those of plane_pull(), of a spring as stiff as the
/// facet and its dilatations.
void FacetNetwork::rub(std::size_t f, const Motion& motion, const Contact& contact, Pull& pull,
                       double dt) {
  const FacetTraces& memory = traces_[f];
  const LaneMask slipping = where_slipping(memory);
  const Lanes rate = dot(pull.normal, pull.rate);
  const Lanes elastic = choose(slipping, dot(pull.normal, pull.traction), 0.0);
  const Lanes normal = min(elastic + choose(slipping, contact_damping_ * rate, 0.0), Lanes(0.0));
  const LaneVec shear = choose(slipping, Lanes(1.0), 0.0) * pull.traction - elastic * pull.normal;
  const LaneVec slip = pull.rate - rate * pull.normal;
  const SlipFriction<Lanes> friction{residual_friction(f), slip_weakening_};
  const auto [slips, kept] = Slide<Lanes>(shear, friction.limit(normal, dot(slip, slip)));
  pull.traction = choose(slipping, normal * pull.normal + kept * shear, pull.traction);

  const double booked = contact.weight * contact.point_area;
  losses_.damping += booked * dt * sum((normal - elastic) * rate);
  if (none_of(slips)) return;
  const LaneVec over = (1.0 - kept) * shear;
  const ThroughBlocks through = slip_through_blocks(f);
  const LaneVec slid = slip_share(through.most(), contact, over, pull.rate, dt) * (1.0 - kept) /
                       contact.shear * shear;
  const LaneVec in_axes = rotated_back(motion.axes(), slid);
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (slips[p])
      contacts_.set_offset(f, p, contacts_.offset(f, p) + in_axes.at(static_cast<int>(p)));
  const double stiffness = contact.shear * (1.0 + through.dilatations);
  const LaneVec mean = over - Lanes(0.5 * stiffness) * slid;
  losses_.friction += booked * sum(dot(slid, kept * shear + mean) - dt * dot(mean, pull.rate));
}

/// How much of the slip by which the spring alone would shed what friction cannot hold (`over`) is
/// taken in this step: all, but where shear works through the blocks, too. There the facets of a
/// block that slip would overshoot together. So all that the sides have moved in the step, which
/// leaves the traction as it is, and of the rest what is stable if three facets do so at once, one
/// in each direction.
Lanes FacetNetwork::slip_share(double through, const Contact& contact, const LaneVec& over,
                               const LaneVec& rate, double dt) {
  constexpr double kHardly = 0.1, kAtOnce = 3.0;  // [-]
  if (through < kHardly) return 1.0;
  if (dt == 0.0) return 0.0;  // the pose of the last step, looked at again as a run goes on
  const double eased = 1.0 / (1.0 + kAtOnce * through);
  const Lanes moved = contact.shear * dt * dot(over, rate);
  const Lanes whole = max(dot(over, over), Lanes(1e-300));  // 0 at points that stick
  return eased + (1.0 - eased) * min(max(moved / whole, Lanes(0.0)), Lanes(1.0));
}

/// Whether a facet has slid so far that it begins to fade.
bool FacetNetwork::slid_away(const Motion& motion, const Contact& contact) {
  return slid_squared(motion.apart, motion.normal) >
         kSlideStart * kSlideStart * contact.radius_squared;
}

/// Lets a broken facet fade and retire; false if it carries nothing in this step.
bool FacetNetwork::closes(std::size_t f, const Motion& motion, const Contact& contact, double dt) {
  FacetTraces& memory = traces_[f];
  const double opened = dot(LaneVec(motion.normal), motion.apart)[0];
  const Lanes squares = dot(motion.apart, motion.apart);  // of the jump, of how half axes differ
  const double slid = slid_squared(motion.apart, motion.normal);
  if (slid > kSlideStart * kSlideStart * contact.radius_squared || motion.turned(kTurnStart)) {
    fade(f, motion,
         matching_faces(std::sqrt(slid / contact.radius_squared),
                        std::sqrt(motion.turned_squared())));
  }
  if (softens_ && holds_on(f)) return true;
  if (contacts_.fade(f) == 0.0 || contact.longer(opened, kOpened)) {
    retire(f);
    return false;
  }
  if (!contact.longer(opened, kSurelyOpen)) return true;
  const Lanes lengths = sqrt(squares);
  const double radius = contact.radius();
  const double tilted = std::sqrt(slid * motion.turned_squared()) + kSurelyOpen * radius;
  const double gap = opened - lengths[1] - lengths[2] - tilted;
  if (gap <= 0.0) return true;
  memory.open = true;
  let_sleep(f, gap, radius, dt);
  return false;
}

void FacetNetwork::retire(std::size_t f) {
  FacetTraces& memory = traces_[f];
  newly_let_go_ = newly_let_go_ || memory.state == FacetState::cracked;
  memory.state = states_[f] = FacetState::retired;
  if (!memory.gas) contacts_.drop(f);
  ++changed_since_;
}

/// Leaves an open facet alone for as long as its gap lasts at twice the present speed of approach,
/// for a bounded time, because other forces may change that speed.
void FacetNetwork::let_sleep(std::size_t f, double gap, double radius, double dt) {
  const BlockState& si = state_[static_cast<std::size_t>(i_of(f))];
  const BlockState& sj = state_[static_cast<std::size_t>(j_of(f))];
  const double reach =
      at_lane(group_of(f).arm, lane_of(f)).norm() + depths(f).second + 3.0 * radius;
  const double speed =
      (sj.velocity - si.velocity).norm() + (si.spin.norm() + sj.spin.norm()) * reach;
  if (dt <= 0.0) return;
  const double steps = 0.5 * gap / (std::max(speed, 1e-30) * dt);
  asleep_[f] = calls_ + 1 +
               static_cast<std::uint32_t>(std::min(steps, material().parameters().longest_sleep));
}

/// A facet whose faces match less than before gives up spring energy, which is booked as friction.
void FacetNetwork::fade(std::size_t f, const Motion& motion, double matching) {
  FacetTraces& memory = traces_[f];
  const double before = contacts_.fade(f);
  if (matching >= before) return;
  losses_.friction += facets_[f].weight * (1.0 - matching / before) * contact_energy(f, motion);
  contacts_.set_fade(f, matching);
  newly_let_go_ = newly_let_go_ || memory.state == FacetState::cracked;
  memory.state = states_[f] = FacetState::fading;
}

/// Of the closed broken points [J].
double FacetNetwork::contact_energy(std::size_t f, const Motion& motion) const {
  const Contact contact = contact_of(f);
  const ContactMemory memory = contacts_.get(f);
  const Mat3 axes = motion.axes();
  const LaneVec jump = motion.jump();
  double stored = 0.0;
  for (int p = 0; p < kFacetPoints; ++p) {
    const auto q = static_cast<std::size_t>(p);
    if (!traces_[f].is_contact(q)) continue;
    const Vec3 spring = jump.at(p) - axes * memory.offset[q];
    const double closed = motion.normal.dot(spring);
    if (closed >= 0.0) continue;
    const Vec3 sheared = spring - closed * motion.normal;
    stored += contact.closure.twice_energy(closed) + contact.shear * sheared.squaredNorm();
  }
  return 0.5 * contact.point_area * memory.fade * stored;
}

}  // namespace muckpile
