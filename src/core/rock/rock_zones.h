// SPDX-License-Identifier: GPL-2.0-or-later
// Zones of rock: where each lies, what create_blocks must know of it, and which one a block is of.
// Scope: the words behind `zone` of create_blocks; a block is of one zone, the first that holds its
// centroid, or of the rock around all of them. Elastic constants and strengths of the zones are
// words of fix muckpile/joint.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/surface/rock_body.h"

namespace muckpile {

struct CutOptions;

struct RockZone {
  std::string name;
  double density = 0.0;  ///< [kg/m3]
  std::function<bool(const Vec3& point)> holds{};
  std::vector<CutPlane> borders{};    ///< those of layers, which the cut follows
  std::string region{};               ///< of the engine, which sets `holds`; empty: none
  std::optional<RockSurface> body{};  ///< closed surface around it: see zone_bodies.h
  bool of_model = false;              ///< of cells of a block model: see zone_model.h
  int joint_class = 0;                ///< of the facets in its borders; 0: rock that is whole
  double size_factor = 1.0;           ///< block size over that of the size law: see zone_sizes.h
};

/// Most zones beside the rock around them: a block has a byte for its zone, and JointLaws a law for
/// each pair.
inline constexpr std::size_t kMostZones = 10;

/// Whether these words behind `zone` name a file in mine coordinates.
[[nodiscard]] bool names_a_file(const std::vector<std::string>& words);

/// Of the words behind `zone`. Throws InputError.
[[nodiscard]] RockZone rock_zone_of(const std::vector<std::string>& words);

/// Adds the borders of layers to the planes that the cut follows, once the box of the rock is
/// known. Throws InputError where a border lies outside the rock, and for two zones of one name.
void lay_zones(CutOptions& options);

/// Adds a plane to those that the cut follows, unless it is there.
void cut_along(TessellationOptions& rock, const CutPlane& plane);

/// 0: none of `zones` holds the point; k: zones[k - 1] does, and none before it.
[[nodiscard]] std::uint8_t zone_at(const std::vector<RockZone>& zones, const Vec3& point);

}  // namespace muckpile
