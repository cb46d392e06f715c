// SPDX-License-Identifier: GPL-2.0-or-later
// The books of a facet network: what joints have lost, what pressure has worked, and what breaking
// takes from the sums of blocks in a step.
// Scope: sums of this rank over what it books (Facet::weight), since the start of the run; energies
// in J.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bond/ground/quiet_ground.h"

namespace muckpile {

/// Cumulative losses of this rank [J].
struct JointLosses {
  double fracture = 0.0;
  double friction = 0.0;
  double crushing = 0.0;  ///< of friction, taken by walls that crush
  double damping = 0.0;
  double quiet = 0.0;     ///< given to the rock behind yielding supports, in all
  double radiated = 0.0;  ///< of that, carried away by waves

  void crush(double energy) {
    friction += energy;
    crushing += energy;
  }
};

/// How soft the rock has become.
struct RockSoftness {
  double factor = 1.0;            ///< product of all factors of soften() [-]
  std::optional<double> damping;  ///< the last one given to soften() [-]

  [[nodiscard]] bool operator==(const RockSoftness&) const = default;
};

/// What a network has added up, for a run that continues it.
struct NetworkTotals {
  JointLosses losses;
  double pressure_work = 0.0, wave_work = 0.0;  ///< [J]
  double softened = 1.0;                        ///< product of all factors of soften() [-]
  std::optional<double> damping;                ///< the last one given to soften() [-]
  QuietGround quiet_ground;
  bool moved_unseen = false;  ///< faces have moved while no pressure was there nor expected
  bool softer_since = false;  ///< than as the faces were loaded last
};

struct JointBooks {
  /// Taken by a point that broke in this step from the sums of one of its blocks.
  struct Dropped {
    std::size_t block;
    double bonded, unbonded;  ///< as in BlockSums
  };

  JointLosses losses;
  double pressure_work = 0.0;           ///< on owned blocks so far [J]
  double wave_work = 0.0;               ///< of that, by waves [J]
  double softened = 1.0;                ///< product of all factors of soften() [-]
  std::optional<double> damping_given;  ///< the last one given to soften() [-]
  bool newly_cracked = false;           ///< a facet cracked in the last step
  bool newly_let_go = false;            ///< a cracked facet began to fade or retired in it
  std::vector<Dropped> dropped;         ///< in the order of breaking; empty between steps
};

}  // namespace muckpile
