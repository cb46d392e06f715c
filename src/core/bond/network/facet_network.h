// SPDX-License-Identifier: GPL-2.0-or-later
// The dilatation-coupled network of joint facets between rigid polyhedral blocks: elasticity,
// breaking, and plane contact of broken facets.
// Scope: forces from the poses of the blocks; no integration, no engine. The caller fills state()
// and calls step(), which gets what other ranks own through the team that it is given; then it
// reads force() and torque(). Blocks: one row each, owned ones first, then copies of other ranks'
// blocks, the ground last. SI units; tension is positive. InputError comes from JointMaterial and
// JointLaws alone.
//
// Elasticity (Muckpile's own; kin: Chen, Lin, Jiao & Liu 2014, Asahina et al. 2015): a facet with
// normal n (from i to j), centre distance h along n and jump u = displacement of j minus that of i
// carries t = (2G/h) u + (p_i m_i + p_j m_j)/2. The dilatation of a block is
// theta = [sum over bonded facets A m.u/2 + sum over loaded faces A t_n d/(2G)] / [V s],
// s = 1 + phi lambda/(2G), phi = sum over unbonded faces of A d / V, d the distance of a face from
// the centre: free and loaded faces are condensed out. m = K n is n but for a few per cent: K is
// the inverse of the block's sum over faces of A n (x) r / V, r half the way to the neighbour's
// centre, so theta is exact in every homogeneous strain, where facets are not centred on the line
// between the centres too.
// The bulk stress p = lambda theta + [sum over bonded facets D A h (theta - theta_neighbour)] /
// [V s] keeps short waves from being slow: with p = lambda theta alone a block's dilatation spans
// two block lengths, and the P wave is too slow by (kh)^2 (lambda + G/2)/(6 (lambda + 2G)) along a
// cuboid's axis, 3/5 of that where facets face all directions. kSharpening of D stands between.
// Cuts whose faces lean against the lines between the centres also have the terms of
// leaning_faces.h.
// Where blocks i and j are of two rocks their facet has the law of two_rocks.h, the jump strains
// both in series, with the relief of border_relief.h; D is 0 at all facets of these blocks.
// Fixed supports, whose ground may yield, have m = n, and their blocks p = lambda theta; of a
// mirror only the part of m along n counts. A support whose ground yields (yielding_ground.h) is a
// bonded facet whose far side moves.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "bond/facet.h"
#include "bond/ground/yielding_ground.h"
#include "bond/network/block_fields.h"
#include "bond/network/bonded_points.h"
#include "bond/network/face_load.h"
#include "bond/network/facet_breaking.h"
#include "bond/network/facet_history.h"
#include "bond/network/facet_list.h"
#include "bond/network/facet_lists.h"
#include "bond/network/facet_schedule.h"
#include "bond/network/facet_tables.h"
#include "bond/network/gas_load.h"
#include "bond/network/joint_books.h"
#include "bond/network/leaning_faces.h"
#include "bond/network/rank_team.h"

namespace muckpile {

class FacetNetwork {
 public:
  /// `natural`: the joint classes from 1; class 0 is that of `material`. `zones`: the rocks of the
  /// zones from 1; `material` is that of zone 0. InputError: see JointLaws.
  explicit FacetNetwork(const JointMaterial& material, const std::vector<JointClass>& natural = {},
                        const std::vector<JointMaterial>& zones = {});

  /// Blocks, after which the ground is appended, and what lies between and around them, by the
  /// indices of the blocks. Collective: if the facets of any rank lean, all exchange what they
  /// need.
  void set(std::vector<BlockConstants> blocks, FacetLists lists, const RankTeam& team = {});
  /// The same blocks, with others between and around them. Of one rank.
  void set_facets(FacetLists lists);
  [[nodiscard]] FacetLists lists() const;
  /// The same, which the network has no longer. Collective: first books what breaking in the last
  /// step has cost facets whose two blocks belong to two ranks.
  [[nodiscard]] FacetLists give_up(const RankTeam& team = {});

  // A step. The pose of every block is in state().
  [[nodiscard]] std::span<BlockState> state() { return blocks_.state; }
  /// Forces, torques, breaking and losses over a step dt [s] that led to this pose; of all ranks
  /// together. Dilatations, their exchange, bulk stresses, their exchange, tractions.
  void step(double dt, const RankTeam& team = {});
  /// Dilatations and bulk stresses of this pose alone, with no time passing: what
  /// elastic_energy() and mean_traction() read.
  void find_stresses(const RankTeam& team = {}) { find_stresses(0.0, team); }
  [[nodiscard]] std::span<const Vec3> force() const { return blocks_.force; }    ///< [N]
  [[nodiscard]] std::span<const Vec3> torque() const { return blocks_.torque; }  ///< [N m]
  [[nodiscard]] std::span<const double> theta() const { return blocks_.theta; }  ///< [-]
  [[nodiscard]] std::span<const double> bulk_stress() const {
    return blocks_.bulk_stress;
  }  ///< [Pa]
  [[nodiscard]] const JointBooks& books() const { return books_; }
  [[nodiscard]] const JointLosses& losses() const { return books_.losses; }

