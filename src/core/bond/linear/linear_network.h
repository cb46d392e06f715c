// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network for small motions about its present pose: the stiffness matrix as a product.
// Scope: blocks as rigid bodies, six numbers each (shift [m], turn [rad]); the geometric stiffness
// of the tractions is left out (they are 1e-4 of the moduli). Broken facets count as closed and
// sticking, whether they are or not; joints whose law is not grouped as closed as makes them
// stiffest. Yielding ground counts as fixed, which is what it is at the limit of stability. All
// ranks together.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bond/law/leaning_law.h"
#include "bond/network/facet_network.h"
#include "bond/network/rank_team.h"

namespace muckpile {

enum class BreakView : std::uint8_t {
  as_it_is,   ///< points that are bonded now are bonded
  all_broken  ///< every facet is a closed contact
};

class LinearNetwork {
 public:
  /// `damping_rate` [1/s]: every dashpot counts as a spring of that many times its coefficient.
  LinearNetwork(const FacetNetwork& network, BreakView view, double damping_rate);

  /// Forces [N] and torques [N m] that balance the owned blocks in `motion`, which has six numbers
  /// per block, owned ones first, then the copies; those are filled in. Collective.
  void balance(std::span<double> motion, std::span<double> force, const RankTeam& team);

 private:
  struct Spring {
    int i, j;  // -1: the ground
    Vec3 normal;
    LeaningSide<Vec3> on_i, on_j;
    std::array<bool, 2> slanted;  // blocks i and j have the terms of leaning_faces.h
    double shear_share;           // see FacetLean
    std::array<Vec3, kFacetPoints> arm_i, arm_j;          // of the points, from the centres [m]
    std::array<LinearClosure<double>, kFacetPoints> law;  // times the area of the point [N/m]
    // Of the points: how much more than a rigid joint's share of a normal motion strains the rock.
    std::array<double, kFacetPoints> normal_share;
    double pull_i, pull_j;      // force of a bonded point per bulk stress of block i and j [m2]
    double strain_i, strain_j;  // volume of block i and j per opening of a bonded point [m2]
    std::array<bool, kFacetPoints> bonded;
    double sharpening;  // of the bonded points, twice the energy per square of uneven theta [J]

    /// The motion of a point that counts in the dilatations, and the force that these pass on.
    [[nodiscard]] Vec3 counted(std::size_t p, const Vec3& v) const {
      if (normal_share[p] == 1.0) return v;
      return v + (normal_share[p] - 1.0) * normal.dot(v) * normal;
    }
    [[nodiscard]] Vec3 strained(const Vec3& v) const {
      return StrainedPart<double, Vec3>{shear_share, normal}.of(v);
    }
  };

  void add_spring(const FacetNetwork& network, std::size_t f, BreakView view, double damping_rate);
  static void set_points(Spring& spring, const FacetNetwork& network, std::size_t f, BreakView view,
                         double damping_rate);
  void set_blocks(const FacetNetwork& network, BreakView view);
  [[nodiscard]] static Vec3 jump(const Spring& spring, std::size_t p,
                                 std::span<const double> motion);
  void bulk_stresses(std::span<const double> motion, const RankTeam& team);
  [[nodiscard]] Vec3 bulk_pull(const Spring& spring) const;
  void slant_stresses(std::span<const double> motion, const RankTeam& team);
  [[nodiscard]] Vec3 slant_pull(const Spring& spring) const;

  std::vector<Spring> springs_;
  std::vector<BlockRock> rock_;      // per block
  std::vector<Mat3> moment_;         // Q of leaning_faces.h, per block [-]
  std::vector<double> rock_volume_;  // [m3]
  struct Slant {
    Mat3 gradient, stress, excess;
  };
  std::vector<Slant> slants_;         // of `motion`
  std::optional<bool> slanted_;       // a spring of any rank is
  std::vector<double> volume_;        // BlockFields::stiffened_volume(), per block [m3]
  std::vector<double> theta_, bulk_;  // dilatation [-] and bulk stress [Pa] of `motion`
};

}  // namespace muckpile
