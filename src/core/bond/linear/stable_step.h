// SPDX-License-Identifier: GPL-2.0-or-later
// How long a time step the facets bear: 2/omega of the fastest vibration of all blocks together,
// with their rotations, the coupling by dilatation, and dashpots.
// Scope: small motions about the present pose (linear_network.h); leapfrog whose dashpots see the
// velocity half a step late. Contacts between spheres are not known here. A joint whose law is not
// grouped may stiffen as a wave closes it, before the next look: wherever it is now, it counts with
// the largest stiffness along the normal that any law can reach, and all of its motion strains the
// rock.
//
// omega^2 = largest eigenvalue of M^-1 K, by Lanczos' method from a random start. Its value never
// exceeds the eigenvalue; that it falls short by more than a share e has, after k products and for
// n unknowns, a probability of at most 1.648 sqrt(n) exp(-sqrt(e) (2k - 1)) whatever the matrix
// (Kuczynski & Wozniakowski 1992, theorem 4.2; docs/sources.md). k is chosen so that the step is
// right within kStepDoubt but for a chance of kStepRisk. With dashpots C the limit is that of
// K + (2/dt) C: the step enters itself, and is found by repetition.
#pragma once

#include <span>

#include "bond/linear/linear_network.h"

namespace muckpile {

inline constexpr double kStepDoubt = 0.025;
inline constexpr double kStepRisk = 1e-3;

/// What may happen to the joints before the next look.
enum class Breaking {
  none,     ///< they stay as they are
  possible  ///< any of them may become a closed contact, which is stiffer against compression
};

struct StepBound {
  double seconds = 0.0;  ///< the longest stable step is this to 1/(1 - kStepDoubt) times this
  int products = 0;      ///< matrix-vector products spent, each about one force computation
};

/// `inertia`: of the owned blocks, in space and about their centres [kg m2]. The pose is that of
/// the network's last force computation. `guess` [s]: the result of an earlier call, saves work
/// with dashpots; 0: none. Infinite where no facet acts. Collective.
///
/// With breaking possible it is the shorter of the bounds for the present state and for all facets
/// broken and closed: measured on cubes, bars, plates, Voronoi and graded blocks, nu 0 to 0.45, a
/// random mixture of whole and broken facets has one of at least 0.997 of that (by
/// tests/unit/bond/linear/test_stable_step.cpp; docs/theory/timestep.md).
[[nodiscard]] StepBound stable_step(const FacetNetwork& network, std::span<const Mat3> inertia,
                                    Breaking breaking, const RankTeam& team = {},
                                    double guess = 0.0);

}  // namespace muckpile
