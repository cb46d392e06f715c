// SPDX-License-Identifier: GPL-2.0-or-later
// Gas of the charges in broken joints: finite volumes on the blocks of a facet network.
// Scope: how much gas is where, how hot it is and what it presses; no engine, no communication. The
// gas of a block is that between it and the middle of each of its broken facets: V = sum of
// A_broken w/2 (w at a support), w = mean opening + what normal stress leaves of the closed joint
// (closed_joint.h), or the mechanical aperture of a joint whose law has one: the volume grows as
// the faces part, with the work that the pressure does on them. The flow has the hydraulic
// aperture. A crack through the edge of a block has two of the three facets there, and those share
// a block: so the gas goes wherever cracks hang together. Two blocks exchange gas through the
// broken facet that they share. Where both have a face on the same crushed zone their facet ends
// there and takes gas from the chamber, and where both have a free face it lets gas out. In both
// cases each block has half the aperture.
// A joint of the cut may stand for several cracks of the rock that share its opening
// (Parameters::crack_spacing): room while closed, walls and ways are those of all of them.
// Behind a mirror stands the block's image, with the same gas: the joint there has opened by twice
// what the block has moved, and has room and ends as one between two blocks.
//
// An ideal gas with mass and energy of its own in every block: p = (gamma - 1) U/V. What flows
// carries its enthalpy; blocks that part cost the gas p dV, p what press() told; what a closed
// joint has between its asperities is room without work, as it breaks and as stress narrows it.
// What faces that touch give way by moves blocks, so it costs p dV, too, but makes no room: rock
// and joint are in series. What such a joint has given way by since it was looked at last is not
// counted where its points break or part, and behind set_rooms() and look_at_all(). Gas and walls
// exchange heat (wall_heat.h).
//
// Calm blocks, whose pressure has hardly changed for a while, are looked at once in several steps
// (Parameters::calm_every): joints between two of them then flow for all that time at once, so that
// mass and energy are kept as before. A joint beside a block that is not calm flows in each step.
//
// A step: the caller fills the contents of owned blocks; measure(), then copies get the numbers of
// their owners, then press(); after the forces flow(), then cool(). It may be as long as several
// steps of the blocks, whose pressures hold meanwhile. Both owners of a facet compute
// the same flow from the same numbers, so mass and energy are kept to rounding.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bond/network/joint_rooms.h"
#include "gas/closed_joint.h"
#include "gas/crack_flow.h"
#include "gas/rock_layers.h"
#include "gas/wall_heat.h"
#include "state/encoding.h"

namespace muckpile {

/// What a block's joints hold; it travels with the block.
struct GasContent {
  double mass = 0.0;     ///< [kg]
  double energy = 0.0;   ///< internal, U = p V/(gamma - 1) [J]
  double heat = 0.0;     ///< that the block's walls have taken from it, net [J]
  double volume = 0.0;   ///< that it had at the last measure() [m3]
  double broken = 0.0;   ///< of that, what its joints have while they are closed [m3]
  double pressed = 0.0;  ///< beyond the atmosphere, by the last press(); work is paid by it [Pa]
  double wall = 0.0;     ///< largest area of its joints' faces so far [m2]
  RockLayers::Excess rock{};  ///< of those faces [K]
};
template <>
struct Stored<GasContent> {
  static constexpr std::string_view kName = "gas_content";
  static constexpr int kVersion = 5;
  static auto fields(auto& gas) {
    return std::tie(gas.mass, gas.energy, gas.heat, gas.volume, gas.broken, gas.pressed, gas.wall,
                    gas.rock);
  }
};

/// Gas that goes from one place to another, with the energy that it carries.
struct GasFlow {
  double mass = 0.0;    ///< [kg]
  double energy = 0.0;  ///< [J]
  GasFlow& operator+=(const GasFlow& more) {
    mass += more.mass;
    energy += more.energy;
    return *this;
  }
};

template <>
struct Stored<GasFlow> {
  static constexpr std::string_view kName = "gas_flow";
  static constexpr int kVersion = 1;
  static auto fields(auto& flow) { return std::tie(flow.mass, flow.energy); }
};

/// What the gas of owned blocks has spent so far.
struct GasSpent {
  double work = 0.0;          ///< p dV, on the blocks and on the atmosphere [J]
  double swept_volume = 0.0;  ///< of that dV: what blocks moved apart by, not all of it room [m3]
  double air_work = 0.0;      ///< of the work what the atmosphere got [J]
  double heat = 0.0;          ///< into the rock, net [J]
};
template <>
struct Stored<GasSpent> {
  static constexpr std::string_view kName = "gas_spent";
  static constexpr int kVersion = 2;
  static auto fields(auto& spent) {
    return std::tie(spent.work, spent.swept_volume, spent.air_work, spent.heat);
  }
};

/// Numbers of a block that its neighbours need.
struct GasCell {
  GasContent content;
  double volume = 0.0;  ///< of its broken joints [m3]
  double ways = 0.0;    ///< conductance of its broken joints and of their ends [m2]
};

/// Gas in a crushed zone.
struct GasChamber {
  GasPoint gas;               ///< pressure 0: nothing flows out or in
  double mass = 0.0;          ///< [kg]
  double enthalpy = 0.0;      ///< that what leaves it carries [J/kg]
  double ways = 0.0;          ///< conductance of the joints that end in it [m2]; of all ranks
  double crushed_rock = 0.0;  ///< that the gas passes on its way into them [m3]
  /// Of its enthalpy, what it holds: a dense gas has less than the 1/gamma of an ideal one [-].
  double energy_share = 0.0;  ///< 0: that of an ideal gas
};

class JointGas {
 public:
  struct Parameters {
    CrackFlow::Parameters flow;
    WallHeat::Parameters heat;
    double open_gas = 1.0;          ///< parting up to which a joint keeps gas (open_wide()) [-]
    double gas_constant = 370.0;    ///< R of the products, p = rho R T [J/(kg K)]
    ClosedJoint::Parameters joint;  ///< where no law of the joint's own knows
    double ambient = 101325.0;      ///< pressure of the atmosphere [Pa]
    /// Between cracks that the rock has where blocks are larger: a joint stands for as many as its
    /// two blocks have of them on their way, at least one [m]; 0: for one.
    double crack_spacing = 0.0;
    int calm_every = 1;  ///< steps, of which calm blocks are looked at in one; 1: in all
  };

