// SPDX-License-Identifier: GPL-2.0-or-later
// How far each charge is from the free faces beside it: its burden, along its length.
// Scope: of the blocks as they are cut, at right angles to the charge; what lies in front of a
// charge at the same time is not known here, so a hole nearer to the face counts as fired before.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bond/build/facet_builder.h"
#include "geometry/block_model.h"

namespace muckpile {

struct HoleBurden {
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

[[nodiscard]] std::vector<HoleBurden> hole_burdens(const std::vector<Block>& blocks,
                                                   const std::vector<Hole>& holes,
                                                   const SupportRule& support);

/// A table, and warnings where a plan's burden is given (> 0) [m].
[[nodiscard]] std::string describe_burdens(const std::vector<HoleBurden>& burdens, double plan);

}  // namespace muckpile
