// SPDX-License-Identifier: GPL-2.0-or-later
// What a facet network knows of its blocks: constants, poses, sums over their facets and faces,
// dilatation, bulk stress, force and torque.
// Scope: one row per block, SI units: owned blocks first, then copies of blocks that other ranks
// own, the ground last. Sums and what follows from them are right for owned blocks alone; theta and
// bulk stress of copies come from their owners (rank_team.h). Formulas are in facet_network.h.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "bond/network/facet_group.h"
#include "bond/network/joint_laws.h"
#include "bond/network/network_block.h"
#include "math/types.h"

namespace muckpile {

struct BlockSums {
  double bonded = 0.0;    ///< sum of A m.u/2 over bonded facets [m3]
  double loaded = 0.0;    ///< sum of A t_n d/(2G) over loaded faces [m3]
  double unbonded = 0.0;  ///< phi, of faces and broken facets [-]
  double uneven = 0.0;    ///< sum of D A h (theta - theta of the neighbour) [J]
};

/// Elastic constants of a block's rock [Pa].
struct BlockRock {
  double lame_lambda, two_g;

  /// p of facet_network.h of that dilatation [Pa]. `uneven`: as in BlockSums; `volume`:
  /// BlockFields::stiffened_volume().
  [[nodiscard]] double bulk_stress(double theta, double uneven, double volume) const {
    return lame_lambda * theta + uneven / volume;
  }
};

struct BlockFields {
  std::vector<BlockConstants> constants;
  std::vector<BlockRock> rock;
  std::vector<BlockState> state;
  std::vector<BlockSums> sums;
  std::vector<double> theta;  ///< dilatation [-]
  /// What breaking in the last step has taken from theta; of copies what their owners told since.
  std::vector<double> theta_lost;
  std::vector<double> bulk_stress;  ///< [Pa]
  std::vector<Vec3> force, torque;  ///< of facets, faces and gas [N], [N m]
  /// Of FacetTables::borders(), what border_relief.h adds along the normal [Pa].
  std::vector<double> border_traction;

  /// Adds the ground; all blocks lie at the origin with no motion, force or sum.
  void reset(std::vector<BlockConstants> blocks, const JointLaws& laws) {
    constants = std::move(blocks);
    constants.reserve(constants.size() + 1);
    constants.push_back({kGroundTag, false, 1.0, 1.0, {}});
    find_rock(laws);
    state.assign(size(), {Mat3::Identity(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
    sums.assign(size(), {});
    theta.assign(size(), 0.0);
    theta_lost.assign(size(), 0.0);
    bulk_stress.assign(size(), 0.0);
    force.assign(size(), Vec3::Zero());
    torque.assign(size(), Vec3::Zero());
  }

  /// As soft as it is now.
  void find_rock(const JointLaws& laws) {
    rock.clear();
    for (const BlockConstants& block : constants) {
      const JointMaterial& of = laws.rock(block.zone);
      rock.push_back({of.lame_lambda(), 2.0 * of.shear_modulus()});
    }
  }

  [[nodiscard]] std::size_t size() const { return constants.size(); }  ///< with the ground
  [[nodiscard]] bool owned(std::size_t b) const { return constants[b].owned; }
  [[nodiscard]] double volume(std::size_t b) const { return constants[b].volume; }  ///< [m3]
  [[nodiscard]] const BlockState& state_of(int block) const {
    return state[static_cast<std::size_t>(block)];
  }

  /// s of facet_network.h of block b with these sums [-].
  [[nodiscard]] double stiffening(std::size_t b, const BlockSums& of) const {
    return 1.0 + of.unbonded * rock[b].lame_lambda / rock[b].two_g;
  }
  /// V s [m3].
  [[nodiscard]] double stiffened_volume(std::size_t b, const BlockSums& of) const {
    return volume(b) * stiffening(b, of);
  }
  /// By its sums [-].
  [[nodiscard]] double dilatation(std::size_t b) const {
    return (sums[b].bonded + sums[b].loaded) / stiffened_volume(b, sums[b]);
  }
  /// Energy of the dilatation that block b has with these sums, less the potential of the pressures
  /// on its faces [J].
  [[nodiscard]] double potential(std::size_t b, const BlockSums& of) const {
    const double opened = of.bonded + of.loaded;
    return 0.5 * rock[b].lame_lambda * opened * opened / stiffened_volume(b, of);
  }
};

}  // namespace muckpile
