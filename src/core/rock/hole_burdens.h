// SPDX-License-Identifier: GPL-2.0-or-later
// How far each charge is from the free faces beside it: its burden, along its length.
// Scope: of the blocks as they are cut, and of the survey where the rock has one, at right angles
// to the charge; what lies in front of a charge at the same time is not known here, so a hole
// nearer to the face counts as fired before.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bond/build/facet_builder.h"
#include "geometry/block_model.h"

namespace muckpile {

struct SurveyedRock;  // burden_faces.h

/// Of one of the equal pieces into which a charge is divided.
struct BurdenPiece {
  double along = 0.0;      ///< of its middle from the lower end of the charge [m]
  Vec3 at = Vec3::Zero();  ///< that middle [m]
  /// At right angles to the charge to the free face beside it, and where that is so near [m].
  std::optional<double> burden{};
  Vec3 face = Vec3::Zero();
};

struct HoleBurden {
  std::vector<BurdenPiece> pieces{};  ///< from the lower end up
  /// At right angles to the charge, where a free face lies there; none: nowhere along it [m].
  std::optional<double> least{}, mean{}, greatest{};
  double bare = 0.0;  ///< share of the charge with no free face beside it [-]
  /// Of the hole in front, if one is nearer to a face: its number from 0, and the way to it [m].
  std::optional<std::size_t> in_front{};
  double to_front = 0.0;
};

/// Bounds of burdens along a charge, over that of the plan, beyond which a hole is warned of. Ours:
/// a third less or half as much again is well outside of what setting out and drilling bring.
inline constexpr double kLeastBurden = 0.6, kGreatestBurden = 1.5;

/// What a piece has to move: the way to the face, or to the hole in front where that is shorter.
[[nodiscard]] std::optional<double> burden_that_counts(const HoleBurden& hole,
                                                       const BurdenPiece& piece);

enum class BurdenIs { not_judged, too_little, as_planned, too_much };

/// Against that of the plan [m]; 0: there is none.
[[nodiscard]] BurdenIs judged(const std::optional<double>& burden, double plan);

[[nodiscard]] std::vector<HoleBurden> hole_burdens(const std::vector<Block>& blocks,
                                                   const std::vector<Hole>& holes,
                                                   const SupportRule& support);

/// Where surfaces bound the rock, to them instead of the blocks' faces that stand for them.
[[nodiscard]] std::vector<HoleBurden> hole_burdens(const std::vector<Block>& blocks,
                                                   const std::vector<Hole>& holes,
                                                   const SupportRule& support,
                                                   const SurveyedRock& surveyed);

/// A table, and warnings where a plan's burden is given (> 0) [m].
[[nodiscard]] std::string describe_burdens(const std::vector<HoleBurden>& burdens, double plan);

}  // namespace muckpile
