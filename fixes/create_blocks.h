// SPDX-License-Identifier: GPL-2.0-or-later
// create_blocks: cuts a region into graded blocks, makes them multisphere bodies, and hands their
// facets to fix muckpile/blocks.
// Scope: the tessellation runs on rank 0, its sweeps on all; bodies are created on the rank that
// owns their centre, so the same seed gives the same blocks, tags included, on any number of ranks.
#pragma once

#include <pointers.h>

#include <optional>
#include <vector>

#include "bond/facet_builder.h"
#include "bond/joint_plane.h"
#include "bond/rigid_body.h"
#include "engine/style_args.h"
#include "geometry/joint_set_cut.h"
#include "geometry/size_target.h"

namespace LAMMPS_NS {
class FixMultisphere;
class Region;
}  // namespace LAMMPS_NS

namespace muckpile {

class FixMuckpileBlocks;

class CreateBlocks : protected LAMMPS_NS::Pointers {
 public:
  explicit CreateBlocks(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  void command(int narg, char** arg);

 private:
  struct Model {  // rank 0 only
    Tessellation rock;
    std::vector<RigidBody> bodies;
    FacetSet facets;
    double largest_overlap = 0.0;
    std::optional<SizeComparison> sizes{};  // with size target
    std::string why_missed{};               // the target, if it is
  };

  void check_engine() const;
  void number_from_what_exists();
  void settle_new_fixes();
  void check_overlap(LAMMPS_NS::Region& region) const;
  [[nodiscard]] LAMMPS_NS::Region& region(const std::string& id) const;
  [[nodiscard]] TessellationOptions options(LAMMPS_NS::Region& rock, const ArgValues& args) const;
  [[nodiscard]] SizeLaw size_law(const ArgValues& args) const;
  [[nodiscard]] std::optional<SizeTarget> size_target(const ArgValues& args) const;
  [[nodiscard]] std::vector<Hole> holes(const ArgValues& args) const;
  [[nodiscard]] std::vector<JointPlane> joint_planes(const ArgValues& args) const;
  [[nodiscard]] JointSetCut joint_sets(const ArgValues& args) const;
  [[nodiscard]] SupportRule support(const ArgValues& args) const;
  [[nodiscard]] std::size_t most_blocks(const ArgValues& args) const;
  [[nodiscard]] bool sweeps_are_shared(const ArgValues& args) const;
  void share_sweeps_of_rank_0(TessellationOptions& what) const;
  [[nodiscard]] Model cut(const TessellationOptions& what, const ArgValues& args) const;
  [[nodiscard]] std::vector<char> hand_out(const Model& model) const;
  void create(const std::vector<char>& mine, const std::vector<Hole>& holes, const ArgValues& args,
              int blocks);
  void create_body(const RigidBody& body, int tag, int first_atom_tag, const ArgValues& args);
  void report(const Model& model, double seconds) const;
  void report_filling(const Model& model) const;
  void report_target(const SizeComparison& sizes, const std::string& why) const;

  LAMMPS_NS::FixMultisphere* multisphere_ = nullptr;
  int first_tag_ = 1;
  int first_atom_tag_ = 1;
};

}  // namespace muckpile
