// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/gauges: where gauges are and how often they are read.
// Scope: words and points; what holds the gauges is the style's. SI units.
#pragma once

#include <string>
#include <vector>

#include "args/parse_args.h"
#include "math/types.h"

namespace muckpile {

struct GaugeOptions {
  long every = 0;         ///< steps from sample to sample; 0: by interval
  double interval = 0.0;  ///< [s]; 0: by steps
  std::string directory, file;
  std::vector<Vec3> points;  ///< single ones first, then those of the lines [m]
};

/// The three coordinates with blanks between them.
[[nodiscard]] std::string place_text(const Vec3& point);

[[nodiscard]] const ArgTable& gauge_table();

/// Throws InputError that starts with `where`: both or none of every and interval, no gauge at all,
/// a line of one point or without length, a number that is none, more than 10,000 gauges, two at
/// one place, a file name that is not gauges*.csv.
[[nodiscard]] GaugeOptions gauge_options(const ArgValues& values, const std::string& where);

}  // namespace muckpile
