// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint: forces of the joint facets between blocks, their breaking and plane contact.
// Scope: drives core's FacetNetwork; three halo messages a step (poses, dilatations, bulk stresses)
// and no other communication except where a script reads a result.
#pragma once

#include <fix.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "bond/network/block_stress.h"
#include "bond/network/facet_network.h"
#include "fixes/interfaces/acting_joints.h"
#include "fixes/interfaces/blast_surface.h"
#include "fixes/interfaces/block_neighbours.h"
#include "fixes/interfaces/block_stresses.h"
#include "fixes/interfaces/facet_store.h"
#include "fixes/interfaces/force_parts.h"
#include "fixes/interfaces/joint_damage.h"
#include "fixes/interfaces/joint_energies.h"
#include "fixes/interfaces/joint_fragments.h"
#include "fixes/interfaces/joint_pressure.h"
#include "fixes/interfaces/joint_view.h"
#include "fixes/interfaces/joints_with_gas.h"
#include "fixes/interfaces/rock_view.h"
#include "fixes/interfaces/step_limit.h"
#include "fixes/interfaces/yielding_supports.h"
#include "fixes/joints/joint_step_check.h"

namespace muckpile {

struct JointArguments;

class FixMuckpileJoint : public LAMMPS_NS::Fix,
                         public FacetKeeper,
                         public JointView,
                         public BlastSurface,
                         public YieldingSupports,
                         public JoinedBlocks,
                         public StepLimit,
                         public JointsWithGas,
                         public BlockStresses,
                         public JointEnergies,
                         public ForceParts,
                         public JointFragments,
                         public JointDamage,
                         public ActingJoints,
                         public RockView {
 public:
  FixMuckpileJoint(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~FixMuckpileJoint() override;

  void post_create() override;
  int setmask() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup_pre_neighbor() override { follow_blocks(); }
  void pre_neighbor() override { follow_blocks(); }
  void setup(int vflag) override;
  void post_force(int vflag) override;
  void end_of_step() override;
  double compute_vector(int n) override;
  int modify_param(int narg, char** arg) override;
  double memory_usage() override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;

  [[nodiscard]] FacetLists copy() const override;
  FacetLists hand_back() override;
  [[nodiscard]] RockSoftness softness() const override { return network_.softness(); }
  void store_is_gone() override { store_ = nullptr; }

  [[nodiscard]] int facet_between(int block_tag_a, int block_tag_b) const override;
  [[nodiscard]] const FacetState* facet_states() const override { return network_.states().data(); }
  void joined_pairs(const std::vector<int>& blocks, std::vector<double>& tags) const override;
  [[nodiscard]] bool enclosed(int block_tag) const override;
  void mark_joined_bodies(std::span<char> joined) const override { network_.mark_jointed(joined); }

  [[nodiscard]] int hole_count() const override;
  [[nodiscard]] const Hole& hole(int index) const override;
  [[nodiscard]] std::span<const LoadedFacet> loaded_facets() const override { return loaded_; }
  [[nodiscard]] std::uint64_t loaded_facets_version() const override { return version_; }
  void set_pressure(std::span<const double> pressure, std::span<const double> wave_share) override;
  void expect_pressure(bool expected) override;
  [[nodiscard]] double shear_modulus() const override;
  [[nodiscard]] double softened() const override { return network_.softened(); }
  void unload_softened() override;
  void swept_volume(std::span<double> per_hole) const override;
  void work_of_step(std::span<double> per_hole) const override;
  [[nodiscard]] double pressure_work() const override { return network_.pressure_work(); }
  [[nodiscard]] double wave_work() const override { return network_.wave_work(); }

  Chosen let_ground_yield(const std::function<bool(const Vec3&)>& chosen,
                          double rock_behind) override;
  void stop_ground() override { network_.stop_ground(); }
  [[nodiscard]] double supports_yielding() const override {
    return static_cast<double>(network_.yielding_supports());
  }
  [[nodiscard]] StepBound stable_step(Breaking breaking, double guess) const override;
  [[nodiscard]] int stiffness_changes() const override { return softenings_; }
  [[nodiscard]] RockConstants rock() const override;

  void mark_joined(std::span<const char> moves, std::span<char> disturbed) override;
  void let_rest(std::span<const char> rests) override;
  void wake_all() override { network_.wake_all(); }

  [[nodiscard]] double energy_given() const override { return network_.losses().quiet; }
  [[nodiscard]] double energy_radiated() const override { return network_.losses().radiated; }

  [[nodiscard]] double joints_broken() const override;
  [[nodiscard]] std::vector<int> fragment_ids() const override;
  [[nodiscard]] std::vector<double> broken_share() const override;
  [[nodiscard]] std::vector<HoldingJoint> holding_joints() const override;
  void add_cost_of_joints(std::span<double> costs, double cost) const override;

  [[nodiscard]] std::vector<Mat3> stresses(std::span<const int> bodies) const override {
    return block_stresses(network_, bodies);
  }
  [[nodiscard]] std::vector<double> distances_from_blocks(const Vec3& point) const override {
    return muckpile::distances_from_blocks(network_, point);
  }

  [[nodiscard]] JointEnergySums energies() const override;
  [[nodiscard]] std::span<const Vec3> joint_forces() const override { return network_.force(); }
  [[nodiscard]] std::span<const Vec3> joint_torques() const override { return network_.torque(); }
  void forces_by_part(std::span<ByPart> forces) override;

  [[nodiscard]] JointRooms rooms() const override { return JointRooms(network_); }
  [[nodiscard]] std::uint64_t lists_version() const override { return version_; }
  [[nodiscard]] std::vector<int> block_tags() const override;
  [[nodiscard]] const engine::BlockHalo& halo() const override { return store_->halo(); }
  void keep_gas_in_joints() override { network_.keep_gas_in_joints(); }
  void release_gas() override { network_.release_gas(); }
  void release_gas(std::span<const std::uint32_t> joints) override;
  [[nodiscard]] double gas_power() const override;
  void book_gas_work(double work) override { network_.book_gas_work(work); }

 private:
  FixMuckpileJoint(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, JointArguments arguments);

  /// What compute_vector() gives.
  enum class Output {
    joints,
    broken,
    broken_share,
    elastic,
    fracture,
    friction,
    damping,
    longest_step,
    pressure_work_done,
    softened,
    crushing,
    count
  };

  void check_classes() const;
  void warn_of_other_density() const;
  void end_what_does_not_go_on();
  void go_on_as_soft(const RockSoftness& found);
  void follow_blocks();
  /// False before the first run, and from create_blocks to the next one.
  [[nodiscard]] bool follows_blocks() const {
    return store_ != nullptr && version_ != 0 && version_ == store_->version();
  }
  void add_forces(double dt);
  void gather_state();
  void press_gas();
  void apply_forces();
  void index_facets();
  void refresh_enclosed();
  void ask_for_neighbours();
  [[nodiscard]] bool joint_let_go() const;
  void gather_flags(std::span<const char> of_bodies);
  [[nodiscard]] double sum(double mine) const;

  [[nodiscard]] RankTeam team() const;

  FacetNetwork network_;
  std::vector<std::string> zones_;  // names, from 1 on
  JointStepCheck step_check_;
  bool contact_check_;
  FacetStore* store_ = nullptr;
  JointPressure* gas_ = nullptr;  // looked up in every init(), nullptr if there is none
  std::uint64_t version_ = 0;
  // For facet_between: lower tags in order, the first facet of each, the upper tag of every facet.
  std::vector<int> lower_tags_, upper_tags_;
  std::vector<std::size_t> first_of_;
  std::vector<int> enclosed_tags_;         // sorted
  std::vector<std::size_t> loaded_faces_;  // positions in network_.faces()
  std::vector<LoadedFacet> loaded_;
  std::vector<double> poses_;
  std::vector<int> of_blocks_;                  // work space of mark_joined() and let_rest()
  std::vector<Vec3> wave_forces_, gas_forces_;  // work space of forces_by_part() [N]
  bool cracked_since_build_ = false;
  int softenings_ = 0;
  bool contact_missed_ = false;  ///< a joint has let go, and there is no contact law
  bool ends_ = false;            ///< this fix is being deleted
  bool goes_on_ = false;         ///< after a restart file: what does not go on has ended
};

}  // namespace muckpile