  // The parts, to read.
  [[nodiscard]] const FacetTables& tables() const { return tables_; }
  [[nodiscard]] const FacetHistory& history() const { return history_; }
  [[nodiscard]] const FacetSchedule& schedule() const { return schedule_; }
  [[nodiscard]] const BlockFields& block_fields() const { return blocks_; }
  [[nodiscard]] FacetKinematics kinematics() const { return {tables_, history_, blocks_}; }
  /// nullptr where no facet of this rank leans.
  [[nodiscard]] const LeaningFaces* leaning() const {
    return leaning_ && leaning_->any() ? &*leaning_ : nullptr;
  }
  [[nodiscard]] bool slanted() const { return leaning() != nullptr; }
  /// Of zone 0.
  [[nodiscard]] const JointMaterial& material() const { return tables_.laws().rock(); }
  [[nodiscard]] std::size_t natural_classes() const { return tables_.laws().natural_classes(); }
  [[nodiscard]] const std::vector<BlockConstants>& blocks() const { return blocks_.constants; }
  [[nodiscard]] int ground() const { return static_cast<int>(blocks_.size()) - 1; }

  // Facets, by number.
  [[nodiscard]] std::size_t facet_count() const { return tables_.size(); }
  [[nodiscard]] FacetList facets() const { return FacetList(*this); }
  /// As it was set, but for what the tables round and supports leave out.
  [[nodiscard]] Facet facet(std::size_t f) const;
  [[nodiscard]] FacetEnds ends(std::size_t f) const {
    return {tables_.i_of(f), tables_.j_of(f), tables_.name(f).kind};
  }
  [[nodiscard]] double area(std::size_t f) const { return tables_.area(f); }  ///< [m2]
  [[nodiscard]] const std::vector<FacetTraces>& traces() const { return history_.traces(); }
  [[nodiscard]] const std::vector<FacetState>& states() const { return history_.states(); }
  [[nodiscard]] const GroundMemory& ground_memory(std::size_t f) const {
    return history_.ground(f);
  }
  [[nodiscard]] FacetMemory memory(std::size_t f) const { return history_.memory(f); }
  [[nodiscard]] std::vector<FacetMemory> memory() const;
  /// Of an intact facet on its block i, as the last step left it [Pa].
  [[nodiscard]] Vec3 mean_traction(std::size_t f) const {
    return muckpile::mean_traction(kinematics(), leaning(), f);
  }

  // Faces and their pressure.
  [[nodiscard]] const std::vector<BoundaryFace>& faces() const { return faces_.faces(); }
  /// On face k: what its block feels of `pressure` [Pa], `wave_share` of which counts as the wave's
  /// [-]. It acts until it is set again or the faces are.
  void press(std::size_t k, double pressure, double wave_share);
  /// Takes off all pressures. `booked`: the step to come books the work of unloading.
  void take_off_pressures(bool booked);
  /// For scenes that choose their loaded faces and pressures one by one.
  [[nodiscard]] std::span<BoundaryFace> faces() { return faces_.faces(); }
  void expect_pressure(bool expected) { faces_.expect_pressure(expected); }  ///< see FaceLoad
  [[nodiscard]] double volume_swept(const BoundaryFace& face) const {  ///< by a loaded face [m3]
    return FaceLoad::volume_swept(face, blocks_);
  }
  /// By the pressures of each hole in the last step on owned blocks; see FaceLoad [J].
  [[nodiscard]] std::span<const double> work_per_hole() const { return faces_.work_per_hole(); }
  /// By the pressures in the last step; see FaceLoad.
  void add_wall_forces(std::span<Vec3> wave, std::span<Vec3> gas) const {
    faces_.add_forces(wave, gas);
  }
  [[nodiscard]] double pressure_work() const { return books_.pressure_work; }  ///< [J]
  [[nodiscard]] double wave_work() const { return books_.wave_work; }          ///< [J]

