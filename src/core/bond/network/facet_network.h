// SPDX-License-Identifier: GPL-2.0-or-later
// The dilatation-coupled network of joint facets between rigid polyhedral blocks: elasticity,
// breaking, and plane contact of broken facets.
// Scope: forces from the poses of the blocks; no integration, no engine, no communication. The
// caller fills state() and calls dilatation(), bulk_stresses() and tractions(); after each of the
// first two it sets what blocks it does not own have (theta(), bulk_stress()). Then it reads
// force() and torque().
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
// facet_slant.cpp.
// Fixed supports, whose ground may yield, have m = n, and their blocks p = lambda theta; of a
// mirror only the part of m along n counts. A support whose ground yields (quiet_ground.h) is a
// bonded facet whose far side moves.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bond/facet.h"
#include "bond/ground/quiet_ground.h"
#include "bond/law/coulomb.h"
#include "bond/law/joint_material.h"
#include "bond/law/linear_closure.h"
#include "bond/law/slip_friction.h"
#include "bond/network/contact_rows.h"
#include "bond/network/facet_group.h"
#include "bond/network/facet_list.h"
#include "bond/network/facet_memory.h"
#include "bond/network/network_block.h"
#include "math/types.h"

namespace muckpile {

inline constexpr double kSharpening = 2.0 / 3.0;  ///< see above: 1 for cuboids, 3/5 on average

/// Cumulative losses of this rank [J].
struct JointLosses {
  double fracture = 0.0;
  double friction = 0.0;
  double damping = 0.0;
  double quiet = 0.0;     ///< given to the rock behind yielding supports, in all
  double radiated = 0.0;  ///< of that, carried away by waves
};

/// What a network has added up, for a run that continues it.
struct NetworkTotals {
  JointLosses losses;
  double pressure_work = 0.0, wave_work = 0.0;  ///< [J]
  double softened = 1.0;                        ///< product of all factors of soften() [-]
  std::optional<double> damping;                ///< the last one given to soften() [-]
  QuietGround quiet_ground;
  bool moved_unseen = false;  ///< faces have moved while no pressure was there nor expected
  bool softer_since = false;  ///< than as the faces were loaded last
};

enum class BreakView : std::uint8_t;
class LinearNetwork;

class FacetNetwork {
 public:
  /// `natural`: the joint classes from 1; class 0 is that of `material`.
  explicit FacetNetwork(const JointMaterial& material, const std::vector<JointClass>& natural = {});

  /// Blocks first (owned ones first; the ground is appended), then facets and faces with their
  /// indices set.
  void set_blocks(std::vector<BlockConstants> blocks);
  [[nodiscard]] int ground() const { return static_cast<int>(blocks_.size()) - 1; }
  void set_facets(std::vector<Facet> facets, std::vector<FacetMemory> memory);
  void set_faces(std::vector<BoundaryFace> faces);
  /// The facets with all that they remember and the faces, which the network has no longer.
  void give_up(std::vector<Facet>& facets, std::vector<FacetMemory>& memory,
               std::vector<BoundaryFace>& faces);

