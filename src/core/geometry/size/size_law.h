// SPDX-License-Identifier: GPL-2.0-or-later
// Block size V^(1/3) as a function of the distance from the nearest charge axis.
// Limits: never decreases with distance; always within [smallest, largest].
#pragma once

#include <istream>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace muckpile {

struct SizeLimits {
  double smallest = 0.0;  // [m]
  double largest = 0.0;   // [m]
};

// Harries (1973), "A mathematical model of cratering and blasting" (docs/sources.md): the peak
// strain falls as K (b/r) exp(-alpha r/b), and radial crack number i reaches as far as the strain
// is i times the breaking strain T. So n(r) = (K/T) (b/r) exp(-alpha r/b) cracks pass radius r, and
// their spacing 2 pi r / n is the block size.
struct HarriesParameters {
  double hole_radius = 0.0;      // b [m]
  double wall_strain = 0.0;      // K [-]
  double breaking_strain = 0.0;  // T [-]
  double absorption = 0.0;       // alpha, per hole radius [-]
};

/// Radial cracks that pass a distance [m] > 0 from the axis, and their spacing there [m]; infinite
/// where there is none.
[[nodiscard]] double harries_cracks(const HarriesParameters& parameters, double distance);
[[nodiscard]] double harries_spacing(const HarriesParameters& parameters, double distance);
/// Distance of the last crack's end, where the count falls to 1 [m].
[[nodiscard]] double harries_reach(const HarriesParameters& parameters);

// size = coefficient * distance^exponent.
struct PowerParameters {
  double coefficient = 0.0;  // [m^(1-exponent)]
  double exponent = 0.0;     // [-]
};

// Linear between points, constant beyond the ends: pairs (distance [m], size [m]).
using SizeTable = std::vector<std::pair<double, double>>;

// Concentric bands: pairs (outer radius [m], size in the band [m]); beyond the last radius its
// size.
struct SizeBands {
  std::vector<std::pair<double, double>> bands;
};

class SizeLaw {
 public:
  // Each maker throws InputError naming the parameter that is out of range.
  [[nodiscard]] static SizeLaw uniform(double size);
  [[nodiscard]] static SizeLaw harries(const HarriesParameters& parameters,
                                       const SizeLimits& limits);
  [[nodiscard]] static SizeLaw power(const PowerParameters& parameters, const SizeLimits& limits);
  [[nodiscard]] static SizeLaw table(const SizeTable& points, const SizeLimits& limits);
  [[nodiscard]] static SizeLaw bands(const SizeBands& bands, const SizeLimits& limits);

  // Block size [m] at a distance [m] >= 0 from the nearest charge axis (infinity is allowed).
  [[nodiscard]] double at(double distance) const;

  // The same among several charges whose cracks cross: cracks per length, 1/size, add up before the
  // limits are applied. Distances [m] >= 0 from each axis, one at least.
  [[nodiscard]] double superposed(std::span<const double> distances) const;

  [[nodiscard]] const SizeLimits& limits() const { return limits_; }

 private:
  using Kind = std::variant<HarriesParameters, PowerParameters, SizeTable, SizeBands>;
  SizeLaw(Kind kind, const SizeLimits& limits);

  [[nodiscard]] double raw(double distance) const;  // without the limits

  Kind kind_;
  SizeLimits limits_;
};

// Two columns, distance [m] and size [m], one pair a line; blank lines and what follows '#' are
// skipped. `name` is used in messages. Throws InputError with name and line number.
[[nodiscard]] SizeTable read_size_table(std::istream& in, const std::string& name);
[[nodiscard]] SizeTable read_size_table_file(const std::string& path);

}  // namespace muckpile
