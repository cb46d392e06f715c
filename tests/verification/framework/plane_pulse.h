// SPDX-License-Identifier: GPL-2.0-or-later
// Plane waves that run along x through a column of blocks: how they start, and what a station sees.
// Scope: small amplitudes; the walls at the column's sides must let the wave be plane.
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "framework/block_run.h"
#include "framework/standing_wave.h"

namespace muckpile::verification {

/// Displacement along x (P) or y (S) as a function of x - speed x time; 0 outside some range.
struct PlanePulse {
  Polarisation kind;
  double speed;                                ///< [m/s]
  double wavelength;                           ///< sets the step of numerical derivatives [m]
  std::function<double(double)> displacement;  ///< at time 0 [m]
};

/// A wave under a Gaussian envelope of this standard deviation, its middle at `centre` [m].
[[nodiscard]] PlanePulse gaussian_pulse(Polarisation kind, double speed, double wavelength,
                                        double deviation, double centre, double amplitude);

/// Walls for such a wave: the column's ends at x are free.
[[nodiscard]] WallRule column_walls(Polarisation kind, const Vec3& box);

/// Adds the pulse to the present pose of blocks that have not turned, and sets its velocities.
void launch(BlockRun& run, const PlanePulse& pulse);

/// Mean velocity along the pulse's displacement, over the mass within `reach` of x.
class Station {
 public:
  Station(const BlockRun& run, Polarisation kind, double x, double reach);
  void record(const BlockRun& run);
  [[nodiscard]] const std::vector<double>& velocity() const { return velocity_; }  ///< [m/s]

 private:
  int axis_;
  double mass_ = 0.0;
  std::vector<std::size_t> blocks_;
  std::vector<double> velocity_;
};

/// Sum of values x exp(-i omega t) dt; value n is that of time n dt.
[[nodiscard]] std::complex<double> spectrum(const std::vector<double>& values, double dt,
                                            double omega);

}  // namespace muckpile::verification