  [[nodiscard]] const JointMaterial& material() const { return materials_.front(); }
  [[nodiscard]] std::size_t natural_classes() const { return materials_.size() - 1; }
  [[nodiscard]] const std::vector<BlockConstants>& blocks() const { return blocks_; }
  [[nodiscard]] FacetList facets() const { return FacetList(*this); }
  /// As it was set, but for what the tables round and supports leave out (place_facet()).
  [[nodiscard]] Facet facet(std::size_t f) const;
  [[nodiscard]] FacetEnds ends(std::size_t f) const { return {i_of(f), j_of(f), facets_[f].kind}; }
  [[nodiscard]] double area(std::size_t f) const { return group_of(f).area[lane_of(f)]; }  ///< [m2]
  [[nodiscard]] std::size_t facet_count() const { return facets_.size(); }
  [[nodiscard]] const std::vector<FacetTraces>& traces() const { return traces_; }
  [[nodiscard]] const GroundMemory& ground_memory(std::size_t f) const {
    return rare_.get(f).ground;
  }
  /// All that a facet remembers, put together.
  [[nodiscard]] FacetMemory memory(std::size_t f) const;
  [[nodiscard]] std::vector<FacetMemory> memory() const;
  [[nodiscard]] const std::vector<FacetState>& states() const { return states_; }
  [[nodiscard]] std::vector<BoundaryFace>& faces() { return faces_; }
  [[nodiscard]] const std::vector<BoundaryFace>& faces() const { return faces_; }
  [[nodiscard]] std::span<BlockState> state() { return state_; }
  [[nodiscard]] std::span<double> theta() { return theta_; }
  [[nodiscard]] std::span<double> bulk_stress() { return bulk_stress_; }  ///< [Pa]
  /// A facet of this rank is slanted. Where one of any rank is, gradients() and slant_stresses() of
  /// copies are to be set after dilatation() too; nine numbers per block.
  [[nodiscard]] bool slanted() const { return !slants_.empty(); }
  /// Of so many blocks from the first; room is made for them where no facet is slanted.
  [[nodiscard]] std::span<double> gradients(std::size_t blocks);
  [[nodiscard]] std::span<double> slant_stresses(std::size_t blocks);  ///< [Pa]
  [[nodiscard]] std::span<const Vec3> force() const { return force_; }
  [[nodiscard]] std::span<const Vec3> torque() const { return torque_; }

  /// Theta of every block from the poses, right for owned blocks; yielding supports give way over
  /// the step dt [s] that led here.
  void dilatation(double dt = 0.0);
  void bulk_stresses();  ///< of every block from all theta; right for owned blocks that tractions()
                         ///< looks at
  void tractions(double dt);  ///< forces, torques, breaking, losses over a step dt [s]

  /// The ground behind the intact `fixed` supports that `chosen` accepts by their centroid in the
  /// start configuration yields from now on; what they carry in the present pose is held. To be
  /// called after dilatation(). Returns how many yield now that did not before.
  int let_ground_yield(const QuietGround& ground, const std::function<bool(const Vec3&)>& chosen);
  void stop_ground();  ///< every ground stays where it is from now on
  [[nodiscard]] std::size_t yielding_supports() const { return yielding_.size(); }

  /// Gas in the broken joints of each block, more than the atmosphere [Pa]; set for all blocks, it
  /// acts in tractions() until it is set again or the blocks are. A joint has the mean of its two.
  [[nodiscard]] std::span<double> gas_pressure();
  [[nodiscard]] std::span<const Vec3> gas_force() const { return gas_force_; }  ///< in force() too
  [[nodiscard]] std::span<const Vec3> gas_torque() const { return gas_torque_; }
  /// From now on joints that break keep gas even when retired, until they are wide.
  void keep_gas_in_joints() { keeps_gas_ = true; }
  void release_gas(std::size_t f) { traces_[f].gas = false; }
  void release_gas();  ///< all of it, for good
  /// Work of the gas on owned blocks [J], to be part of pressure_work().
  void book_gas_work(double joules) { pressure_work_ += joules; }
  struct OpenJoint {
    double area = 0.0;     ///< of broken points [m2]
    double opening = 0.0;  ///< mean over them [m]
    bool wide = false;     ///< so far open, slid or turned that it is no joint for gas either
  };
  /// Of each of `facets`, in order.
  void open_joints(std::span<const LaneSet> facets, std::vector<OpenJoint>& open) const;

  /// Facets between two blocks that rest are left alone by tractions() from now on: their forces
  /// are missing, and their blocks must be held where they are. One entry per block, ground last.
  void let_rest(std::span<const int> rests);
  void wake_all();

  /// Sets `disturbed` of every block that shares an acting facet with one of `moves`, or lies on
  /// ground that yields. One entry per block, ground last.
  void mark_joined(std::span<const int> moves, std::span<int> disturbed) const;
  /// Sets `held` of every block that has an acting facet, of as many as it has entries.
  void mark_held(std::span<char> held) const;

