// SPDX-License-Identifier: GPL-2.0-or-later
// Words that run_blast and run_blocks share: where files go, when a run ends, and the step that
// resolves collisions.
// Scope: their rows in a keyword table, and what they mean.
#pragma once

#include "args/parse_args.h"
#include "run/blast_scene.h"

namespace muckpile {

/// directory, time_end, still_share, scene, solid, restart_every, snapshot_form.
void add_end_words(ArgTable& table);

/// block_min, spheres_per_block, steps_per_contact, stable_share.
void add_collision_words(ArgTable& table);

/// Of two of the smallest blocks.
struct CollisionStep {
  double step = 0.0;            ///< that resolves a collision at kSpeed [s]
  bool follows_fastest = true;  ///< the step follows the speed of the fastest block

  static constexpr double kSpeed = 20.0;  ///< [m/s]

  /// 0: it stays that of kSpeed.
  [[nodiscard]] double speed() const { return follows_fastest ? kSpeed : 0.0; }
};

/// `density` of the blocks [kg/m3].
[[nodiscard]] CollisionStep collision_step(const ArgValues& words, double density,
                                           const BlockContacts& contacts);

}  // namespace muckpile
