// SPDX-License-Identifier: GPL-2.0-or-later
// The rock behind a supported boundary facet: constants of the rock, and the part of the facet
// network that moves the ground of its yielding supports.
// Scope: see quiet_ground.h and facet_network.h.
#include "bond/ground/quiet_ground.h"

#include <string>

#include "args/input_error.h"
#include "bond/network/facet_lanes.h"
#include "bond/network/facet_network.h"

namespace muckpile {

QuietGround::QuietGround(const JointMaterial& rock, double rock_behind) {
  if (!(rock_behind > 0.0))
    throw InputError("rock_behind must be > 0 m, got '" + std::to_string(rock_behind) + "'");
  const double density = rock.parameters().density;
  normal_impedance = density * rock.p_wave_speed();
  shear_impedance = density * rock.s_wave_speed();
  normal_stiffness = rock.p_wave_modulus() / rock_behind;
  shear_stiffness = rock.shear_modulus() / rock_behind;
}

namespace {

/// One direction's part of a vector: along the facet's normal, or in its plane.
Vec3 along(const Vec3& v, const Vec3& normal) { return normal.dot(v) * normal; }

}  // namespace

int FacetNetwork::let_ground_yield(const QuietGround& ground,
                                   const std::function<bool(const Vec3&)>& chosen) {
  quiet_ground_ = ground;
  int more = 0;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (facets_[f].kind != FacetKind::fixed || states_[f] != FacetState::intact) continue;
    if (ground_memory(f).yields) continue;
    if (!chosen(facet(f).arm_j)) continue;  // the ground's centre is the origin
    const Vec3 arm_j = facet(f).arm_j;
    GroundMemory& memory = rare_.made(f).ground;
    memory.place(arm_j);
    const Vec3 n = motion_of(f).normal;
    const Vec3 at = memory.displacement, across = along(at, n);
    memory.yields = true;
    memory.traction = mean_traction(f);
    memory.held =
        memory.traction + ground.normal_stiffness * across + ground.shear_stiffness * (at - across);
    ++more;
  }
  list_yielding();
  return more;
}

void FacetNetwork::stop_ground() {
  rare_.each([](RareMemory& memory) { memory.ground.yields = false; });
  yielding_.clear();
}

/// Facets come in order of tag_i, so those of one block follow each other.
void FacetNetwork::list_yielding() {
  yielding_.clear();
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (ground_memory(f).yields && states_[f] == FacetState::intact) yielding_.push_back(f);
  }
}

void FacetNetwork::yield_ground(double dt) {
  for (std::size_t first = 0; first < yielding_.size();) {
    std::size_t last = first + 1;
    while (last < yielding_.size() && i_of(yielding_[last]) == i_of(yielding_[first])) ++last;
    yield_block_ground(first, last, dt);
    first = last;
  }
}

/// Where the ground of a support would end without traction, and how the facet answers.
struct FacetNetwork::GroundPlan {
  Vec3 normal, jump;               ///< of the facet [-], [m]
  double normal_end, normal_give;  ///< predicted displacement [m], compliance [m/Pa]
  Vec3 shear_end;                  ///< in the facet's plane [m]
  double shear_give;               ///< [m/Pa]
  double opened;                   ///< normal jump if the ground ended as predicted [m]
  double yielding;                 ///< 1 + normal stiffness x compliance [-]
};

