// SPDX-License-Identifier: GPL-2.0-or-later
// A cavity under a pressure pulse in blocks, and in an endless elastic medium.
// Scope: cavity of 1 m radius, nu = 0.25, undamped; a quarter or an octant between mirror planes.
#pragma once

#include <cstddef>
#include <vector>

#include "analytic/cavity.h"
#include "math/types.h"

namespace muckpile::verification {

inline constexpr double kRatio = 0.25;    // Poisson's
inline constexpr double kPressure = 1e6;  // peak [Pa]

/// What is cut and loaded. Lengths in metres, which are cavity radii.
struct Scene {
  CavityShape shape;
  double rise;       ///< rise time times P speed
  double wall, far;  ///< block sizes at the cavity and from some distance on
  std::vector<double> stations;
  double beam = 0.0;    ///< if not 0, only blocks that near the x axis are watched, in a slim box
  double layers = 2.0;  ///< of blocks in the slice around a cylinder
  bool round = true;    ///< a cylinder's wall has the stiffness of a round hole (wall_facets.h)
};

[[nodiscard]] inline bool is_cylinder(const Scene& scene) {
  return scene.shape == CavityShape::cylinder;
}

struct Peaks {
  std::vector<double> stress, velocity;  ///< per station [Pa], [m/s]
  std::vector<double> way;               ///< P speed times the time of the later one [m]
};

struct ExactWave {
  ElasticMedium medium;
  PressureTransform pressure;
};

[[nodiscard]] ExactWave exact_wave(const Scene& scene);
[[nodiscard]] Peaks exact_peaks(const Scene& scene);
/// Of the pressure on a cylinder's wall until the last peak has passed, per length [J/m].
[[nodiscard]] double exact_work(const Scene& scene);

struct Outcome {
  Peaks peaks;
  double work;     ///< of the pressure on the whole cylinder's wall, per length [J/m]
  double seconds;  ///< processor time of the run alone
  std::size_t blocks;
  double radius;
  std::vector<Eigen::Vector2d>
      history;  ///< P speed x time and stress at the middle station [m], [Pa]
};

[[nodiscard]] Outcome measure(const Scene& scene);

/// Of all peaks, over the exact ones.
[[nodiscard]] double worst_error(const Peaks& got, const Peaks& exact);

}  // namespace muckpile::verification
