// SPDX-License-Identifier: GPL-2.0-or-later
// What a facet and a boundary face of a block are.
// Scope: data in the start configuration, and a face's load; what a facet remembers is in
// facet_memory.h.
#pragma once

#include <array>
#include <cstdint>

#include "math/types.h"

namespace muckpile {

inline constexpr int kFacetPoints = 3;  ///< per facet: area, centroid and second moments exact
inline constexpr int kGroundTag = 0;    ///< "block" on the far side of a supported boundary face

/// What a facet joins its block `i` to. `fixed` and `mirror` join it to the ground: rock that does
/// not move, and the mirror image behind a symmetry plane (no shear).
enum class FacetKind : std::uint8_t { joint, fixed, mirror };

/// Facet in the start configuration. Blocks are named by tag; `i`, `j` are indices into the
/// network's blocks and are set by the caller whenever those change. (tag_i, face) is unique.
struct Facet {
  int tag_i = 0, tag_j = 0;  ///< tag_i < tag_j, or tag_j = kGroundTag
  int face = 0;              ///< number of the face in block i's polyhedron
  int i = -1, j = -1;        ///< local indices; j = ground() for a support
  FacetKind kind = FacetKind::joint;
  std::uint8_t joint_class = 0;         ///< 0: made by the cut alone; from 1: natural joints
  std::uint8_t zone_i = 0, zone_j = 0;  ///< of rock, of blocks i and j; of the ground that of i
  Vec3 normal;                          ///< unit, from i to j
  Vec3 arm_i, arm_j;              ///< facet centroid minus block centre (ground: the origin) [m]
  Vec3 opening_i, opening_j;      ///< m of blocks i and j: how the jump dilates them [-]
  std::array<Vec3, 2> half_axes;  ///< sqrt(2) x radii of gyration along the in-plane axes [m]
  double area = 0.0;              ///< [m2]
  double stiffening = 1.0;        ///< of its rock, at a crushed zone (wall_facets.h) [-]
  /// Between two rocks, of blocks i and j: volume over the area of all their facets to other rocks
  /// [m]; 0: the relief of border_relief.h is not for this facet.
  std::array<float, 2> border_room{0.0f, 0.0f};
  bool sharpened = true;  ///< D counts; not at blocks of fixed supports or beside another rock
  std::array<bool, 2> slanted{false, false};  ///< blocks i and j have the terms of leaning_faces.h
  double weight = 1.0;  ///< share of the facet's energy that this rank books [-]
};

/// What a facet joins, by local index; j = ground() for a support.
struct FacetEnds {
  int i, j;
  FacetKind kind;
};

/// Face of one block that is free or faces a crushed zone.
struct BoundaryFace {
  int tag = 0;
  int face = 0;                ///< number of the face in the block's polyhedron
  int block = -1;              ///< local index
  int hole = -1;               ///< index of the crushed zone that it faces, -1 if none
  Vec3 normal = Vec3::Zero();  ///< unit, outward
  Vec3 arm = Vec3::Zero();     ///< centroid minus block centre [m]
  Vec3 start = Vec3::Zero();   ///< centroid in the start configuration [m]
  double area = 0.0;           ///< [m2]
  double pressure = 0.0;       ///< on a face with a hole only [Pa]
  double wave_share = 0.0;     ///< of its work; the rest is the gas's [-]
  double depth_share = 1.0;    ///< of arm.normal, that yields to pressure (wall_facets.h) [-]
  double load_share = 1.0;     ///< of the load, that no gas around the block balances [-]
  // Of the step before; they follow the face through the run.
  double last_pressure = 0.0;  ///< [Pa]
  double last_squeezed = 0.0;  ///< volume by the face's own displacement [m3]
  double rigid_swept = 0.0;    ///< by the block's own motion since the start, load_share of it [m3]
  Vec3 last_centroid = Vec3::Zero(), last_normal = Vec3::Zero();
};

}  // namespace muckpile