FacetNetwork::GroundPlan FacetNetwork::plan_ground(std::size_t f, double dt) const {
  const GroundMemory& memory = ground_memory(f);
  const QuietGround& q = quiet_ground_;
  const Motion motion = motion_of(f);
  const Vec3& n = motion.normal;
  const double moved = n.dot(memory.displacement);
  const GroundStep normal = ground_step(q.normal_impedance, q.normal_stiffness, moved,
                                        n.dot(memory.traction), n.dot(memory.held), dt);
  GroundPlan plan;
  plan.normal_end = normal.predicted;
  plan.normal_give = normal.compliance;
  for (int k = 0; k < 3; ++k) {
    const GroundStep shear =
        ground_step(q.shear_impedance, q.shear_stiffness, memory.displacement[k],
                    memory.traction[k], memory.held[k], dt);
    plan.shear_end[k] = shear.predicted;
    plan.shear_give = shear.compliance;
  }
  plan.shear_end -= along(plan.shear_end, n);
  plan.normal = n;
  plan.jump = motion.mean_jump();
  plan.opened = n.dot(plan.jump) + plan.normal_end - moved;
  plan.yielding = 1.0 + bond_of(f).normal() * plan.normal_give;
  return plan;
}

/// The traction at the end of the step depends on where the ground is then and, through the
/// dilatation, on the block's other yielding supports. With U the normal jump if the ground ended
/// as predicted, k the normal stiffness, c the traction per dilatation, e the area that strains the
/// block, a the compliance of the step, V and S the block's volume and 1 + phi lambda/(2G):
///     t = (k U + c theta) / (1 + k a),
///     theta [V S + sum e a c/(1 + k a)] = sums over all other facets and faces + sum e U/(1 + k
///     a).
/// Beside fixed supports the bulk stress is lambda theta.
void FacetNetwork::yield_block_ground(std::size_t first, std::size_t last, double dt) {
  const auto b = static_cast<std::size_t>(i_of(yielding_[first]));
  const double lambda = material().lame_lambda();
  double opened = sums_[b].bonded + sums_[b].loaded;
  double volume = blocks_[b].volume * stiffening(sums_[b]);
  for (std::size_t y = first; y < last; ++y) {
    const std::size_t f = yielding_[y];
    const GroundPlan plan = plan_ground(f, dt);
    const double area = bond_of(f).area_i;
    opened += area * (plan.opened / plan.yielding - plan.normal.dot(plan.jump));
    volume += area * plan.normal_give * bond_of(f).bulk_i * lambda / plan.yielding;
  }
  for (std::size_t y = first; y < last; ++y)
    yield_support(yielding_[y], lambda * opened / volume, dt);
}

/// Moves the ground of one support to the end of the step, given the block's bulk stress there.
void FacetNetwork::yield_support(std::size_t f, double bulk_stress, double dt) {
  const Bond bond = bond_of(f);
  GroundMemory& memory = rare_.made(f).ground;
  const GroundPlan plan = plan_ground(f, dt);
  const Vec3& n = plan.normal;
  const double pull = (bond.normal() * plan.opened + bond.bulk_i * bulk_stress) / plan.yielding;
  const Vec3 sheared = plan.jump - memory.displacement;
  const Vec3 drag = bond.shear / (1.0 + bond.shear * plan.shear_give) *
                    (sheared - along(sheared, n) + plan.shear_end);
  const Vec3 step = (plan.normal_end - plan.normal_give * pull) * n + plan.shear_end -
                    plan.shear_give * drag - memory.displacement;
  const Vec3 traction = pull * n + drag;
  book_ground(f, step, 0.5 * (memory.traction + traction), dt);
  memory.displacement += step;
  memory.traction = traction;
  set_lane(group_of(f).arm_j, lane_of(f), memory.arm_j + memory.displacement);
  sums_[static_cast<std::size_t>(i_of(f))].bonded += bond_of(f).area_i * n.dot(step);
}

void FacetNetwork::book_ground(std::size_t f, const Vec3& step, const Vec3& traction, double dt) {
  if (dt <= 0.0) return;
  const double booked = facets_[f].weight * area(f), normal = motion_of(f).normal.dot(step);
  losses_.quiet -= booked * traction.dot(step);
  losses_.radiated += booked / dt *
                      (quiet_ground_.normal_impedance * normal * normal +
                       quiet_ground_.shear_impedance * (step.squaredNorm() - normal * normal));
}

}  // namespace muckpile
