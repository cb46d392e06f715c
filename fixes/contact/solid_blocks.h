// SPDX-License-Identifier: GPL-2.0-or-later
// The blocks of pair muckpile/block in their own shape: which sphere stands for each, and how its
// body lies, also where another rank moves it.
// Scope: between two reneighbourings; the forces are core's.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

#include "contact/block_contact_list.h"
#include "contact/polyhedra/solid_forces.h"
#include "fixes/engine/block_halo.h"
#include "fixes/engine/bodies.h"
#include "fixes/interfaces/block_shapes.h"

namespace LAMMPS_NS {
class Atom;
}  // namespace LAMMPS_NS

namespace muckpile {

class SolidBlocks {
 public:
  /// Takes over the blocks by their tags. Of `atom_block` the key of each block stays, all other
  /// atoms get -1.
  void keep_keys(const LAMMPS_NS::Atom& atom, std::span<const int> block_tag,
                 const BlockShapes& shapes, std::vector<int>& atom_block);
  [[nodiscard]] int without_shape() const { return without_shape_; }  ///< of those blocks
  /// Where the bodies of these blocks are. Collective.
  void plan(LAMMPS_NS::FixMultisphere& bodies, std::span<const int> block_tag, MPI_Comm world);
  /// Takes over how bodies lie that other ranks move. Collective.
  void update(const engine::Bodies& bodies);

  /// Per atom: how far its block reaches from it, of keys [m].
  [[nodiscard]] const double* reaches() const { return reaches_.data(); }
  [[nodiscard]] const Solid& solid(int block) const { return shapes_[at(block)]->solid; }
  /// Of a block whose key is here, from the present positions.
  [[nodiscard]] SolidBody body(const engine::Bodies& bodies, const LAMMPS_NS::Atom& atom, int block,
                               int key) const;
  /// The same, worked out once from the positions since begin_step().
  [[nodiscard]] const SolidBody& body_of_step(const engine::Bodies& bodies,
                                              const LAMMPS_NS::Atom& atom, int block, int key);
  void begin_step() { ++step_; }

 private:
  static std::size_t at(int block) { return static_cast<std::size_t>(block); }

  std::vector<const ShapedBlock*> shapes_;  // per block
  std::vector<int> places_;                 // per block: of own bodies, then of strange ones
  std::vector<double> reaches_;
  engine::BlockHalo halo_;
  bool several_ = false;  // ranks
  int without_shape_ = 0;
  int own_ = 0;                         // bodies
  std::vector<SolidBody> of_step_;      // per block
  std::vector<std::uint64_t> step_of_;  // per block: that its entry of of_step_ is of
  std::uint64_t step_ = 0;
  std::vector<double> axes_;  // of bodies by their places: by columns
};

}  // namespace muckpile
