// SPDX-License-Identifier: GPL-2.0-or-later
// A LIGGGHTS run inside a test: rock cut by create_blocks, moved and read by body tag, silent.
// Scope: for the tests of create_blocks and the styles that stand on it; every method is
// collective.
#pragma once

#include <mpi.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "math/types.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::test {

struct BlockNow {
  Vec3 centre, velocity, spin;
  Vec3 angular_momentum;  ///< about the block's own centre [kg m2/s]
  double mass = 0.0;
  double kinetic = 0.0;         ///< [J]
  Mat3 inertia = Mat3::Zero();  ///< in space [kg m2]
};

struct SphereNow {
  Vec3 centre, velocity;
  double radius = 0.0;
};

struct Motion {
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

class RockScene {
 public:
  /// `box`: six numbers [m]; `processors`: the words after that command; `bodies`: style of the fix
  /// that holds the blocks.
  RockScene(MPI_Comm comm, const std::string& box, const std::string& processors = "* 1 1",
            const std::string& bodies = "multisphere");
  /// Goes on from a restart file of such a scene, with the same style of `bodies`.
  static RockScene restarted(MPI_Comm comm, const std::string& file,
                             const std::string& processors = "* 1 1",
                             const std::string& bodies = "multisphere/muckpile");
  ~RockScene();
  RockScene(RockScene&&) noexcept;
  RockScene(const RockScene&) = delete;
  RockScene& operator=(const RockScene&) = delete;

  void command(const std::string& line);
  /// region `rock` = block with these six numbers, cut with the words of create_blocks.
  void cut(const std::string& block, const std::string& words);
  void run(int steps, double time_step);
  void set_motion(const std::function<Motion(int tag, const Vec3& centre)>& rule);

  /// All blocks by tag, on every rank.
  [[nodiscard]] std::map<int, BlockNow> blocks() const;
  /// All contact spheres by atom tag, on every rank. create_blocks numbers them block by block.
  [[nodiscard]] std::map<int, SphereNow> all_spheres() const;
  /// f_ID[n], n from 1; n = 0: f_ID.
  [[nodiscard]] double output(const std::string& fix, int n) const;
  /// Value of an equal-style variable.
  [[nodiscard]] double variable(const std::string& name) const;
  [[nodiscard]] double time_step() const;  // [s]
  /// Contact forces become too large by this share, while their energies stay right.
  void spoil_contacts(double share);
  [[nodiscard]] double kinetic_energy() const;
  /// Blocks on this rank.
  [[nodiscard]] int own_blocks() const;
  [[nodiscard]] double spheres() const;

 private:
  explicit RockScene(MPI_Comm comm);
  MPI_Comm comm_;
  std::unique_ptr<LAMMPS_NS::LAMMPS> lmp_;
};

}  // namespace muckpile::test
