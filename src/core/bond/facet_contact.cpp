// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where it is broken: plane contact while the two faces still match.
// Scope: see facet_network.h and docs/styles/fix_muckpile_joint.md.
#include <algorithm>
#include <cmath>

#include "bond/facet_lanes.h"
#include "bond/facet_network.h"

namespace muckpile {
namespace {

// A broken facet is a plane contact only while its two faces still match. It fades between these
// shares of its radius slid, and of radians turned, and retires once it has opened that far.
constexpr double kSlideStart = 0.1, kSlideEnd = 0.5;
constexpr double kTurnEnd = 0.5;  // from kTurnStart
constexpr double kOpened = 0.1;
constexpr double kNearSlip = 0.99;    // below that share of the friction limit, squared, none slips
constexpr double kSurelyOpen = 0.01;  // opened further than its rotation explains: no point closed

double ramp_down(double x, double start, double end) {
  return std::clamp((end - x) / (end - start), 0.0, 1.0);
}

}  // namespace

/// Of the broken points, whose sides slip by `slip` [m/s].
Lanes FacetNetwork::friction_of(const Contact& contact, const LaneVec& slip) const {
  if (slip_weakening_.speed == 0.0) return contact.tan_residual;
  return sliding_friction(contact.tan_residual, dot(slip, slip), slip_weakening_);
}

/// Tractions of the broken points: no tension, friction, a dashpot along the normal. Friction is
/// booked as the work that leapfrog takes from the blocks, that of the mean of the forces before
/// and after the step's path, less what the springs have gained.
void FacetNetwork::add_contact(std::size_t f, const Motion& motion, const Contact& contact,
                               Pull& pull, double dt) {
  FacetMemory& memory = memory_[f];
  ContactMemory& remembered = memory.contact.made();
  const double fade = remembered.fade;
  const Mat3 axes = motion.axes();
  const LaneMask broken = bonded_points_[f] == 0 ? is_point() : where_true(memory.broken);
  const bool fresh = memory.open;  // open until now: friction forgets where it stuck
  memory.open = false;

  const LaneVec offset = lanes_of(remembered.offset);
  const LaneVec spring = pull.jump - rotated(axes, offset);
  const Lanes gap = dot(pull.normal, spring);
  const LaneMask closed = broken && gap < 0.0;
  const LaneMask forgets = fresh ? broken : broken && !closed;
  const Lanes rate = dot(pull.normal, pull.rate);
  const Lanes elastic = choose(closed, fade * contact.normal * gap, 0.0);
  const Lanes damped = elastic + fade * contact_damping_ * rate;
  const Lanes normal = choose(closed, min(damped, Lanes(0.0)), 0.0);

  const LaneVec sheared = spring - gap * pull.normal;
  const LaneVec stuck = choose(closed && !forgets, Lanes(1.0), 0.0) * sheared;
  const LaneVec shear = Lanes(fade * contact.shear) * stuck;
  const Lanes squared = dot(shear, shear);
  const Lanes limit = -friction_of(contact, pull.rate - rate * pull.normal) * normal;
  LaneMask slips(false);
  Lanes kept = 1.0;
  if (any_of(squared > kNearSlip * limit * limit)) {  // the root takes long
    const Lanes size = sqrt(squared);
    slips = size > limit;
    kept = choose(slips, limit / choose(slips, size, 1.0), 1.0);
  }
  const LaneVec traction = normal * pull.normal + kept * shear;
  pull.traction = choose(broken, traction, pull.traction);

  const double booked = contact.weight * contact.point_area;
  losses_.damping += booked * dt * sum((normal - elastic) * rate);
  if (none_of(slips || forgets)) return;
  const LaneVec sticks_at = rotated_back(axes, pull.jump - gap * pull.normal - kept * stuck);
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    if (slips[p] || forgets[p]) remembered.offset[p] = sticks_at.at(static_cast<int>(p));
  }
  const Lanes slid = (1.0 - kept) * dot(stuck, (1.0 + kept) * stuck - Lanes(dt) * pull.rate);
  const LaneMask opens = forgets && !closed && gap < dt * rate;
  const Lanes forgotten =
      fresh ? Lanes(0.0) : choose(opens, dot(sheared, sheared - Lanes(dt) * pull.rate), 0.0);
  losses_.friction += 0.5 * booked * fade * contact.shear * sum(slid + forgotten);
}

/// Lets a broken facet fade and retire; false if it carries nothing in this step.
bool FacetNetwork::closes(std::size_t f, const Motion& motion, const Contact& contact, double dt) {
  FacetMemory& memory = memory_[f];
  const double opened = dot(LaneVec(motion.normal), motion.apart)[0];
  const Lanes squares = dot(motion.apart, motion.apart);  // of the jump, of how half axes differ
  const double slid = std::max(squares[0] - opened * opened, 0.0);  // [m2]
  if (slid > kSlideStart * kSlideStart * contact.radius_squared || motion.turned(kTurnStart)) {
    fade(f, motion,
         ramp_down(std::sqrt(slid / contact.radius_squared), kSlideStart, kSlideEnd) *
             ramp_down(std::sqrt(motion.turned_squared()), kTurnStart, kTurnEnd));
  }
  if (softens_ && holds_on(f)) return true;
  if (memory.contact.get().fade == 0.0 || contact.longer(opened, kOpened)) {
    newly_let_go_ = newly_let_go_ || memory.state == FacetState::cracked;
    memory.state = states_[f] = FacetState::retired;
    if (!memory.gas) memory.contact.drop();
    ++changed_since_;
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
  FacetMemory& memory = memory_[f];
  const double before = memory.contact.get().fade;
  if (matching >= before) return;
  losses_.friction += facets_[f].weight * (1.0 - matching / before) * contact_energy(f, motion);
  memory.contact.made().fade = matching;
  newly_let_go_ = newly_let_go_ || memory.state == FacetState::cracked;
  memory.state = states_[f] = FacetState::fading;
}

/// Of the closed broken points [J].
double FacetNetwork::contact_energy(std::size_t f, const Motion& motion) const {
  const Contact contact = contact_of(f);
  const ContactMemory& memory = memory_[f].contact.get();
  const Mat3 axes = motion.axes();
  const LaneVec jump = motion.jump();
  double stored = 0.0;
  for (int p = 0; p < kFacetPoints; ++p) {
    const auto q = static_cast<std::size_t>(p);
    if (!memory_[f].broken[q]) continue;
    const Vec3 spring = jump.at(p) - axes * memory.offset[q];
    const double closed = motion.normal.dot(spring);
    if (closed >= 0.0) continue;
    const Vec3 sheared = spring - closed * motion.normal;
    stored += contact.normal * closed * closed + contact.shear * sheared.squaredNorm();
  }
  return 0.5 * contact.point_area * memory.fade * stored;
}

}  // namespace muckpile
