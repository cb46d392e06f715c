// SPDX-License-Identifier: GPL-2.0-or-later
// Forces and torques of the facets on their blocks in a step: tractions, breaking, contact of
// broken points, the pressure of gas in joints.
// Scope: a pass over the parts of a network, made for one step of dt [s]. Theta, bulk stresses and
// leaning stresses of all blocks are those of the present pose. A facet that holds at every point,
// or at none, is worked on with the others of its group; all others one by one.
#pragma once

#include "bond/network/bonded_points.h"
#include "bond/network/broken_contact.h"
#include "bond/network/gas_load.h"

namespace muckpile {

class TractionPass {
 public:
  /// `gas` is nullptr where none presses; `ground_yields`: under a support of this network.
  TractionPass(const FacetBreaking::Parts& parts, GasLoad* gas, bool ground_yields, double dt)
      : parts_(parts),
        facets_{parts.tables, parts.history, parts.blocks},
        bonded_(parts),
        broken_(facets_, parts.history, parts.schedule, parts.books, dt),
        gas_(gas),
        ground_yields_(ground_yields),
        dt_(dt) {}

  /// Adds to force and torque of all blocks; those of the gas go into `gas`.
  void run();

 private:
  /// Of the facets of a group that were worked out side by side.
  struct GroupForces {
    unsigned intact = 0, touching = 0;  // lanes
    WideForces of_intact, of_touching;
  };

  void work_group(const LaneSet& working, const LaneSet& active);
  void add(const LaneSet& working, const GroupForces& sums);
  void work_alone(std::size_t f);
  void fetch(const LaneSet& working) const;
  [[nodiscard]] unsigned intact_forces(std::size_t g, unsigned lanes, const WidePose& pose,
                                       WideForces& forces) const;
  [[nodiscard]] WideField pull_of(const FacetGroup& group, const WidePose& pose) const;
  [[nodiscard]] static unsigned slid_along(const FacetGroup& group, const WidePose& pose);
  [[nodiscard]] unsigned unbroken_lanes(std::size_t g, unsigned lanes, const WidePose& pose,
                                        const WideField& pull) const;
  void damp_group(std::size_t g, const WidePose& pose, WideField& pull, WideForces& forces) const;
  void work_facet(std::size_t f);
  void apply(std::size_t f, double point_area, const FacetPull& pull);

  FacetBreaking::Parts parts_;
  FacetKinematics facets_;
  BondedPoints bonded_;
  BrokenContact broken_;
  GasLoad* gas_;
  bool ground_yields_;
  double dt_;
};

}  // namespace muckpile
