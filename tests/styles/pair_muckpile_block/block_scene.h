// SPDX-License-Identifier: GPL-2.0-or-later
// A LIGGGHTS run inside a test: blocks placed by hand, contact style muckpile/block, silent.
// Scope: for the tests of this folder; one object per communicator at a time.
#pragma once

#include <mpi.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "math/types.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::testing {

struct Ball {
  Vec3 offset;    ///< from the block's centre [m]
  double radius;  ///< [m]
};

struct BlockSpec {
  int tag = 0;
  Vec3 centre = Vec3::Zero();    ///< [m]
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
  Vec3 spin = Vec3::Zero();      ///< [rad/s]
  double mass = 1.0;             ///< [kg]
  Vec3 inertia = Vec3::Ones();   ///< principal, axes along x, y, z at the start [kg m2]
  std::vector<Ball> balls;
  bool fixed = false;
};

struct BlockNow {
  Vec3 centre, velocity, spin;
  double kinetic_J = 0.0;
};

class BlockScene {
 public:
  /// Box [-half, half]^3 [m] with fixed faces; `contact` are the words after pair_style.
  BlockScene(MPI_Comm comm, double half_box, double skin, const std::string& contact);
  ~BlockScene();
  BlockScene(const BlockScene&) = delete;
  BlockScene& operator=(const BlockScene&) = delete;

  void command(const std::string& line);
  /// Places the blocks (same list on all ranks); once per scene, before run().
  void add(const std::vector<BlockSpec>& blocks);
  void run(int steps, double time_step);

  /// The contact forces of the present state once more, for measuring their time.
  void compute_contacts();

  /// As fix muckpile/timestep does it: contacts act at every so many steps.
  void act_every(int steps);
  [[nodiscard]] bool acts_for_several() const;  ///< at the present step

  /// As fix muckpile/ledger does it: forces on blocks are summed from the next run on.
  void watch_contacts();

  /// All blocks by tag, on every rank.
  [[nodiscard]] std::map<int, BlockNow> blocks() const;
  /// Sum over ranks of a value of the contact style.
  [[nodiscard]] double sum(const char* name) const;
  /// Kinetic + elastic energy + what friction and dashpots took [J].
  [[nodiscard]] double energy_account() const;

 private:
  void place(const BlockSpec& block, int first_atom_tag);

  MPI_Comm comm_;
  std::unique_ptr<LAMMPS_NS::LAMMPS> lmp_;
};

}  // namespace muckpile::testing
