// SPDX-License-Identifier: GPL-2.0-or-later
// Rock that surveyed surfaces bound: closed bodies and terrains from files.
// Scope: places them in the frame of the run and checks them; the cut sees a RegionQuery.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "geometry/cut/tessellation.h"
#include "geometry/files/survey_file.h"
#include "geometry/surface/surface_index.h"

namespace muckpile {

/// From mine coordinates to those of the run: the origin becomes 0 0 0, and x looks to a bearing.
struct MineFrame {
  Vec3 origin = Vec3::Zero();  ///< in mine coordinates [m]
  double bearing = 0.0;        ///< of the run's x axis, from north over east [rad]
  [[nodiscard]] Vec3 to_run(const Vec3& mine) const;
  [[nodiscard]] Vec3 to_mine(const Vec3& run) const;
};

/// Points of a ground that stand at the place of another in plan at another height: of each place
/// one counts.
struct DoubledPlaces {
  std::size_t places = 0;
  double apart = 0.0;          ///< greatest difference of their heights [m]
  Vec3 lowest = Vec3::Zero();  ///< where it is [m]
};

/// Of those whose heights differ by more than `apart` [m].
[[nodiscard]] DoubledPlaces doubled_places(std::vector<Vec3> points, double apart);

enum class SurfaceIs { body, terrain };

struct RockSurface {
  std::string file;
  SurfaceIs kind = SurfaceIs::body;
  std::shared_ptr<const SurfaceIndex> index;
  DoubledPlaces doubled{};  ///< of a terrain of points
  [[nodiscard]] bool inside(const Vec3& point) const { return index->inside(point); }
  [[nodiscard]] double height(const Vec3& point) const;  ///< out of the rock [m]
};

/// Triangles of a terrain: its own, or Delaunay triangles of its points in plan; all look up.
[[nodiscard]] std::vector<StlTriangle> terrain_triangles(const SurveyedSurface& survey);

/// Adds the surfaces to a region, or to the whole box where it has no functions.
[[nodiscard]] RegionQuery within(const RegionQuery& region,
                                 const std::vector<RockSurface>& surfaces);

}  // namespace muckpile
