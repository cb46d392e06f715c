// SPDX-License-Identifier: GPL-2.0-or-later
// The crater of one charge under a flat free surface, and where its ejecta lie.
// Scope: surface z = 0, charge on the z axis; the crater is measured in rings about that axis.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"

namespace muckpile {

// Means over one ring of columns about the axis.
struct CraterRing {
  double radius;          // middle of the ring [m]
  double area;            // [m2]
  double surface;         // top of all rock after, above the start surface [m]
  double true_surface;    // top of the rock that stayed, above the start surface [m]
  double moved_fraction;  // of the start surface's area: rock broken out
};

std::vector<CraterRing> crater_rings(const std::vector<StartBlock>& blocks, const Snapshot& last,
                                     const std::vector<char>& moved, double cell, double ring_width,
                                     const std::vector<char>& lies);

struct CraterShape {
  double radius, depth, volume;  // [m], [m], [m3]; all 0 where there is no crater
};

// Apparent crater, as a survey after the blast finds it: to the first ring less than 2 % of the
// depth below the start surface.
CraterShape apparent_crater(const std::vector<CraterRing>& rings);
// True crater, as if all loose rock were dug out: to the first ring of whose surface less than half
// was broken out.
CraterShape true_crater(const std::vector<CraterRing>& rings);

struct Ejecta {
  double mass;           // broken-out rock from within `radius` that ends outside it [kg]
  double p50, p90, max;  // distance from the axis of half, 90 % and all of it [m]; NaN for none
};
Ejecta ejecta_beyond(double radius, const std::vector<StartBlock>& blocks, const Snapshot& last,
                     const std::vector<char>& moved);

}  // namespace muckpile