  /// Of an intact facet on its block i, as the last passes left it [Pa].
  [[nodiscard]] Vec3 mean_traction(std::size_t f) const;
  [[nodiscard]] double elastic_energy() const;  ///< of joints, rock and closed broken facets [J]
  [[nodiscard]] double volume_swept(const BoundaryFace& face) const;  ///< by a loaded face [m3]
  /// Whether faces will be under pressure again. While none is expected nor there, they sweep
  /// nothing.
  void expect_pressure(bool expected);
  [[nodiscard]] double pressure_work() const {
    return pressure_work_;
  }                                                              ///< on owned blocks so far [J]
  [[nodiscard]] double wave_work() const { return wave_work_; }  ///< of that, by waves [J]
  [[nodiscard]] const JointLosses& losses() const { return losses_; }
  [[nodiscard]] bool newly_cracked() const {
    return newly_cracked_;
  }  ///< a facet cracked in the last call
  [[nodiscard]] bool newly_let_go() const {
    return newly_let_go_;
  }  ///< a cracked facet began to fade or retired in the last call
  [[nodiscard]] double broken_area(
      bool all) const;                        ///< booked by this rank, `all`: of all joints [m2]
  [[nodiscard]] double broken_count() const;  ///< facets with a broken point, booked share
  struct TableSize {
    const char* table;
    double bytes;
  };
  [[nodiscard]] std::vector<TableSize> table_sizes() const;
  [[nodiscard]] double memory_usage() const;  ///< of its tables [bytes]

  /// Springs about the pose of the last force computation, for LinearNetwork.
  void linearise(LinearNetwork& linear, BreakView view, double damping_rate) const;

  /// Continues with softer rock: every stiffness times `factor` in the present pose, so every
  /// traction falls to that share. The elastic energy given up is booked as fracture loss. Theta
  /// and bulk stress must be those of the present pose. `damping` replaces that of all joints.
  void soften(double factor, std::optional<double> damping = {});

  [[nodiscard]] NetworkTotals totals() const {
    return {losses_,
            pressure_work_,
            wave_work_,
            softened_,
            damping_given_,
            quiet_ground_,
            unloaded_ || moved_unseen_,
            softer_since_};
  }
  /// What breaking changes bit by bit is worked out from the facets again, as in a network that
  /// gets them from a restart file: the two then agree to the last bit.
  void derive_anew();
  /// Of a network just made: goes on from these totals, with rock that soft.
  void resume(const NetworkTotals& totals);

 private:
  struct FacetName {     // what the passes hardly read; the rest is in the facet's group
    float weight;        // as in Facet
    std::uint16_t face;  // cells from files have at most so many, cut ones far fewer
    std::uint8_t joint_class;
    FacetKind kind : 2;
    bool sharpened : 1, slanted_i : 1, slanted_j : 1;

    [[nodiscard]] std::array<bool, 2> slanted() const { return {slanted_i, slanted_j}; }
  };
  static_assert(sizeof(FacetName) == 8);
  struct Strength {  // of a joint class
    CoulombStrength<double> bonded;
    double tan_residual;  // [-]
  };
  // One facet's, put together when asked for.
  struct Bond : LinearClosure<double> {  // of the bonded points
    Vec3 opening_i, opening_j;
    double area_i, area_j;  // area x share of the jump that strains the rock of block i and j [m2]
    double point_area;      // [m2]
    double bulk_i, bulk_j;  // share of the two bulk stresses in the traction [-]
  };
  struct Contact {      // of the broken points
    double weight;      // as in Facet
    double point_area;  // [m2]
    LinearContact<double> closure;
    double shear;           // stiffness when closed [Pa/m]
    double radius_squared;  // of the circle of equal area [m2]