  // Supports whose ground yields.
  /// The ground behind the intact `fixed` supports that `chosen` accepts by their centroid in the
  /// start configuration yields from now on; what they carry in the pose of the last step is
  /// carried for ever. Returns how many yield now that did not before.
  int let_ground_yield(const QuietGround& ground, const std::function<bool(const Vec3&)>& chosen);
  void stop_ground();  ///< every ground stays where it is from now on
  [[nodiscard]] std::size_t yielding_supports() const {
    return ground_ ? ground_->supports().size() : 0;
  }

  // Gas in joints.
  /// From now on joints that break keep gas even when retired, until they are wide.
  void keep_gas_in_joints() {
    if (!gas_) gas_.emplace();
  }
  /// Of each block, more than the atmosphere [Pa]; it acts until it is set again or the blocks are.
  void set_gas_pressure(std::span<const double> pressure);
  [[nodiscard]] std::span<const Vec3> gas_force() const;  ///< in force() too; empty: none [N]
  [[nodiscard]] std::span<const Vec3> gas_torque() const;
  /// In the joint of facet f, more than the atmosphere [Pa].
  [[nodiscard]] double gas_pressure(std::size_t f) const {
    const auto [i, j] = tables_.blocks_of(f);
    return gas_ ? gas_->between(i, j) : 0.0;
  }
  void release_gas(std::size_t f) { history_.release_gas(f); }
  void release_gas();  ///< all of it, for good
  /// Work of the gas on owned blocks [J], to be part of pressure_work().
  void book_gas_work(double joules) { books_.pressure_work += joules; }
  /// Of each of `facets`, in order.
  void open_joints(std::span<const LaneSet> facets, OpenJoints& open) const {
    muckpile::open_joints(kinematics(), facets, open);
  }

  // Rest; one entry per block, the ground last.
  /// Facets between two blocks that rest are left alone by step() from now on: their forces are
  /// missing, and their blocks must be kept where they are.
  void let_rest(std::span<const int> rests);
  void wake_all();
  /// Sets `disturbed` of every block that shares an acting facet with one of `moves`, or lies on
  /// ground that yields.
  void mark_joined(std::span<const int> moves, std::span<int> disturbed) const;
  /// Sets the entry of every block that has an acting facet, of as many as there are entries.
  void mark_jointed(std::span<char> jointed) const;

  // Sums over what this rank books.
  [[nodiscard]] double elastic_energy() const;  ///< of joints, rock and closed broken facets [J]
  /// Of broken points, `all`: of all joints [m2].
  [[nodiscard]] double broken_area(bool all) const;
  [[nodiscard]] double broken_count() const;  ///< facets with a broken point [-]
  struct TableSize {
    const char* table;
    double bytes;
  };
  [[nodiscard]] std::vector<TableSize> table_sizes() const;
  [[nodiscard]] double memory_usage() const;  ///< of its tables [bytes]

  // A run that goes on.
  /// Continues with softer rock: every stiffness times `factor` in the present pose, so every
  /// traction falls to that share. The elastic energy given up is booked as fracture loss.
  /// `damping` replaces that of all joints.
  void soften(double factor, std::optional<double> damping = {}, const RankTeam& team = {});
  /// To be kept. Collective, as give_up().
  [[nodiscard]] NetworkTotals totals(const RankTeam& team = {});
  /// Stiffness over that of the start [-].
  [[nodiscard]] double softened() const { return books_.softened; }
  [[nodiscard]] RockSoftness softness() const { return {books_.softened, books_.damping_given}; }
  /// What breaking changes bit by bit is worked out from the facets again, as in a network that
  /// gets them from a restart file: the two then agree to the last bit.
  void derive_anew();
  /// Before the first step: goes on from these totals, with rock that soft.
  void resume(const NetworkTotals& totals);

 private:
  void find_stresses(double dt, const RankTeam& team);
  void settle_books(const RankTeam& team);
  void share_thetas(std::size_t count, const RankTeam& team);
  void book_shared_changes();
  [[nodiscard]] bool ground_yields() const { return ground_ && ground_->any(); }
  [[nodiscard]] FacetBreaking::Parts breaking_parts();
  void list_anew();
  void list_facets() { schedule_.list(tables_, history_, faces_.faces(), slanted()); }
  void count_unbonded();

  FacetTables tables_;
  FacetHistory history_;
  BlockFields blocks_;
  FacetSchedule schedule_;
  FaceLoad faces_;
  JointBooks books_;
  std::optional<LeaningFaces> leaning_;   // where a facet of any rank leans
  std::optional<YieldingGround> ground_;  // where a ground yields, or has yielded
  std::optional<GasLoad> gas_;            // where joints keep gas
};

}  // namespace muckpile
