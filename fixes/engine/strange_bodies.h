// SPDX-License-Identifier: GPL-2.0-or-later
// Motion of the bodies that other ranks move while spheres of theirs lie here.
// Scope: the plan holds until bodies or spheres change their places.
#pragma once

#include <mpi.h>

#include <unordered_map>
#include <vector>

#include "fixes/engine/block_halo.h"
#include "math/types.h"

namespace LAMMPS_NS {
class Atom;
class FixMultisphere;
}  // namespace LAMMPS_NS

namespace muckpile::engine {

struct BodyState {
  Vec3 centre, velocity, spin;  ///< [m], [m/s], [rad/s]
};

class StrangeBodies {
 public:
  StrangeBodies() = default;
  /// Collective. A rank must know all spheres of the bodies it moves, as its own or as ghosts.
  StrangeBodies(LAMMPS_NS::FixMultisphere& bodies, const LAMMPS_NS::Atom& atom, MPI_Comm world);

  /// Takes over the present state of the bodies. Collective.
  void update(LAMMPS_NS::FixMultisphere& bodies);
  /// Of the last update(), by body tag; null: no such body.
  [[nodiscard]] const BodyState* find(int tag) const;

 private:
  std::vector<int> lent_tags_;           // per ghost whose body this rank moves: that body
  std::unordered_map<int, int> places_;  // of states_, by body tag
  std::vector<BodyState> states_;
  BlockHalo halo_;
  std::vector<double> values_;
};

}  // namespace muckpile::engine
