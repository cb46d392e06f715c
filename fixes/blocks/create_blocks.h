// SPDX-License-Identifier: GPL-2.0-or-later
// create_blocks: cuts a region into graded blocks, makes them multisphere bodies, and hands their
// facets to fix muckpile/blocks.
// Scope: the tessellation runs on rank 0, its sweeps on all; bodies are created on the rank that
// owns their centre, so the same seed gives the same blocks, tags included, on any number of ranks.
#pragma once

#include <pointers.h>

#include <string>
#include <vector>

#include "fixes/engine/style_args.h"
#include "rock/rock_model.h"

namespace LAMMPS_NS {
class Region;
}

namespace muckpile {

class CreateBlocks : protected LAMMPS_NS::Pointers {
 public:
  explicit CreateBlocks(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);

 private:
  [[nodiscard]] std::string run_id(const std::vector<std::string>& words,
                                   const RockModel& model) const;
  void check_engine() const;
  [[nodiscard]] int checked_type(const ArgValues& args) const;
  [[nodiscard]] LAMMPS_NS::Region& region(const std::string& id) const;
  void check_overlap(LAMMPS_NS::Region& rock) const;
  void bound(TessellationOptions& what, LAMMPS_NS::Region& rock) const;
  void find_zone_regions(std::vector<RockZone>& zones) const;
  [[nodiscard]] SupportRule support(const ArgValues& args) const;
  void share_sweeps_of_rank_0(TessellationOptions& what) const;
};

}  // namespace muckpile