  /// InputError on a value out of range.
  explicit JointGas(const Parameters& parameters);

  /// New lists of blocks and facets; every cell is empty after that.
  void set_rooms(const JointRooms& rooms);
  /// In the coming step no block counts as calm, as after set_rooms(): what calm ones have not yet
  /// exchanged they do not exchange. So a run goes on as the one that reads its restart file does.
  void look_at_all();
  /// Code of what each block touches: 2 (hole + 1) + (1 if it has a free face). Right for owned
  /// blocks after set_rooms(); the caller fills in the copies.
  [[nodiscard]] std::span<int> touches() {
    ends_.clear();
    listed_ = false;
    return touches_;
  }
  [[nodiscard]] std::span<GasCell> cells() { return cells_; }
  [[nodiscard]] std::span<const GasCell> cells() const { return cells_; }

  /// Volumes of the owned blocks that gas can reach in this step, as their last step left the
  /// joints; a hole whose `fed` is false lets no gas out.
  void measure(const JointRooms& rooms, const std::vector<char>& fed);
  /// Per hole, what measure() found: the part of GasChamber::ways of owned blocks.
  [[nodiscard]] std::span<const double> chamber_ways() const { return chamber_ways_; }
  /// What the gas of each block presses beyond the atmosphere [Pa]; valid until the next call.
  [[nodiscard]] std::span<const double> press();
  [[nodiscard]] std::span<const double> pressed() const { return gauge_; }  ///< by the last press()
  /// After set_rooms(), of the contents of owned blocks: pressed() is what they pressed before;
  /// the caller fills in the copies.
  [[nodiscard]] std::span<double> press_as_before();

  struct Flows {
    std::vector<GasFlow> from_hole;   ///< what owned blocks took from each chamber, net
    std::vector<double> out_of_hole;  ///< of that the mass that left it [kg]
    GasFlow vented;                   ///< what they let into the atmosphere
  };
  /// Contents have changed since press(), here or on another rank.
  void refresh();
  /// For a time dt [s]. Each way out of a block or chamber has a share of its volume, in proportion
  /// to its conductance, and no flow is larger than what would make the two shares at a way equal:
  /// pressures never cross, none is emptied.
  [[nodiscard]] Flows flow(std::span<const GasChamber> chambers, double dt);
  /// Gas and walls exchange heat for a time dt [s], through the film of the flows since the last
  /// cool().
  void cool(double dt);
  /// A joint that has parted by its radius is more void than joint. It goes on as the void between
  /// its two blocks, until press() found no more than the pressure of the atmosphere in both, or it
  /// has parted by `open_gas` radii: then it loses what it holds and holds nothing from now on; the
  /// caller tells their owner of it.
  struct Opened {
    std::vector<std::uint32_t> joints;
    GasFlow vented;         ///< what owned blocks let into the atmosphere so
    double could_do = 0.0;  ///< work of that gas if it pushed on until it has ambient pressure [J]
  };
  [[nodiscard]] Opened open_wide();

