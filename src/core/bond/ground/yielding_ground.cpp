// SPDX-License-Identifier: GPL-2.0-or-later
// The supports of a facet network whose ground yields: which they are, and how their ground moves.
// Scope: see the header.
#include "bond/ground/yielding_ground.h"

#include <algorithm>

namespace muckpile {
namespace {

/// One direction's part of a vector: along the facet's normal, or in its plane.
Vec3 along(const Vec3& v, const Vec3& normal) { return normal.dot(v) * normal; }

bool yields(const FacetHistory& history, std::size_t f) {
  return history.ground(f).yields && history.state(f) == FacetState::intact;
}

/// As Facet::arm_j, before the ground moved: from the origin [m].
Vec3 start_of(const FacetKinematics& facets, std::size_t f) {
  const GroundMemory& ground = facets.history.ground(f);
  return ground.placed ? ground.arm_j : facets.tables.arm_j(f);
}

}  // namespace

/// Behind a support lies the rock of its block.
QuietGround YieldingGround::rock_behind(const FacetTables& tables, std::size_t f) const {
  const JointLaws& laws = tables.laws();
  const std::size_t zone = laws.zoned() ? tables.zone_i(f) : 0;
  return zone == 0 ? rock_ : rock_.of_rock(laws.rock(), laws.rock(zone));
}

bool YieldingGround::exists_in(const FacetHistory& history) {
  for (std::size_t f = 0; f < history.size(); ++f)
    if (yields(history, f)) return true;
  return false;
}

/// Facets come in order of tag_i, so those of one block follow each other.
void YieldingGround::list(const FacetHistory& history) {
  supports_.clear();
  for (std::size_t f = 0; f < history.size(); ++f)
    if (yields(history, f)) supports_.push_back(f);
}

void YieldingGround::drop_broken(const FacetHistory& history) {
  std::erase_if(supports_, [&](std::size_t f) { return history.state(f) != FacetState::intact; });
}

int YieldingGround::let_yield(const FacetKinematics& facets, FacetHistory& history,
                              const std::function<bool(const Vec3&)>& chosen,
                              const std::function<Vec3(std::size_t)>& traction) {
  int more = 0;
  for (std::size_t f = 0; f < history.size(); ++f) {
    if (facets.tables.name(f).kind != FacetKind::fixed || history.state(f) != FacetState::intact)
      continue;
    if (history.ground(f).yields) continue;
    const Vec3 arm_j = start_of(facets, f);
    if (!chosen(arm_j)) continue;  // the ground's centre is the origin
    GroundMemory& memory = history.ground_of_support(f);
    memory.place(arm_j);
    const QuietGround rock = rock_behind(facets.tables, f);
    const Vec3 n = facets.motion(f).normal;
    const Vec3 at = memory.displacement, across = along(at, n);
    memory.yields = true;
    memory.traction = traction(f);
    memory.static_traction =
        memory.traction + rock.normal_stiffness * across + rock.shear_stiffness * (at - across);
    ++more;
  }
  list(history);
  return more;
}

void YieldingGround::yield(const FacetKinematics& facets, const Changes& changes, double dt) const {
  const FacetTables& tables = facets.tables;
  for (std::size_t first = 0; first < supports_.size();) {
    std::size_t last = first + 1;
    while (last < supports_.size() && tables.i_of(supports_[last]) == tables.i_of(supports_[first]))
      ++last;
    yield_beside_block(facets, changes, first, last, dt);
    first = last;
  }
}

/// Where the ground of a support would end without traction, and how the facet answers.
struct YieldingGround::Plan {
  Vec3 normal, jump;               ///< of the facet [-], [m]
  double normal_end, normal_give;  ///< predicted displacement [m], compliance [m/Pa]
  Vec3 shear_end;                  ///< in the facet's plane [m]
  double shear_give;               ///< [m/Pa]
  double opened;                   ///< normal jump if the ground ended as predicted [m]
  double yielding;                 ///< 1 + normal stiffness x compliance [-]
};

YieldingGround::Plan YieldingGround::plan(const FacetKinematics& facets, std::size_t f,
                                          double dt) const {
  const GroundMemory& memory = facets.history.ground(f);
  const FacetMotion motion = facets.motion(f);
  const BondConstants bond = facets.tables.bond(f);
  const Vec3& n = motion.normal;
  const double moved = n.dot(memory.displacement);
  const QuietGround rock = rock_behind(facets.tables, f);
  const GroundStep normal = ground_step(rock.normal_impedance, rock.normal_stiffness, moved,
                                        n.dot(memory.traction), n.dot(memory.static_traction), dt);
  Plan plan;
  plan.normal_end = normal.predicted;
  plan.normal_give = normal.compliance;
  for (int k = 0; k < 3; ++k) {
    const GroundStep shear =
        ground_step(rock.shear_impedance, rock.shear_stiffness, memory.displacement[k],
                    memory.traction[k], memory.static_traction[k], dt);
    plan.shear_end[k] = shear.predicted;
    plan.shear_give = shear.compliance;
  }
  plan.shear_end -= along(plan.shear_end, n);
  plan.normal = n;
  plan.jump = motion.mean_jump();
  plan.opened = n.dot(plan.jump) + plan.normal_end - moved;
  plan.yielding = 1.0 + bond.normal() * plan.normal_give;
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
void YieldingGround::yield_beside_block(const FacetKinematics& facets, const Changes& changes,
                                        std::size_t first, std::size_t last, double dt) const {
  const FacetTables& tables = facets.tables;
  const auto b = static_cast<std::size_t>(tables.i_of(supports_[first]));
  const double lambda = facets.blocks.rock[b].lame_lambda;
  const BlockSums& sums = changes.sums[b];
  double opened = sums.bonded + sums.loaded;
  double volume = facets.blocks.stiffened_volume(b, sums);
  for (std::size_t y = first; y < last; ++y) {
    const std::size_t f = supports_[y];
    const Plan to = plan(facets, f, dt);
    const BondConstants bond = tables.bond(f);
    const double area = bond.area_i;
    opened += area * (to.opened / to.yielding - to.normal.dot(to.jump));
    volume += area * to.normal_give * bond.bulk_i * lambda / to.yielding;
  }
  for (std::size_t y = first; y < last; ++y)
    yield_support(facets, changes, supports_[y], lambda * opened / volume, dt);
}

/// Moves the ground of one support to the end of the step, given the block's bulk stress there.
void YieldingGround::yield_support(const FacetKinematics& facets, const Changes& changes,
                                   std::size_t f, double bulk_stress, double dt) const {
  const BondConstants bond = facets.tables.bond(f);
  GroundMemory& memory = changes.history.ground_of_support(f);
  const Plan to = plan(facets, f, dt);
  const Vec3& n = to.normal;
  const double pull = (bond.normal() * to.opened + bond.bulk_i * bulk_stress) / to.yielding;
  const Vec3 sheared = to.jump - memory.displacement;
  const Vec3 drag = bond.shear / (1.0 + bond.shear * to.shear_give) *
                    (sheared - along(sheared, n) + to.shear_end);
  const Vec3 step = (to.normal_end - to.normal_give * pull) * n + to.shear_end -
                    to.shear_give * drag - memory.displacement;
  const Vec3 traction = pull * n + drag;
  book(facets, changes.losses, f, step, 0.5 * (memory.traction + traction), dt);
  memory.displacement += step;
  memory.traction = traction;
  changes.tables.set_arm_j(f, memory.arm_j + memory.displacement);
  changes.sums[static_cast<std::size_t>(facets.tables.i_of(f))].bonded += bond.area_i * n.dot(step);
}

void YieldingGround::book(const FacetKinematics& facets, JointLosses& losses, std::size_t f,
                          const Vec3& step, const Vec3& traction, double dt) const {
  if (dt <= 0.0) return;
  const QuietGround rock = rock_behind(facets.tables, f);
  const double booked = facets.tables.weight(f) * facets.tables.area(f);
  const double normal = facets.motion(f).normal.dot(step);
  losses.quiet -= booked * traction.dot(step);
  losses.radiated += booked / dt *
                     (rock.normal_impedance * normal * normal +
                      rock.shear_impedance * (step.squaredNorm() - normal * normal));
}

}  // namespace muckpile
