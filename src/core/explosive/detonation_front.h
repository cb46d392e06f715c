// SPDX-License-Identifier: GPL-2.0-or-later
// When the detonation reaches a height of a charge column.
// Scope: a straight column, constant velocity, one primer.
#pragma once

#include "math/types.h"

namespace muckpile {

class DetonationFront {
 public:
  struct Parameters {
    Vec3 toe;                    ///< lower end of the charge [m]
    Vec3 collar;                 ///< upper end of the charge [m]
    double detonation_velocity;  ///< [m/s]
    double firing_time;          ///< when the primer fires, >= 0 [s]
    double primer = 0.0;         ///< primer's place along the column, 0 toe to 1 collar
  };

  /// InputError on a column without length, velocity <= 0, firing_time < 0, primer outside 0..1.
  explicit DetonationFront(const Parameters& parameters);

  /// Time [s] at which the front passes the height of a point: firing time + axial distance from
  /// the primer / velocity. Points beyond an end of the column count as at that end.
  [[nodiscard]] double arrival_time(const Vec3& point) const;
  /// Arrival at the end farther from the primer [s].
  [[nodiscard]] double last_arrival_time() const;
  [[nodiscard]] double firing_time() const { return firing_time_; }  ///< [s]
  [[nodiscard]] double column_length() const { return length_; }     ///< [m]

 private:
  Vec3 toe_;
  Vec3 axis_;  // unit, toe to collar
  double length_;
  double velocity_;
  double firing_time_;
  double primer_;  // [m] from the toe
};

}  // namespace muckpile
