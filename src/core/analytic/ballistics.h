// SPDX-License-Identifier: GPL-2.0-or-later
// Flight of a block without air resistance.
// Scope: one launch point above level ground; the check for casts and throws.
#pragma once

namespace muckpile {

inline constexpr double kStandardGravity = 9.80665;  ///< [m/s2]

/// Horizontal distance [m] of a body launched at speed [m/s] and angle [rad] above the horizontal,
/// from `height` [m] above the ground: v cos(th) (v sin(th) + sqrt(v^2 sin^2(th) + 2 g h)) / g.
/// InputError unless speed >= 0, height >= 0, gravity > 0.
[[nodiscard]] double ballistic_range(double speed, double angle, double height,
                                     double gravity = kStandardGravity);

/// Time of that flight [s].
[[nodiscard]] double ballistic_time(double speed, double angle, double height,
                                    double gravity = kStandardGravity);

}  // namespace muckpile