    [[nodiscard]] double radius() const { return std::sqrt(radius_squared); }
    [[nodiscard]] bool longer(double length, double radii) const {
      return length > 0.0 && length * length > radii * radii * radius_squared;
    }
  };
  struct Coupling {  // of the dilatations of two blocks
    int i, j;
    double sharpening;  // energy per square of the difference, twice; of the bonded points [J]
  };
  struct Openings {
    Vec3 i, j;
  };
  struct Slant {                                           // of a facet
    std::array<Vec3, 2> lean{Vec3::Zero(), Vec3::Zero()};  // d/h - m of both blocks, in the start
    double shear_share =
        1.0;  // of the jump that strains rock over that along the normal; 0: mirror

    /// The part of a jump that strains rock, over its share along the normal.
    [[nodiscard]] Vec3 strained(const Vec3& jump, const Vec3& normal) const {
      return shear_share * jump + (1.0 - shear_share) * normal.dot(jump) * normal;
    }
  };
  struct BlockSlant {  // sums over the bonded facets of a block that is slanted, over its volume
    Mat3 excess = Mat3::Zero();  // A u (x) lean/2 [-]
    Mat3 moment = Mat3::Zero();  // symmetric part of A d (x) lean/2, in the start [-]
    Mat3 dropped_gradient = Mat3::Zero(), dropped_excess = Mat3::Zero(),
         dropped_moment = Mat3::Zero();  // lost by breaking in this step
  };
  struct Motion;       // how the two sides lie now, in lanes
  struct WidePose;     // of the facets of a group at once
  struct WideField;    // over the facets of a group at once
  struct WideParting;  // how far they have opened, slid and turned
  struct WideContact;  // what broken facets of a group remember
  struct WideTurn;     // of the two sides of the facets of a group against each other
  struct Pull;         // tractions at the points, in lanes
  struct Break;        // what a point carried as it broke
  struct Remnant;      // and what it still carries
  struct BlockSums {
    double bonded = 0.0;    // sum of A m.u/2 [m3]
    double loaded = 0.0;    // sum of A t_n d/(2G) [m3]
    double unbonded = 0.0;  // phi, faces and broken facets [-]
    double uneven = 0.0;    // sum of D A h (theta - theta of the neighbour) [J]
  };
  struct Dropped {  // by a point that broke in this step, from the sums of one of its blocks
    std::size_t block;
    double bonded, unbonded;
  };

  // Tables, of facet f: facet_network.cpp.
  [[nodiscard]] const FacetGroup& group_of(std::size_t f) const { return groups_[f / kGroup]; }
  [[nodiscard]] FacetGroup& group_of(std::size_t f) { return groups_[f / kGroup]; }
  [[nodiscard]] static std::size_t lane_of(std::size_t f) { return f % kGroup; }
  [[nodiscard]] int i_of(std::size_t f) const { return group_of(f).i[lane_of(f)]; }
  [[nodiscard]] int j_of(std::size_t f) const { return group_of(f).j[lane_of(f)]; }
  [[nodiscard]] Bond bond_of(std::size_t f) const;
  [[nodiscard]] Contact contact_of(std::size_t f) const;
  [[nodiscard]] double residual_friction(std::size_t f) const;
  [[nodiscard]] double rock_share(std::size_t f) const {
    return (facets_[f].kind == FacetKind::joint ? 2.0 : 1.0) * group_of(f).bulk[lane_of(f)];
  }
  [[nodiscard]] Coupling coupling_of(std::size_t f) const {
    return {i_of(f), j_of(f), group_of(f).sharpening[lane_of(f)]};
  }
  [[nodiscard]] Vec3 arm_j_of(std::size_t f) const {
    return at_lane(group_of(f).arm_j, lane_of(f));
  }