  /// cp of the products [J/(kg K)].
  [[nodiscard]] double heat_capacity() const { return flow_.gamma() * cv(); }
  [[nodiscard]] double pressure(const GasCell& cell) const;  ///< absolute; 0 if empty [Pa]
  /// Net work of a volume [m3] of gas at a pressure [Pa] that expands along its isentrope to that
  /// of the atmosphere, and pushes that away [J].
  [[nodiscard]] double work_to_ambient(double pressure, double volume) const;
  [[nodiscard]] GasFlow contained() const;  ///< in owned blocks
  [[nodiscard]] const GasSpent& spent() const { return spent_; }
  /// To go on from a restart file.
  void resume(const GasSpent& spent) { spent_ = spent; }
  [[nodiscard]] double greatest_pressure() const;  ///< of owned blocks [Pa]
  [[nodiscard]] double blocks_with_gas() const;    ///< owned ones

 private:
  struct End {  // of a facet; the same until the next set_rooms()
    std::uint32_t i, j;
    int hole;  // that it ends in, -1: none
    bool joint;
    bool mirror;    // between a block and its image, which holds the same gas
    bool surfaces;  // ends on a free face
  };
  enum class Keeps : std::uint8_t { unknown, gas, nothing };  // of a broken facet
  struct Crack : End {                                        // a broken facet that gas can reach
    std::uint32_t facet;
    // A joint's room belongs to two blocks; that at a mirror to the block and its image.
    [[nodiscard]] double half() const { return joint || mirror ? 0.5 : 1.0; }
  };
  struct alignas(64) Rooms {  // of a block: sums over its cracks
    double volume;            // [m3]
    double broken;            // of that, while they are closed [m3]
    double walls;             // broken area [m2]
    double ways;              // conductance [m2]
    double gives;  // what closed joints have given way by since the last expand(); read of owned
                   // blocks [m3]
  };
  struct Change {  // of a block, by a flow
    GasFlow flow;
    double film;  // mass flow times film and wall since the last cool() [J/K]
  };
  struct alignas(64) Reservoir {  // gas of a block or a chamber, for the flow
    GasHead head;
    double outflow;   // per volume, that brings its pressure down to nothing [kg/m3]
    double room;      // volume for a way of that conductance [m]
    double enthalpy;  // [J/kg]
  };

  [[nodiscard]] bool owned(std::size_t b) const { return owned_[b] != 0; }
  [[nodiscard]] bool left_out(std::size_t b) const { return left_out_[b] != 0; }
  void find_calm(const std::vector<char>& fed);
  [[nodiscard]] double cracks_of(const JointRooms& rooms, std::size_t f) const;
  [[nodiscard]] End end_of(const JointRooms& rooms, std::size_t f) const;
  [[nodiscard]] bool list_holds(const JointRooms& rooms, const std::vector<char>& fed);
  void find_ends(const JointRooms& rooms);
  void note_broken(const JointRooms& rooms);
  void mark_reached();
  void list_cracks(const JointRooms& rooms);
  void find_pressures();
  void measure_cracks(const JointRooms& rooms, std::span<const LaneSet> facets, std::size_t first);
  void find_apertures();
  void close_joints();
  void note_gives();
  void note_wide();
  void find_passages();
  void count_crack(std::size_t k);
  void clear_rooms();
  void take_rooms();
  struct Paid {
    double work;    // [J]
    double on_air;  // of it, on the atmosphere [J]
  };
  [[nodiscard]] Paid paid(const GasContent& gas, double moved) const;
  [[nodiscard]] double way_of(std::size_t c) const { return area_[c] * passage_[c]; }
  /// Of a crack that ends, where each block has half the aperture.
  [[nodiscard]] double end_of(std::size_t c) const { return 0.5 * way_of(c); }
  void expand();
  template <class Act>
  void each_block(const Crack& crack, const Act& act) const {
    act(std::size_t{crack.i});
    if (crack.joint) act(std::size_t{crack.j});
  }
  /// What would have to flow through a way of conductance 1 for the pressure of both its shares to
  /// be the same [kg/m2]: m carries gamma m p/((gamma - 1) rho) from one to the other.
  [[nodiscard]] static double equalising_mass(const Reservoir& donor, double donor_room,
                                              const GasHead& taker, double taker_room) {
    return donor.outflow * std::max(0.0, 1.0 - taker.pressure * donor.head.inverse_pressure) *
           donor_room * taker_room / (donor_room + taker_room);
  }
  void exchange(std::size_t c, double dt);
  void exchange_all(double dt);
  [[nodiscard]] Reservoir inlet_of(const GasChamber& chamber) const;
  [[nodiscard]] GasFlow feed(std::size_t b, std::size_t c, const Reservoir& inlet, double dt);
  [[nodiscard]] GasFlow vent(std::size_t b, std::size_t c, double dt);
  GasFlow move(std::size_t b, double mass, double enthalpy) {
    const GasFlow flow{mass, mass * enthalpy};
    changes_[b].flow += flow;
    return flow;
  }
  /// A mass that has gone through part of a crack makes a film on the walls of block b.
  void note_film(std::size_t b, std::size_t c, double mass) { changes_[b].film += film_[c] * mass; }
  [[nodiscard]] const RockLayers::Step& cooling_step(double dt);
  void cool_block(std::size_t b, double dt);
  [[nodiscard]] double cv() const { return p_.gas_constant / (flow_.gamma() - 1.0); }

