// SPDX-License-Identifier: GPL-2.0-or-later
// How far the two sides of a facet have turned and parted, and what follows of it: whether it still
// holds, matches, may touch.
// Scope: pure functions of one facet (Number: double) or of the facets of a group (Wide), one per
// lane. Limits are those of facet_points.h.
#pragma once

#include <algorithm>
#include <cmath>

#include "bond/network/facet_points.h"
#include "math/vectors.h"

namespace muckpile {

/// A facet's own axes, which turn with the mean of the two blocks, as the jump between points on
/// both of them does. What broken points remember turns so: turned by one block, a facet that has
/// slid and then tilts would do work that no spring stores.
template <class Vector>
struct FacetAxes {
  Vector normal;
  Vector along;   ///< the first half axis, of both sides together
  Vector across;  ///< normal x along

  [[gnu::always_inline]] FacetAxes(const Vector& facet_normal, const Vector& half)
      : normal(facet_normal), along(unit_along(half)), across(cross(normal, along)) {}

 private:
  [[nodiscard, gnu::always_inline]] Vector unit_along(const Vector& half) const {
    using std::sqrt;
    const Vector in_plane = half - dot(normal, half) * normal;
    return 1.0 / sqrt(dot(in_plane, in_plane)) * in_plane;
  }
};

/// By how much the half axes of the two sides differ: squares, and those of the half axes [m2].
template <class Number>
struct FacetTurn {
  Number apart_1, apart_2, length_1, length_2;

  /// Whether they have turned by more than `angle` [rad]; without a division.
  [[nodiscard, gnu::always_inline]] auto exceeds(double angle) const {
    return apart_1 * length_2 + apart_2 * length_1 > Number(angle * angle) * length_1 * length_2;
  }
  /// Square of the angle between the two blocks, while small [rad2].
  [[nodiscard, gnu::always_inline]] Number squared() const {
    return apart_1 / length_1 + apart_2 / length_2;
  }
};

/// The square of what a jump has across a normal, by its own square and by its part along.
template <class Number>
[[nodiscard, gnu::always_inline]] inline Number across_squared(const Number& jump_squared,
                                                               const Number& along) {
  using std::max;
  return max(jump_squared - along * along, Number(0.0));
}

template <class Number>
struct FacetParting {
  Number opened;          ///< of the centroids, along the normal [m]
  Number slid;            ///< across, its square [m2]
  Number radius_squared;  ///< of the circle of equal area [m2]
  FacetTurn<Number> turn;

  /// So far that broken faces begin to fade by it.
  [[nodiscard, gnu::always_inline]] auto slid_away() const {
    return slid > kSlideStart * kSlideStart * radius_squared;
  }
  [[nodiscard, gnu::always_inline]] auto begins_to_fade() const {
    return slid_away() || turn.exceeds(kTurnStart);
  }
  [[nodiscard, gnu::always_inline]] auto open_by(double radii) const {
    return opened > 0.0 && opened * opened > radii * radii * radius_squared;
  }
  /// Whether broken faces have come apart for good. `closes_at`: opening of the point that was
  /// widest when it broke; below that it presses [m].
  [[nodiscard, gnu::always_inline]] auto gone(const Number& closes_at) const {
    return open_by(kOpened) && opened > closes_at;
  }
  /// Whether even the nearest point is open, whatever the tilt.
  [[nodiscard, gnu::always_inline]] auto surely_open(const Number& closes_at) const {
    using std::max, std::sqrt;
    const Number first = max(closes_at, Number(kSurelyOpen * sqrt(radius_squared)));
    const Number tilted = sqrt(slid * turn.squared());
    return opened > first + sqrt(turn.apart_1) + sqrt(turn.apart_2) + tilted;
  }
};

}  // namespace muckpile
