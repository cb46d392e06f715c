// SPDX-License-Identifier: GPL-2.0-or-later
// What the facet network knows of a block, and what is left to know of facets that it dropped.
// Scope: data.
#pragma once

#include <cmath>

#include "bond/facet.h"
#include "math/types.h"

namespace muckpile {

/// What is left to know of a block's retired facets once they are no longer kept.
struct RetiredFacets {
  double unbonded = 0.0;  ///< their part of phi [-]
  double area = 0.0;      ///< of joints [m2]
  double count = 0.0;     ///< of joints [-]

  /// `arm` is the facet's centroid less the centre of the block, `volume` the block's.
  void add(const Facet& facet, const Vec3& arm, double volume) {
    unbonded += facet.area * std::abs(facet.normal.dot(arm)) / volume;
    if (facet.kind != FacetKind::joint) return;
    area += facet.area;
    count += 1.0;
  }
};

struct BlockConstants {
  int tag = 0;
  bool owned = true;    ///< false for a copy of another rank's block
  double volume = 0.0;  ///< [m3]
  double mass = 0.0;    ///< [kg]
  RetiredFacets retired{};
  std::uint8_t zone = 0;  ///< of rock; 0: that of the network's material
};

struct BlockState {
  Mat3 rotation;                ///< from the start orientation
  Vec3 centre, velocity, spin;  ///< [m], [m/s], [rad/s]
};

}  // namespace muckpile
