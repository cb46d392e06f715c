// SPDX-License-Identifier: GPL-2.0-or-later
// Pressure history of the stress wave that a detonating charge sends into the rock.
// Scope: one point of the column, time counted from the arrival of the detonation there.
#pragma once

namespace muckpile {

/// Starfield and Pugliese (1968), with the constants chosen so that the peak is exactly 1 at the
/// rise time: p/P = 4 (x - x^2), x = 2^(-t/rise_time). This is their 4 (e^(-bt/sqrt 2) - e^(-sqrt 2
/// bt)) with b = sqrt(2) ln 2 / rise_time (docs/sources.md). Rises monotonically, falls to
/// one half at 2.77 rise times; its integral is 2 rise_time / ln 2.
class StarfieldPulse {
 public:
  /// InputError unless rise_time [s] is positive and finite.
  explicit StarfieldPulse(double rise_time);

  /// Pressure over peak pressure, 0 for t <= 0 [s].
  [[nodiscard]] double shape(double time) const;
  /// Like shape() until the peak, 1 from then on: a switch-on without a jump.
  [[nodiscard]] double ramp(double time) const { return time < rise_time_ ? shape(time) : 1.0; }
  [[nodiscard]] double rise_time() const { return rise_time_; }  ///< [s]

 private:
  double rise_time_;
};

}  // namespace muckpile
