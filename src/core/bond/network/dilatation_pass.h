// SPDX-License-Identifier: GPL-2.0-or-later
// Dilatations and bulk stresses of blocks from their bonded facets.
// Scope: a pass over the parts of a network; reads facets and poses, writes BlockSums, theta [-]
// and bulk stress [Pa]. Facets between blocks at rest are looked at once. Formulas are in
// facet_network.h.
#pragma once

#include "bond/network/facet_kinematics.h"
#include "bond/network/facet_schedule.h"

namespace muckpile {

class DilatationPass {
 public:
  /// `ground_yields`: that moves what rests, so all facets are looked at.
  DilatationPass(const FacetKinematics& facets, BlockFields& blocks, FacetSchedule& schedule,
                 bool ground_yields)
      : facets_(facets),
        blocks_(blocks),
        schedule_(schedule),
        leaves_resting_(schedule.any_rests() && !ground_yields) {}

  /// BlockSums::bonded of all facets in the present pose; no face is loaded yet.
  void sum_openings();
  /// Theta from the sums, which are complete; right for owned blocks.
  void find_theta();
  /// From the theta of all blocks; right for owned blocks that the tractions look at.
  void find_bulk_stresses();

 private:
  void open(const LaneSet& bonded);
  void open_one(std::size_t f);
  void open_resting();

  FacetKinematics facets_;
  BlockFields& blocks_;
  FacetSchedule& schedule_;
  bool leaves_resting_;
};

}  // namespace muckpile
