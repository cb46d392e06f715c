// SPDX-License-Identifier: GPL-2.0-or-later
// Two surfaces over one grid of columns: volumes between them, vertical differences, mean profiles.
// Scope: "run less survey" throughout; cells where a height is not known (NaN) are left out.
#pragma once

#include <vector>

#include "measure/bench_planes.h"
#include "measure/columns.h"
#include "measure/pile.h"
#include "measure/scan_polygon.h"

namespace muckpile {

struct SurfacePair {
  ColumnGrid grid;
  std::vector<double> run, survey;  // heights [m], NaN where not known
  std::vector<char> compared;       // both are known, and there is rock of one or the other
};

struct SurfaceDifference {
  double area = 0.0;   // compared, in plan [m2]
  double above = 0.0;  // volume where the run lies higher [m3]
  double below = 0.0;  // volume where it lies lower, as a positive number [m3]
  double mean = 0.0;   // of run less survey [m]
  double rms = 0.0;    // [m]
  double p90 = 0.0;    // its magnitude is smaller on 90 % of the area [m]
};

// The pair must have a compared cell.
SurfaceDifference difference_of(const SurfacePair& pair);

// From the survey at the middle of each compared cell to the nearest point of the run's surface,
// which is triangles between the heights at the middles of its cells [m]. NaN where it has none.
struct SurfaceDistance {
  double mean, rms, p90;
};
SurfaceDistance distance_of(const SurfacePair& pair);

// The magnitude below which this share of the compared cells differ [m].
double difference_at_share(const SurfacePair& pair, double share);

// Means over y of both surfaces, over the same cells.
struct ProfilePair {
  std::vector<double> x, run, survey;  // [m]
  double dx = 0.0;                     // [m]
};

// Abreast of the holes of `planes`. From the first to the last x of which half of the width is
// known of both; an x between them where less is known has the means of the one before.
ProfilePair profiles_of(const SurfacePair& pair, const BenchPlanes& planes);

// Height and toe of one of the two profiles, as `profile` defines them but for all rock in front of
// the last row, which stands `depth` behind the toe [m]. The toe is NaN where the profile ends
// above `block_size` [m].
PileShape shape_of_profile(const std::vector<double>& x, const std::vector<double>& heights,
                           double dx, double depth, double block_size);

}  // namespace muckpile
