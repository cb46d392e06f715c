// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/shapes: keeps the polyhedra of the blocks, as create_blocks has made them.
// Scope: internal; pair muckpile/block makes it where blocks touch in their own shape. Every rank
// holds all shapes (about 1 kB a block): they never change, and a block may show up on any rank.
#pragma once

#include <fix.h>

#include <unordered_map>
#include <vector>

#include "fixes/interfaces/block_shapes.h"

namespace muckpile {

/// Of the whole run, in restart files.
struct ShapesState {
  std::vector<BlockShape> shapes;
};
template <>
struct Stored<ShapesState> {
  static constexpr std::string_view kName = "shapes_state";
  static constexpr int kVersion = 1;
  static auto fields(auto& state) { return std::tie(state.shapes); }
};

class FixMuckpileShapes : public LAMMPS_NS::Fix, public BlockShapes {
 public:
  FixMuckpileShapes(LAMMPS_NS::LAMMPS* engine_object, int narg, char** arg);

  void share(const std::vector<BlockShape>& of_rank_0) override;
  [[nodiscard]] const ShapedBlock* shape(int tag) const override;
  [[nodiscard]] double largest_reach() const override { return largest_reach_; }

  int setmask() override { return 0; }
  void write_restart(FILE* file) override;
  void restart(char* state) override;
  double memory_usage() override;

 private:
  void take(std::vector<BlockShape> shapes);

  std::vector<BlockShape> stored_;
  std::unordered_map<int, ShapedBlock> blocks_;  ///< by body tag
  double largest_reach_ = 0.0;
};

}  // namespace muckpile
