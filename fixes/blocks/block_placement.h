// SPDX-License-Identifier: GPL-2.0-or-later
// Puts blocks that rank 0 has cut where they belong: a multisphere body with its spheres on the
// rank that owns the centre, and every facet on the ranks of its blocks. Scope: all members are
// collective; blocks and spheres are numbered on from what exists.
#pragma once

#include <pointers.h>

#include <string>
#include <vector>

#include "rock/rock_model.h"

namespace LAMMPS_NS {
class FixMultisphere;
}

namespace muckpile {

/// What the rank that gets a block needs to make it.
struct PlacedBlock {
  int tag = 0, first_atom_tag = 0;
  std::uint8_t zone = 0;  ///< of rock, as the command numbers them
  RigidBody body;
  std::vector<BoundaryFace> faces;
  std::vector<Facet> facets;
};
template <>
struct Stored<PlacedBlock> {
  static constexpr std::string_view kName = "placed_block";
  static constexpr int kVersion = 2;
  static auto fields(auto& block) {
    return std::tie(block.tag, block.first_atom_tag, block.zone, block.body, block.faces,
                    block.facets);
  }
};

struct BlockShape;
struct BlocksShare;

class BlockPlacement : protected LAMMPS_NS::Pointers {
 public:
  /// Spheres get this atom type; of the options densities and zones count.
  BlockPlacement(LAMMPS_NS::LAMMPS* engine, int type, const CutOptions& options);

  /// Tag of the first new block.
  [[nodiscard]] int first_tag() const { return first_tag_; }
  /// `model` counts on rank 0 only.
  void place(const RockModel& model, const std::vector<Hole>& holes);

 private:
  void settle_new_fixes();
  [[nodiscard]] BlocksShare hand_out(const RockModel& model, std::size_t blocks);
  void take(const PlacedBlock& placed, BlocksShare& share);
  void finish(BlocksShare share, const std::vector<Hole>& holes, int blocks, int joints);
  [[nodiscard]] std::vector<BlockShape> shapes_of(const RockModel& model) const;
  void create_body(const PlacedBlock& placed);
  void create_spheres(const PlacedBlock& placed, const std::vector<double*>& displace);
  [[nodiscard]] double density_of(const PlacedBlock& placed) const;
  void count_atoms();

  LAMMPS_NS::FixMultisphere* multisphere_;
  int type_;
  std::vector<double> densities_;   // of the rock, then of the zones [kg/m3]
  std::vector<std::string> zones_;  // their names
  int first_tag_ = 1;
  int first_atom_tag_ = 1;
};

}  // namespace muckpile
