// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: contact between the spheres of different blocks.
// Scope: bodies of one fix multisphere; newton off; makes no neighbour request, searches by block.
#pragma once

#include <pair.h>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "contact/block_contact_list.h"
#include "contact/contact_forces.h"
#include "contact/contact_law.h"
#include "contact/contact_pace.h"
#include "contact/contact_step_bound.h"
#include "fixes/contact/fix_muckpile_contact_history.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/strange_bodies.h"
#include "fixes/interfaces/block_contact_view.h"
#include "fixes/interfaces/block_neighbours.h"
#include "fixes/interfaces/contact_steps.h"
#include "fixes/interfaces/contact_work.h"
#include "fixes/interfaces/joint_view.h"
#include "fixes/interfaces/paced_contacts.h"
#include "fixes/interfaces/resting_blocks.h"

namespace LAMMPS_NS {
class FixMultisphere;
}

namespace muckpile {

class SharedStepBound;
struct SolidParts;

class PairMuckpileBlock : public LAMMPS_NS::Pair,
                          public ContactSource,
                          public ContactWork,
                          public NearBlocks,
                          public BlockContactView,
                          public PacedContacts {
 public:
  static constexpr const char* kStyle = "pair_style muckpile/block";

  explicit PairMuckpileBlock(LAMMPS_NS::LAMMPS* engine_object);
  PairMuckpileBlock(const PairMuckpileBlock&) = delete;
  PairMuckpileBlock& operator=(const PairMuckpileBlock&) = delete;
  ~PairMuckpileBlock() override;

  void settings(int narg, char** arg) override;
  void coeff(int narg, char** arg) override;
  void init_style() override;
  double init_one(int i, int j) override;
  void compute(int eflag, int vflag) override;
  double memory_usage() override;
  int pack_comm(int n, int* list, double* buffer, int pbc_flag, int* pbc) override;
  void unpack_comm(int n, int first, double* buffer) override;
  int pack_reverse_comm(int n, int first, double* buffer) override;
  void unpack_reverse_comm(int n, int* list, double* buffer) override;

  /// Values of this rank, to be summed over ranks (largest for max_overlap_ratio, smallest for
  /// the steps); a contact between two ranks counts half on each. Pointers to double:
  /// "elastic_J", "contacts", "max_overlap_ratio" of the last step; "friction_J", "damping_J"
  /// since the start; "steps_s", see ContactStep, worked out when asked
  /// for, by all ranks at once; "rebuild_s", "rebuilds".
  void* extract(const char* name, int& dim) override;

  void store_contacts(FixMuckpileContactHistory& history) override;
  [[nodiscard]] ContactLosses& losses() override { return losses_; }
  [[nodiscard]] ContactPace& pace() override { return pace_; }
  [[nodiscard]] bool polyhedra() const override { return solids_ != nullptr; }

  void mark_near(std::span<const char> from, std::span<char> to) const override;

  [[nodiscard]] std::optional<BlockContacts> hertz_contacts() const override { return hertz_; }
  [[nodiscard]] const ContactParameters& contact_parameters() const override { return parameters_; }

  void act_every(int steps) override { pace_.act_every(steps); }
  [[nodiscard]] bool act_for_several() const override;

  void watch() override { watched_ = true; }
  double end_step(double time_step) override;
  /// For tests of the energy account, see ContactForces.
  void spoil(double share);

 private:
  struct Ledger {
    double all_elastic_J = 0.0;  ///< worked out when asked for
    std::array<double, kContactSteps> steps_s{};
    double rebuild_s = 0.0, rebuilds = 0.0;
  };
  void require_engine_settings();
  void find_partners();
  [[nodiscard]] double step_of_light_contacts() const;
  [[nodiscard]] ContactMotion held_still(const SpherePair& pair) const;
  [[nodiscard]] ContactStepBound bodies_without_contacts() const;
  void add_walls(SharedStepBound& shared) const;
  /// A contact between a joined block and a free one counts for both. Collective.
  [[nodiscard]] ContactStepBound present_contacts();

  void rebuild();
  void list_pairs();
  /// Those of blocks that have moved far, where few have; false: nothing done.
  [[nodiscard]] bool add_pairs();
  void share_enclosed();
  void share_joined_pairs();
  void number_blocks();
  int block_of(int body_tag, int sphere);
  int add_block(int body_tag, int sphere);
  /// From pair `first` on.
  void drop_intact_pairs(std::vector<BlockPair>& pairs, std::size_t first) const;
  void recall_contacts();
  [[nodiscard]] SphereSet spheres() const;
  [[nodiscard]] std::span<SpherePair> near_spheres(const BlockPair& pair) {
    return {list_.sphere_pairs(pair), static_cast<std::size_t>(pair.count)};
  }
  /// A pair whose facet still acts itself has no sphere contact.
  void deactivate_joined_pairs(std::size_t first);
  void activate_parted_pairs();
  /// Pairs of blocks that both rest are left alone, with their contacts as they are.
  void list_working_pairs(std::size_t first);
  /// Of the contacts left alone, to be added to those of the last step.
  [[nodiscard]] double resting_energy();

  [[nodiscard]] MovingSpheres moving_spheres();
  [[nodiscard]] ContactPace::Act act_of_step();
  void step_contacts();
  void strengthen();
  void add_losses(double memory_step);

  // Where blocks touch in their own shape, pair_muckpile_block_solids.cpp has in place of these:
  void take_shapes();
  /// Stops where spheres have other tags than create_blocks gave them. Collective.
  void require_keys();
  void step_solids(double memory_step);
  /// Stored by a contact [J].
  [[nodiscard]] double solid_energy(const SpherePair& pair);
  void add_solid_contact(SharedStepBound& shared, const SpherePair& pair);
  [[nodiscard]] double step_of_light_solids() const;
  [[nodiscard]] const std::vector<int>& loaded_blocks() const;
  void forget_loads();

  void begin_loads();
  void renumber_loads();
  [[nodiscard]] std::optional<engine::BodyState> state_of(const engine::Bodies& bodies,
                                                          int block) const;

  ContactParameters parameters_;
  std::optional<ContactLaw> law_;
  std::optional<BlockContacts> hertz_;  ///< without it the law is linear
  std::unique_ptr<SolidParts> solids_;  ///< null: blocks touch with their spheres
  double largest_radius_ = 0.0;         ///< of all spheres on all ranks [m]
  LAMMPS_NS::FixMultisphere* bodies_ = nullptr;
  const JointView* joints_ = nullptr;
  const RestingBlocks* resting_ = nullptr;        ///< null: none rests
  FixMuckpileContactHistory* history_ = nullptr;  ///< owned by the engine

  struct InactivePair {
    std::size_t pair;  ///< of list_.block_pairs()
    int facet;         ///< of joints_->facet_states()
  };

  BlockContactList list_;
  std::vector<InactivePair> inactive_;
  std::vector<std::size_t> working_, left_alone_;  ///< of list_.block_pairs()
  std::vector<std::size_t> awake_;                 ///< of working_, with candidates in this step
  std::uint64_t rests_version_ = 0;                ///< that the two are made for
  ContactStates contacts_;
  ContactForces forces_;
  ContactPace pace_;
  ContactPace::Act act_;         ///< of the last step
  bool list_is_stale_ = true;    ///< atoms were exchanged since the list was built
  bool contacts_moved_ = false;  ///< forces were computed since the contacts were stored

  /// Of tags, the lower first, in order, the same on all ranks: see share_joined_pairs().
  std::vector<std::pair<int, int>> held_pairs_;
  std::vector<char> enclosed_;               ///< per sphere; empty without joints
  std::vector<int> atom_block_;              ///< per atom, -1: takes no part
  std::vector<int> block_tag_;               ///< per block: its body tag
  std::vector<std::array<double, 3>> seed_;  ///< per block: position of its first atom [m]
  std::vector<int> first_sphere_;            ///< per block: that atom
  std::vector<int> next_image_;              ///< per block: another periodic image, -1: none
  std::vector<int> first_image_;             ///< per body tag: a block, -1: none
  std::vector<int> listed_tags_;             ///< per atom: its tag when the list was built
  int listed_owned_ = 0;

  bool watched_ = false;            ///< a fix sums what the contacts do to the blocks
  std::vector<ContactLoad> loads_;  ///< per block, of the last step; empty: they are not summed
  engine::StrangeBodies strange_;   ///< of several ranks

  std::vector<int> record_owners_;  ///< work space of store_contacts
  std::vector<FixMuckpileContactHistory::Record> records_;
  ContactSums last_;  ///< of the last step, without what is left alone
  Ledger ledger_;
  ContactLosses losses_;
};

}  // namespace muckpile
