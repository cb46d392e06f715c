// SPDX-License-Identifier: GPL-2.0-or-later
// Standing waves in a box of blocks that its reflections continue: their measured frequency.
// Scope: small amplitudes; box with one corner at the origin, walls with images on all sides.
#pragma once

#include <functional>
#include <string>

#include "framework/block_run.h"

namespace muckpile::verification {

struct StandingWave {
  std::string name;
  double wave_number;                                   ///< [1/m]
  double speed;                                         ///< of an isotropic continuum [m/s]
  Vec3 parity;                                          ///< +1 or -1 of the walls normal to x, y, z
  std::function<Vec3(const Vec3&)> displacement, curl;  ///< per unit amplitude [-], [1/m]
};

enum class Polarisation { p, s };

/// Along axis a: P is u_a = sin(k x_a), S is u_b = cos(k x_a); k = half_waves pi / edge[a].
[[nodiscard]] StandingWave axial_wave(Polarisation kind, int a, int b, double edge, int half_waves,
                                      double speed);
/// Sum of the plane waves along +-x +-y in a square of this edge: P, S in the plane, S along z.
[[nodiscard]] StandingWave diagonal_wave(Polarisation kind, bool in_plane, double edge,
                                         int half_waves, double speed);

/// Angular frequency [rad/s]: starts at rest in the continuum's shape, runs `periods` periods at
/// `step_share` of the stable step, and fits a cosine to the part of the motion that has that
/// shape.
[[nodiscard]] double measured_frequency(BlockRun& run, const StandingWave& wave, double periods,
                                        double step_share);

}  // namespace muckpile::verification