  // Set-up and bookkeeping: facet_network.cpp.
  void derive();
  void place_facet(std::size_t f, const Facet& facet);
  void place_memory(std::size_t f, const FacetMemory& memory);
  void derive_facet(std::size_t f);
  void count_unbonded();
  void list_anew();
  void list_active();
  void list_working();
  void list_stirred();
  [[nodiscard]] bool leaves_resting() const { return any_rests_ && yielding_.empty(); }
  void open_resting();
  [[nodiscard]] double stiffening(const BlockSums& sums) const;
  [[nodiscard]] double theta_of(std::size_t b) const;
  [[nodiscard]] std::pair<double, double> depths(std::size_t f) const;
  [[nodiscard]] Motion motion_of(std::size_t f) const;
  [[nodiscard]] Openings openings_of(std::size_t f, double scale) const;
  [[nodiscard]] double facet_energy(std::size_t f) const;
  [[nodiscard]] double block_potential(std::size_t b, const BlockSums& sums) const;
  [[nodiscard]] double block_energy(std::size_t b) const;

  // Groups of facets that hold at every point: facet_groups.cpp.
  [[nodiscard]] unsigned whole_lanes(std::size_t group) const;
  [[nodiscard]] WidePose pose_of(const FacetGroup& group) const;
  void open_group(const LaneSet& bonded);
  void work_groups(double dt);
  void work_group(const LaneSet& working, const LaneSet& active, double dt);
  void fetch_contacts(const LaneSet& working) const;
  [[nodiscard]] unsigned hold_group(std::size_t g, unsigned lanes, const WidePose& pose, double dt,
                                    WideForces& forces) const;
  [[nodiscard]] WideField pull_of(const FacetGroup& group, const WidePose& pose) const;
  [[nodiscard]] static WideField jump_of(const FacetGroup& group, const WidePose& pose);
  [[nodiscard]] WideField rate_of(const FacetGroup& group, const WidePose& pose) const;
  [[nodiscard]] static WideTurn turn_of(const FacetGroup& group, const WidePose& pose);
  [[nodiscard]] static unsigned slid_along(const FacetGroup& group, const WidePose& pose);
  [[nodiscard]] unsigned holding(std::size_t g, unsigned lanes, const WidePose& pose,
                                 const WideField& pull) const;
  void damp_group(std::size_t g, const WidePose& pose, WideField& pull, double dt,
                  WideForces& forces) const;

  // Bonded points: facet_bond.cpp.
  void open_facet(std::size_t f);
  [[nodiscard]] Vec3 bulk_traction(std::size_t f, const Openings& openings) const;
  [[nodiscard]] Pull bonded_pull(std::size_t f, const Motion& motion) const;
  void work_facet(std::size_t f, double dt);
  void work_bonded(std::size_t f, const Motion& motion, const Contact& contact, Pull& pull,
                   double dt);
  [[nodiscard]] LaneVec elastic_jump(std::size_t f, const Motion& motion) const;
  Vec3 break_point(std::size_t f, int p, const Break& broken, double dt);
  struct ThroughBlocks {
    double dilatations;  // by the part of m in the facet's plane
    double slant;        // where faces lean (facet_slant.cpp), at most
    [[nodiscard]] double most() const { return dilatations + slant; }
  };
  [[nodiscard]] ThroughBlocks slip_through_blocks(std::size_t f) const;
  [[nodiscard]] bool may_slip(std::size_t f) const;
  [[nodiscard]] Remnant remnant_of(std::size_t f, int p, const Break& broken) const;
  void book_break(std::size_t f, const Break& broken, const Remnant& left, double dt);
  void drop_from_dilatation(std::size_t f, const Break& broken, const Remnant& left);
  void book_fracture();
  void book_sharpening(const std::vector<double>& theta_before);
  void apply(std::size_t f, double point_area, const Pull& pull);

  // Leaning faces: facet_slant.cpp.
  void derive_slants();
  void count_slants();
  void stretch_slanted();
  void pull_slanted();
  [[nodiscard]] Vec3 bonded_jump(std::size_t f, const Motion& motion) const;
  [[nodiscard]] Vec3 line_of_centres(std::size_t f) const;
  [[nodiscard]] Vec3 turned(std::size_t f, const Vec3& start, double scale) const;
  [[nodiscard]] Mat3 slant_moment(std::size_t f, int side) const;
  [[nodiscard]] Mat3 slant_stress(std::size_t b) const;
  [[nodiscard]] double slant_energy(std::size_t b) const;
  [[nodiscard]] Vec3 moment_torque(std::size_t b) const;
  void drop_from_slant(std::size_t f, const Break& broken, const Remnant& left);
  void book_slant();