  Parameters p_;
  ClosedJoint joint_;
  CrackFlow flow_;
  WallHeat heat_;
  RockLayers rock_;
  std::array<RockLayers::Step, 2> cooling_steps_;  // of the lengths used last
  std::size_t last_cooling_ = 0;
  GasHead outside_;  // of the atmosphere, but for its density
  std::vector<int> touches_;
  std::vector<GasCell> cells_;
  std::vector<char> owned_;

  // What cracks_ was listed from; it stays right while none of these changes.
  std::size_t intact_ = 0;  // facets
  std::vector<char> fed_, holds_, left_out_;
  bool listed_ = false;

  // Calm blocks, by what they pressed when all were looked at last [Pa], the atmosphere at least.
  std::vector<char> calm_;
  std::vector<double> seen_;
  int step_ = 0;        // of calm_every; in the last one all blocks are looked at
  double clock_ = 0.0;  // of the flow [s]
  // Per facet: since when it is left out, on that clock [s], or kFlows. Per block: time that its
  // cooling is behind [s].
  static constexpr double kFlows = -1.0;
  std::vector<double> left_out_since_, owed_cooling_;
  std::vector<double> ways_now_;  // per block left out: of those of its joints that flow [m2]

  std::vector<End> ends_;        // per facet
  std::vector<double> bundles_;  // per facet: cracks that it stands for until it is a void [-]
  std::vector<Keeps> keeps_;     // per facet
  std::vector<std::uint32_t> open_to_gas_;  // broken facets that keep gas
  std::vector<char> reached_;               // per block: gas is in it or beside it
  std::vector<Crack> cracks_;               // those of them that gas can reach
  std::vector<LaneSet> crack_facets_;       // of cracks_
  // Some of cracks_ that are measured together, so that they stay in the near caches: how many
  // each stands for [-]; broken area of all [m2], apertures of one while closed, mechanical and
  // hydraulic [m], what its faces gave way by since it was seen last [m3].
  struct Batch {
    std::size_t first = 0, count = 0;
    OpenJoints open;
    std::vector<double> many, wall, closed, mechanical, aperture, gives;
    void resize(std::size_t cracks);
  };
  Batch batch_;
  // Of cracks_: area across the flow of all that each stands for [m2], passage [-], film x wall per
  // mass flow through them [J/(kg K)], time that it was left out for [s].
  std::vector<double> area_, passage_, film_, owed_;
  struct Void {
    std::uint32_t crack;
    bool gone;              // parted by open_gas
    double volume, broken;  // for each of its blocks; of that, while it is closed [m3]
  };
  std::vector<std::uint32_t> ending_;  // of cracks_: in a hole or at a surface
  std::vector<Void> wide_;             // of cracks_: parted by their radius
  std::vector<Change> changes_;        // per block
  std::vector<Rooms> rooms_;           // per block
  std::vector<double> chamber_ways_;
  // Per facet, as it was seen last: how far its sides are apart less its opening, over the broken
  // area [m3], of which only differences count; which points those are (OpenJoints::points),
  // kUnseen: it was not seen.
  static constexpr std::uint8_t kUnseen = 0xff;
  std::vector<double> seen_gives_;
  std::vector<std::uint8_t> seen_points_;
  GasSpent spent_;
  // Per block, as refresh() found them.
  std::vector<double> density_, pressure_, root_;
  std::vector<double> gauge_;  // per block: beyond the atmosphere, as press() told it [Pa]
  std::vector<Reservoir> reservoirs_;
};

}  // namespace muckpile
