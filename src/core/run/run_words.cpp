// SPDX-License-Identifier: GPL-2.0-or-later
// Words that run_blast and run_blocks share.
// Scope: see the header.
#include "run/run_words.h"

#include "contact/collision_time.h"

namespace muckpile {

void add_end_words(ArgTable& table) {
  table
      .word("directory", {}, {},
            "where snapshots, history.csv, run.json and restart files go, unless fixes of the "
            "script say otherwise")
      .real("time_end", "s", Range::left_open(0.0, 1000.0), 12.0, "the run ends then at the latest")
      .real("still_share", "", Range::right_open(1e-6, 1.0), 0.01,
            "mass share that may still move when the run ends")
      .word("scene", {}, "all", "region, as in fix muckpile/progress")
      .word("solid", {}, "none", "region, as in fix muckpile/progress")
      .integer("restart_every", "steps", Range::closed(0, 2147483647), 0,
               "between restart files, a.restart and b.restart in turn; 0: none")
      .word("snapshot_form", {"csv", "packed"}, "csv",
            "of snapshots that no fix of the script takes: form of fix muckpile/dump");
}

void add_collision_words(ArgTable& table) {
  table
      .real(
          "block_min", "m", Range::closed(1e-3, 100.0), {},
          "as in create_blocks, for the step of loose blocks: too large a one makes it too coarse")
      .integer("spheres_per_block", "", Range::closed(1, 64), 8,
               "as in create_blocks, for the same: too few make it too coarse")
      .real("steps_per_contact", "", Range::closed(5.0, 1000.0), 8.0,
            "least number of steps in a fast collision of two smallest blocks: at the speed of the "
            "fastest in run_blast, at 20 m/s in run_blocks")
      .real(
          "stable_share", "", Range::closed(0.01, 1.0), 0.8,
          "longest step of loose blocks, as a share of the longest stable one, as contacts become "
          "stiffer between two checks");
}

CollisionStep collision_step(const ArgValues& words, double density,
                             const BlockContacts& contacts) {
  const long spheres = words.integer("spheres_per_block");
  const SmallBlocks blocks{
      .edge = words.real("block_min"),
      .density = density,
      .spheres = spheres,
      .effective_modulus =
          contacts.youngs_modulus / (2.0 * (1.0 - contacts.poisson_ratio * contacts.poisson_ratio)),
      .polyhedra = contacts.polyhedra};
  // With 64 spheres a step 0.7 as long as the crowd's was unstable, one 0.6 as long was not; the
  // crowd's factor leaves 0.43, and the step stays that of kSpeed.
  return {
      .step = collision_time_of(blocks, CollisionStep::kSpeed) / words.real("steps_per_contact"),
      .follows_fastest = crowd_factor(spheres) <= 1.0 && !contacts.polyhedra};
}

}  // namespace muckpile
