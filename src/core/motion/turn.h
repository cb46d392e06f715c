// SPDX-License-Identifier: GPL-2.0-or-later
// How a free rigid body turns in a step: Richardson's rotation, as LIGGGHTS and LAMMPS have it.
// Scope: Number is a simd type, one body per lane. Second order in the step; quaternions stay unit.
#pragma once

#include "math/lanes.h"

namespace muckpile {

/// Unit quaternions: real part, vector.
template <class Number>
struct QuaternionOf {
  Number w = 1.0;
  VectorOf<Number> v;
};

template <class Number>
[[nodiscard, gnu::always_inline]] inline QuaternionOf<Number> normalised(
    const QuaternionOf<Number>& q) {
  const Number scale = inverse_root(q.w * q.w + dot(q.v, q.v));
  return {scale * q.w, scale * q.v};
}

/// Columns are the body's axes in space.
template <class Number>
[[nodiscard, gnu::always_inline]] inline MatrixOf<Number> axes_of(const QuaternionOf<Number>& q) {
  const auto &w = q.w, &x = q.v.x, &y = q.v.y, &z = q.v.z;
  const Number ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const Number xy = x * y, xz = x * z, yz = y * z, wx = w * x, wy = w * y, wz = w * z;
  const Number two = 2.0;
  return {{ww + xx - yy - zz, two * (xy + wz), two * (xz - wy)},
          {two * (xy - wz), ww - xx + yy - zz, two * (yz + wx)},
          {two * (xz + wy), two * (yz - wx), ww - xx - yy + zz}};
}

template <class Number>
[[nodiscard, gnu::always_inline]] inline VectorOf<Number> by_components(const VectorOf<Number>& a,
                                                                        const VectorOf<Number>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// Angular velocity in space [rad/s] of angular momentum `momentum` [kg m2/s] in space; per
/// principal moment its inverse [1/(kg m2)].
template <class Number>
[[nodiscard, gnu::always_inline]] inline VectorOf<Number> spin_of(
    const MatrixOf<Number>& axes, const VectorOf<Number>& momentum,
    const VectorOf<Number>& inverse_inertia) {
  return axes * by_components(axes.back(momentum), inverse_inertia);
}

/// How a body lies after a step, and its spin of mid-step in space [rad/s].
template <class Number>
struct TurnedOf {
  QuaternionOf<Number> pose;
  MatrixOf<Number> axes;
  VectorOf<Number> spin;
};

/// A step at constant angular momentum in space. In the body that momentum L turns by
/// dL/dt = L x spin (Euler); the spin of mid-step is that of the midpoint rule, iterated twice. The
/// body turns about it by the angle 2 atan(t + t^3 / 3), t = spin step / 2: off by its fifth power.
/// The axis of that turn is the same before and after it, so the new axes give the spin in space.
template <class Number>
[[nodiscard, gnu::always_inline]] inline TurnedOf<Number> turned(
    const QuaternionOf<Number>& q, const VectorOf<Number>& momentum,
    const VectorOf<Number>& inverse_inertia, double step) {
  const Number half = 0.5 * step;
  const VectorOf<Number> start = axes_of(q).back(momentum);
  VectorOf<Number> spin = by_components(start, inverse_inertia), middle = start;
  for (int k = 0; k < 2; ++k) {
    middle = start + half * cross(middle, spin);
    spin = by_components(middle, inverse_inertia);
  }
  const VectorOf<Number> t = half * spin;
  const VectorOf<Number> turn = (1.0 + dot(t, t) * (1.0 / 3.0)) * t;
  TurnedOf<Number> after;
  after.pose =
      normalised(QuaternionOf<Number>{q.w - dot(q.v, turn), q.v + q.w * turn + cross(q.v, turn)});
  after.axes = axes_of(after.pose);
  after.spin = after.axes * spin;
  return after;
}

}  // namespace muckpile
