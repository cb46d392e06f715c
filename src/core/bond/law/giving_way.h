// SPDX-License-Identifier: GPL-2.0-or-later
// Springs of points that give way in a step, where walls crush or faces slip: what walls bear, and
// what is taken for good.
// Scope: pure functions of one point, one per lane; per area of the facet, tension is positive.
#pragma once

#include "math/lanes.h"

namespace muckpile {

/// Walls that crush under a pressure, elastic and perfectly plastic (Thornton 1997): they are
/// pressed no further together than to where they carry it, whatever is beyond stays.
template <class Number>
struct CrushingWalls {
  Number strength;  ///< that pressure; infinite: they do not crush [Pa]

  /// What they bear of a normal traction [Pa].
  [[nodiscard, gnu::always_inline]] Number bear(const Number& normal) const {
    return max(normal, -strength);
  }
};

/// What giving way takes is booked as the work that leapfrog takes from the blocks in the step,
/// that of the mean of the forces before and after its path, less what springs have gained
/// [J/m2]. The point carries `traction` as if it did not give way, of which the blocks get all but
/// `over` [Pa]; then it gives way by `given`, which sheds `stiffness` times that. `path`: by which
/// its sides move apart in the step [m].
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number taken_for_good(const Number& stiffness,
                                                               const Number& traction,
                                                               const Number& over,
                                                               const Number& given,
                                                               const Number& path) {
  const Number half = 0.5 * stiffness * given;
  return given * (traction - half) - (over - half) * path;
}
/// The same where the spring alone gives way, by just what sheds all that is over: twice, over the
/// stiffness [m2]. `whole`: its jump if it did not give way, `after`: what is left of that [m].
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number twice_taken_for_good(const Number& whole,
                                                                     const Number& after,
                                                                     const Number& path) {
  return (whole - after) * (whole + after - path);
}

template <class Number>
[[nodiscard, gnu::always_inline]] inline Number taken_for_good(const Number& stiffness,
                                                               const VectorOf<Number>& traction,
                                                               const VectorOf<Number>& over,
                                                               const VectorOf<Number>& given,
                                                               const VectorOf<Number>& path) {
  return taken_for_good(stiffness, traction.x, over.x, given.x, path.x) +
         taken_for_good(stiffness, traction.y, over.y, given.y, path.y) +
         taken_for_good(stiffness, traction.z, over.z, given.z, path.z);
}
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number twice_taken_for_good(const VectorOf<Number>& whole,
                                                                     const VectorOf<Number>& after,
                                                                     const VectorOf<Number>& path) {
  return twice_taken_for_good(whole.x, after.x, path.x) +
         twice_taken_for_good(whole.y, after.y, path.y) +
         twice_taken_for_good(whole.z, after.z, path.z);
}

}  // namespace muckpile
