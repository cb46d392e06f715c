// SPDX-License-Identifier: GPL-2.0-or-later
// Peak particle velocity beside one charge against the law of Holmberg and Persson, and against the
// exact wave in elastic rock.
// Scope: slices 1 m thick, whose charge is that of a metre of the hole; upright holes with two
// ends.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "figures/figures.h"

namespace muckpile::check {

/// Holmberg & Persson 1979 (hard bedrock, K = 0.7 m/s, alpha = 0.7, beta = 1.5): the peaks v of
/// the parts of a charge of q [kg/m] add up to v = 0.7 (q/r [atan((H - z)/r) + atan(z/r)])^0.7
/// [m/s] at the distance r [m], and 0.7 (pi q/r)^0.7 where the charge has no end.
[[nodiscard]] double holmberg_persson(double charge_per_metre, double distance);

/// The same of a charge with two ends; z and H - z are how far the gauge is above the lower one and
/// below the upper one, `distance` is that from the charge's axis [m].
[[nodiscard]] double holmberg_persson(double charge_per_metre, double distance, double above_toe,
                                      double below_top);

/// A Starfield pulse in a cylinder in endless elastic rock; all > 0.
struct ElasticLoad {
  double peak, rise_time, radius;  ///< [Pa], [s], [m]
  double density, youngs_modulus;  ///< [kg/m3], [Pa]
  double poisson_ratio;
};

/// Of the gauges between `near` and `far` [m] in FOLDER/ppv.csv of muckpile-post waves, for each
/// folder, NAME being its last part:
///   NAME_over_law: mean of the peaks over the law's, of the logarithms;
///   NAME_over_law_least, NAME_over_law_most: of single gauges;
///   NAME_distance_exponent: n of v = c r^n by least squares of the logarithms;
///   with a `load` NAME_over_elastic, NAME_elastic_exponent: the mean over its peaks; their n.
/// InputError where a file, column or gauge is missing, a number is not > 0, or two folders have
/// one name.
[[nodiscard]] Json near_field(const std::vector<std::filesystem::path>& folders, double near,
                              double far, const std::optional<ElasticLoad>& load = {});

/// Of one upright charge with its toe `subdrill_m` below z = 0, `charge_length_m` long (both of
/// FOLDER/dump/scene.json), for each folder NAME, each height of gauges Z and each two neighbours D
/// and E of `distances` from the charge, in hundredths of a metre in the names:
///   NAME_at_Z_from_D_over_law, NAME_at_Z_from_D_distance_exponent: as of near_field(), of gauges
///   at
///     D and more, less than E;
///   NAME_at_Z_from_D_law_exponent: n of the law at the same gauges;
/// and of all gauges from the first distance to the last
///   NAME_over_bureau_most: largest peak over 1.65 (R/sqrt(W))^-1.62 m/s (U.S. Bureau of Mines).
/// Errors as of near_field().
[[nodiscard]] Json hole_vibration(const std::vector<std::filesystem::path>& folders,
                                  const std::vector<double>& distances);

}  // namespace muckpile::check
