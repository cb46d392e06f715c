// SPDX-License-Identifier: GPL-2.0-or-later
// Muck that lies in front of the rock before the blast: blocks of an earlier run, loose and at
// rest. Scope: start configuration; no joints, neither among each other nor with the rock.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "bond/build/rigid_body.h"
#include "bond/facet.h"
#include "geometry/block_model.h"

namespace muckpile {

/// The words of `muck`.
struct MuckSource {
  std::string folder;         ///< of results (saved_pile.h)
  Vec3 shift = Vec3::Zero();  ///< from there to this run [m]
  bool moved_only = false;    ///< blocks that have not left their place are the rock of that run
  /// Greatest share of their mass in the rock of this run or beyond its box, which is left out.
  double overlap = 0.0;
  static constexpr double kEndless = std::numeric_limits<double>::infinity();
  double floor = -kEndless;                       ///< z of level ground [m]
  double least_size = 0.0;                        ///< V^(1/3), for the step of the run [m]
  Vec3 lo = Vec3::Constant(-kEndless), hi = -lo;  ///< of the simulation box [m]
};

struct Muck {
  struct LeftOut {
    std::size_t blocks = 0;
    double mass = 0.0;  ///< [kg]
    void add(double kg) {
      ++blocks;
      mass += kg;
    }
  };
  std::vector<Block> blocks;      ///< as they lie
  std::vector<RigidBody> bodies;  ///< one per block
  std::vector<BoundaryFace> faces;
  LeftOut standing;
  LeftOut in_rock;            ///< or in the floor, or beyond the box
  double time = 0.0;          ///< of the snapshot [s]
  double moving_share = 0.0;  ///< mass share that was still faster than 0.1 m/s
};

/// `first_tag` is of the first block. Throws InputError if there is no such pile (saved_pile.h),
/// none of it is left, or more of it than allowed lies beyond the box or in the rock: overlaps
/// blocks of `rock` by more than a tenth of its volume, or reaches with a contact sphere into the
/// floor by more than a quarter of its radius; or a block of it is too small.
[[nodiscard]] Muck lay_muck(const MuckSource& source, const std::vector<Block>& rock,
                            const SphereRule& spheres, int first_tag);

/// For the log: "" without muck. Swell is the volume under its surface, above its lowest point,
/// over that of its blocks.
[[nodiscard]] std::string describe_muck(const Muck& muck, const MuckSource& source);

/// Volume under the surface of blocks, down to `floor` or, where a column of them begins more than
/// one block higher, to where it begins [m3]. `cell` of the columns [m].
[[nodiscard]] double bulk_volume(const std::vector<Block>& blocks, double floor, double cell);

}  // namespace muckpile
