// SPDX-License-Identifier: GPL-2.0-or-later
// The contact of broken points while the two faces still match: no tension, friction, a dashpot
// along the normal, walls that may crush.
// Scope: a pure function of a point, one per lane: the points of one facet, or one of each of a
// group's facets. Formulas are in docs/styles/fix_muckpile_joint.md.
#pragma once

#include "bond/law/giving_way.h"
#include "bond/law/linear_closure.h"
#include "bond/law/slip_friction.h"
#include "math/lanes.h"

namespace muckpile {

template <class Number, class Closure, class Friction>
struct PlaneContact {
  Closure closure;
  Number shear;    ///< stiffness [Pa/m]
  Number dashpot;  ///< along the normal [Pa s/m]
  Friction friction;
};

/// A point in the present pose.
template <class Number>
struct PlanePoint {
  VectorOf<Number> normal;
  VectorOf<Number> spring;  ///< jump from where the point carries nothing [m]
  VectorOf<Number> rate;    ///< of the jump [m/s]
  typename Number::mask_type broken;
  typename Number::mask_type fresh;  ///< open until now: friction forgets where it stuck
};

template <class Number>
struct PlanePull {
  VectorOf<Number> traction;          ///< [Pa]
  typename Number::mask_type yields;  ///< it slips, crushes or is open: the spring gives way,
  VectorOf<Number> elastic;           ///< and of its jump only this stays [m]
  Number damped;                      ///< taken by the dashpot [W/m2]
  Number rubbed;                      ///< twice what friction takes in the step, over shear [m2]
  Number crushed;                     ///< and what walls that crush take, over their stiffness [m2]
};

/// A closure whose walls crush.
template <class Closure>
concept Crushing = requires(const Closure& closure) {
  closure.deepest;
};

/// Which points slip, and the share of their shear that friction holds.
template <class Number>
struct Slide {
  typename Number::mask_type slips{false};
  Number kept = 1.0;

  [[gnu::always_inline]] Slide(const VectorOf<Number>& shear, const Number& limit) {
    constexpr double kNearSlip = 0.99;  // of the limit, squared: below that none slips
    const Number squared = dot(shear, shear);
    if (none_of(squared > kNearSlip * limit * limit)) return;  // the root takes long
    const Number size = sqrt(squared);
    slips = size > limit;
    kept = choose(slips, limit / choose(slips, size, 1.0), 1.0);
  }
};

/// What friction and crushing take: giving_way.h.
template <class Number, class Closure, class Friction>
[[nodiscard, gnu::always_inline]] inline PlanePull<Number> plane_pull(
    const PlaneContact<Number, Closure, Friction>& contact, const PlanePoint<Number>& at,
    double dt) {
  using Mask = typename Number::mask_type;
  const Number whole = dot(at.normal, at.spring);
  Number gap = whole;
  if constexpr (Crushing<Closure>) gap = max(whole, contact.closure.deepest);
  const Number pressed = contact.closure.traction(gap);
  const Mask closed = at.broken && pressed < 0.0;
  const Mask forgets = at.broken && (at.fresh || !closed);
  const Number rate = dot(at.normal, at.rate);
  const Number by_spring = choose(closed, pressed, 0.0);
  const Number damped = by_spring + contact.dashpot * rate;
  Number normal = choose(closed, min(damped, Number(0.0)), 0.0), crushed = 0.0;
  Mask yields = forgets;
  if constexpr (Crushing<Closure>) {
    const Mask crushes = closed && whole < gap;
    normal = contact.closure.walls().bear(normal);
    const Number path = dt * rate, before = min(whole - path, Number(0.0));  // 0: it was open
    crushed = choose(crushes, twice_taken_for_good(before + path, gap, path), 0.0);
    yields = yields || crushes;
  }

  const VectorOf<Number> sheared = at.spring - whole * at.normal;
  const VectorOf<Number> stuck = choose(closed && !forgets, Number(1.0), 0.0) * sheared;
  const VectorOf<Number> shear = contact.shear * stuck, slip = at.rate - rate * at.normal;
  const Slide<Number> slide(shear, contact.friction.limit(normal, dot(slip, slip)));
  const VectorOf<Number> kept = slide.kept * stuck, path = Number(dt) * at.rate;
  Number rubbed = 0.0;
  if (any_of(slide.slips)) rubbed = twice_taken_for_good(stuck, kept, path);
  const Mask opens = forgets && !at.fresh && !closed && gap < dt * rate;
  if (any_of(opens))
    rubbed += choose(opens, twice_taken_for_good(sheared, VectorOf<Number>(), path), 0.0);
  return {normal * at.normal + slide.kept * shear,
          slide.slips || yields,
          gap * at.normal + kept,
          (normal - by_spring) * rate,
          rubbed,
          crushed};
}

}  // namespace muckpile
