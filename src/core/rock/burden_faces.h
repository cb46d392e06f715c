// SPDX-License-Identifier: GPL-2.0-or-later
// The free faces that burdens are measured to: those of blocks, and of surveyed ground the survey.
// Scope: convex polygons in the frame of the run.
#pragma once

#include <vector>

#include "bond/build/facet_builder.h"
#include "geometry/surface/rock_body.h"

namespace muckpile {

using Corners = std::vector<Vec3>;

struct FreeFace {
  Corners corners;
  Vec3 normal;  ///< out of the rock
};

/// Surfaces that bound the rock within a region and its box.
struct SurveyedRock {
  std::vector<RockSurface> surfaces{};  ///< none: blocks alone say where the rock ends
  RegionQuery region{};                 ///< without the surfaces
  Vec3 lo = Vec3::Zero(), hi = Vec3::Zero();
};

/// What of a convex polygon lies where sign along.(p - from) <= sign end.
[[nodiscard]] Corners cut_at(const Corners& polygon, const Vec3& from, const Vec3& along,
                             double end, double sign);

/// Without those that stand for a survey: in their place are its triangles, as far as they bound
/// the rock.
[[nodiscard]] std::vector<FreeFace> free_faces(const std::vector<Block>& blocks,
                                               const SupportRule& support,
                                               const SurveyedRock& surveyed);

}  // namespace muckpile