  // Broken points: facet_contact.cpp.
  [[nodiscard]] bool closes(std::size_t f, const Motion& motion, const Contact& contact, double dt);
  [[nodiscard]] static bool slid_away(const Motion& motion, const Contact& contact);
  void fade(std::size_t f, const Motion& motion, double matching);
  void let_sleep(std::size_t f, double gap, double radius, double dt);
  [[nodiscard]] double contact_energy(std::size_t f, const Motion& motion) const;
  void retire(std::size_t f);
  void add_contact(std::size_t f, const Motion& motion, const Contact& contact, Pull& pull,
                   double dt);
  void rub(std::size_t f, const Motion& motion, const Contact& contact, Pull& pull, double dt);
  [[nodiscard]] static Lanes slip_share(double through, const Contact& contact, const LaneVec& over,
                                        const LaneVec& rate, double dt);

  // Groups of facets that hold at no point: facet_contact_groups.cpp.
  [[nodiscard]] unsigned apart_lanes(const LaneSet& working) const;
  [[nodiscard]] WideContact remembered(std::size_t g, unsigned lanes);
  [[nodiscard]] unsigned closing(std::size_t g, unsigned lanes, const WidePose& pose,
                                 const ContactGroup& memory, double dt);
  void fade_group(std::size_t g, unsigned lanes, const WideParting& parting,
                  const ContactGroup& memory);
  [[nodiscard]] static WideParting parting_of(const FacetGroup& group, const WidePose& pose);
  void touch_group(std::size_t g, unsigned lanes, const WidePose& pose, const WideContact& contact,
                   double dt, WideForces& forces);
  [[nodiscard]] unsigned close_group(std::size_t g, unsigned lanes, const WidePose& pose, double dt,
                                     WideForces& forces);

  // Gas in broken joints: facet_gas.cpp.
  void open_group_of_joints(const LaneSet& set, std::vector<OpenJoint>& open) const;
  using PointLanes = std::array<unsigned, kFacetPoints>;  // bit per facet of a group
  template <class Of>
  [[nodiscard]] PointLanes lanes_with(const LaneSet& set, const Of& of) const;
  [[nodiscard]] bool has_gas() const { return gas_pressure_.size() == blocks_.size(); }
  [[nodiscard]] unsigned pressed_lanes(const LaneSet& active, FacetRow<double>& pressure) const;
  void press_group(const LaneSet& pressed, const FacetRow<double>& pressure, const WidePose& pose);
  void add_gas_forces();

  // Strength, and what broken points still hold: facet_softening.cpp.
  [[nodiscard]] LaneMask failing(std::size_t f, const Pull& pull, const LaneMask& slipping) const;
  [[nodiscard]] bool holds_on(std::size_t f) const;
  void add_cohesion(std::size_t f, const Motion& motion, Pull& pull, double dt);
  [[nodiscard]] double cohesion_energy(std::size_t f, const Motion& motion) const;

  // Pressure: facet_load.cpp.
  void load_faces();
  void look_at_faces_anew();
  double sweep(BoundaryFace& face) const;
  static void keep_swept_volume(BoundaryFace& face, double squeezed_now);
  [[nodiscard]] double squeezed(const BoundaryFace& face) const;
  void list_wall();
  void hold_faces();

  // Yielding supports: quiet_ground.cpp.
  void list_yielding();
  void yield_ground(double dt);
  void yield_block_ground(std::size_t first, std::size_t last, double dt);
  struct GroundPlan;
  [[nodiscard]] GroundPlan plan_ground(std::size_t f, double dt) const;
  void yield_support(std::size_t f, double bulk_stress, double dt);
  void book_ground(std::size_t f, const Vec3& step, const Vec3& traction, double dt);

