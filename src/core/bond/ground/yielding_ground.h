// SPDX-License-Identifier: GPL-2.0-or-later
// The supports of a facet network whose ground yields: a support is a bonded facet whose far side
// moves as quiet_ground.h has it.
// Scope: a part of the network that exists only where a scene has such supports. What each ground
// remembers lies with its facet (GroundMemory); SI units.
#pragma once

#include <functional>
#include <vector>

#include "bond/ground/quiet_ground.h"
#include "bond/network/facet_kinematics.h"
#include "bond/network/joint_books.h"

namespace muckpile {

class YieldingGround {
 public:
  explicit YieldingGround(const QuietGround& rock) : rock_(rock) {}

  /// Whether the ground of an intact support yields in this history.
  [[nodiscard]] static bool exists_in(const FacetHistory& history);

  [[nodiscard]] const QuietGround& rock() const { return rock_; }
  void set_rock(const QuietGround& rock) { rock_ = rock; }
  /// Facets, those of a block together.
  [[nodiscard]] const std::vector<std::size_t>& supports() const { return supports_; }
  [[nodiscard]] bool any() const { return !supports_.empty(); }

  /// Lists the intact ones whose ground yields.
  void list(const FacetHistory& history);
  void drop_broken(const FacetHistory& history);
  void release() { supports_ = {}; }

  /// The ground behind intact `fixed` supports that `chosen` accepts by their centroid in the start
  /// configuration yields from now on; `traction` gives what a facet carries now [Pa]. Returns how
  /// many yield now that did not before.
  int let_yield(const FacetKinematics& facets, FacetHistory& history,
                const std::function<bool(const Vec3&)>& chosen,
                const std::function<Vec3(std::size_t)>& traction);

  /// What yielding changes in a network.
  struct Changes {
    FacetTables& tables;
    FacetHistory& history;
    std::vector<BlockSums>& sums;  ///< those of all other facets and faces are complete
    JointLosses& losses;
  };
  /// Moves all grounds over a step dt [s] that led to the present pose.
  void yield(const FacetKinematics& facets, const Changes& changes, double dt) const;

 private:
  struct Plan;
  [[nodiscard]] QuietGround rock_behind(const FacetTables& tables, std::size_t f) const;
  [[nodiscard]] Plan plan(const FacetKinematics& facets, std::size_t f, double dt) const;
  void yield_beside_block(const FacetKinematics& facets, const Changes& changes, std::size_t first,
                          std::size_t last, double dt) const;
  void yield_support(const FacetKinematics& facets, const Changes& changes, std::size_t f,
                     double bulk_stress, double dt) const;
  void book(const FacetKinematics& facets, JointLosses& losses, std::size_t f, const Vec3& step,
            const Vec3& traction, double dt) const;

  QuietGround rock_;  // of zone 0
  std::vector<std::size_t> supports_;
};

}  // namespace muckpile
