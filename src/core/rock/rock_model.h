// SPDX-License-Identifier: GPL-2.0-or-later
// The rock as the engine takes it: blocks, their rigid bodies with spheres, and the facets between
// them.
// Scope: start configuration; tags are first_tag + block number.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bond/build/facet_builder.h"
#include "bond/build/rigid_body.h"
#include "rock/cut_options.h"
#include "rock/hole_burdens.h"

namespace muckpile {

/// What the cut has made of a fault.
struct FaultFacets {
  double area = 0.0;   ///< of the facets with its class [m2]
  double along = 0.0;  ///< area times the cosine of the angle between facet and fault [m2]
  int joint_class = 0;
};

struct RockModel {
  Tessellation rock;
  std::vector<RigidBody> bodies;  ///< one per block
  FacetSet facets;
  std::vector<Hole> holes;                ///< with the shares of them that are modelled
  double largest_overlap = 0.0;           ///< of spheres of two blocks, in radii
  std::optional<SizeComparison> sizes{};  ///< with a size target
  std::string why_missed{};               ///< the target, if it is
  std::size_t natural_planes = 0;         ///< of natural joints
  std::vector<FaultFacets> faults{};      ///< in the order of the options
  std::vector<HoleBurden> burdens{};      ///< of the holes, where they are wanted
  double plan_burden = 0.0;               ///< 0: not told [m]
  std::vector<std::string> zones{};       ///< names of those of rock
  std::vector<std::uint8_t> zone_of{};    ///< per block; k: zones[k - 1]; empty: there are none
  Muck muck{};                            ///< its tags follow those of the rock
};

/// Throws InputError as the cuts do (tessellation.h, joint_set_cut.h, size_target.h,
/// block_import.h), mirrored_holes.h and muck.h, and where the region holds no block.
[[nodiscard]] RockModel cut_rock(const CutOptions& options, int first_tag,
                                 const SupportRule& support);

/// What came out, for the log: counts, sizes, the target and how near it is. `seconds`: what the
/// making took.
[[nodiscard]] std::string describe(const RockModel& model, double seconds);

/// Line of the log: faces in planes of the cut that have nothing behind them, and a warning where
/// these are many; "" for none.
[[nodiscard]] std::string describe_open_planes(const CutOptions& options, const Tessellation& cut);

}  // namespace muckpile