  std::vector<JointMaterial> materials_;  // per joint class; the rock is the same in all
  std::vector<BlockConstants> blocks_;
  std::vector<BlockState> state_;
  std::vector<BlockSums> sums_;
  double squeezed_ = 0.0;         // sum of A d t_n^2/(4G) of owned blocks [J]
  std::vector<Dropped> dropped_;  // in the order of breaking
  std::vector<double> theta_, bulk_stress_;
  std::vector<Vec3> force_, torque_;
  std::vector<Slant> slants_;         // per facet; these five empty unless one is slanted
  std::vector<Vec3> slant_traction_;  // per facet, to a whole group [Pa]
  std::vector<BlockSlant> block_slants_;
  std::vector<Mat3> gradients_;       // of displacement, per block [-]
  std::vector<Mat3> slant_stresses_;  // per block [Pa]
  std::vector<double> gas_pressure_;  // empty until asked for
  std::vector<Vec3> gas_force_, gas_torque_;
  std::vector<FacetName> facets_;
  std::vector<FacetTraces> traces_;
  ContactRows contacts_;
  RareTable<RareMemory> rare_;
  std::vector<FacetGroup> groups_;           // what the passes over bonded facets read
  std::vector<Strength> strengths_;          // per joint class
  std::vector<FacetState> states_;           // as in traces_, packed
  std::vector<std::uint8_t> bonded_points_;  // how many are in the dilatations
  std::vector<LaneSet> bonded_;              // facets with a bonded point, and some without
  std::vector<LaneSet> active_;              // facets that are not retired, and some that are
  std::vector<LaneSet> working_;  // the active ones that have a block that is not at rest
  std::vector<char> rests_;       // per block
  // Where blocks rest: bonded facets that have a block that does not, and those that have a block
  // that is stirred: it does not rest, or shares a bonded facet with one that does not.
  std::vector<LaneSet> opening_, coupled_;
  std::vector<char> stirred_;  // per block
  std::vector<double> held_;   // per block: `bonded` of the facets not in opening_ [m3]
  bool held_known_ = false;    // held_ and all bulk stresses are those of the blocks at rest
  bool any_rests_ = false;
  std::size_t changed_since_ = 0;  // facets that the lists have wrong
  std::size_t active_count_ = 0;   // facets in active_
  std::vector<std::uint32_t>
      asleep_;               // call of tractions() up to which an open facet is left alone
  std::uint32_t calls_ = 0;  // of tractions(), since the lists were made
  std::vector<std::size_t> yielding_;  // supports whose ground yields, those of a block together
  QuietGround quiet_ground_;
  std::vector<BoundaryFace> faces_;
  std::vector<std::uint32_t> wall_;  // facets of blocks on a crushed zone
  struct Wall {                      // of a block to one crushed zone
    Vec3 sum = Vec3::Zero();         // of A n [m2]
    double rounding = 0.0;           // of the block's sum of A n, along `sum` [m4]
  };
  // These two are empty where there is no wall.
  std::vector<Wall> walls_;  // per face with a hole: that to which it belongs
  std::vector<Vec3> backs_;  // per block: sum of A n of all faces through which no gas passes [m2]
  JointLosses losses_;
  bool pressure_expected_ = true, unloaded_ = false, moved_unseen_ = false;
  bool softer_since_ = false;  ///< than in the last call of load_faces()
  bool softens_ = false, depends_on_rate_ = false, keeps_gas_ = false;
  double damping_ = 0.0, contact_damping_ = 0.0;  // [Pa s/m]
  double shear_over_p_wave_ = 1.0;                // 2G/(lambda + 2G) [-]
  SlipWeakening slip_weakening_;
  double pressure_work_ = 0.0, wave_work_ = 0.0, softened_ = 1.0;
  std::optional<double> damping_given_;
  bool newly_cracked_ = false, newly_let_go_ = false;
};

}  // namespace muckpile
