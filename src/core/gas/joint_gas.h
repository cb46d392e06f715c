// SPDX-License-Identifier: GPL-2.0-or-later
// Gas of the charges in broken joints: finite volumes on the blocks of a facet network.
// Scope: how much gas is where and what it presses; no engine, no communication. The gas of a block
// is that between it and the middle of each of its broken facets: V = sum of A_broken w/2 (w at a
// support), w = residual aperture + mean opening, or the mechanical aperture of a joint whose law
// has one: the volume grows as the faces part, with the work that the pressure does on them. The
// flow has the same w, or that law's hydraulic aperture. A crack through the edge of a block has
// two of the three facets there, and those share a block: so the gas goes wherever cracks hang
// together. Two blocks exchange gas through the broken facet that they share. Where both have a
// face on the same crushed zone their facet ends there and takes gas from the chamber, and where
// both have a free face it lets gas out. In both cases each block has half the aperture.
//
// A step: the caller fills the contents of owned blocks; measure(), then copies get the numbers of
// their owners, then press(); after the forces flow(). Both owners of a facet compute the same flow
// from the same numbers, so mass is kept to rounding.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bond/network/facet_network.h"
#include "gas/crack_flow.h"
#include "state/encoding.h"

namespace muckpile {

/// What a block's joints hold; it travels with the block.
struct GasContent {
  double mass = 0.0;     ///< [kg]
  double entropy = 0.0;  ///< sum of mass x K of what came in, p = K rho^gamma
};
template <>
struct Stored<GasContent> {
  static constexpr std::string_view kName = "gas_content";
  static constexpr int kVersion = 1;
  static auto fields(auto& gas) { return std::tie(gas.mass, gas.entropy); }
};

/// Numbers of a block that its neighbours need.
struct GasCell {
  GasContent content;
  double volume = 0.0;  ///< of its broken joints [m3]
  double ways = 0.0;    ///< conductance of its broken joints and of their ends [m2]
};

/// Gas in a crushed zone.
struct GasChamber {
  GasPoint gas;       ///< pressure 0: nothing flows out or in
  double mass = 0.0;  ///< [kg]
  double ways = 0.0;  ///< conductance of the joints that end in it [m2]; of all ranks
};

class JointGas {
 public:
  struct Parameters {
    CrackFlow::Parameters flow;
    double residual_aperture = 1e-4;  ///< of a closed joint [m]
    double ambient = 101325.0;        ///< pressure of the atmosphere [Pa]
  };

  /// InputError on a value out of range.
  explicit JointGas(const Parameters& parameters);

  /// New lists of blocks and facets; every cell is empty after that.
  void set_network(const FacetNetwork& network);
  /// Code of what each block touches: 2 (hole + 1) + (1 if it has a free face). Right for owned
  /// blocks after set_network(); the caller fills in the copies.
  [[nodiscard]] std::span<int> touches() {
    ends_.clear();
    listed_ = false;
    return touches_;
  }
  [[nodiscard]] std::span<GasCell> cells() { return cells_; }
  [[nodiscard]] std::span<const GasCell> cells() const { return cells_; }

  /// Volumes of the owned blocks that gas can reach in this step, in the pose of the network; a
  /// hole whose `fed` is false lets no gas out.
  void measure(const FacetNetwork& network, const std::vector<char>& fed);
  /// Per hole, what measure() found: the part of GasChamber::ways of owned blocks.
  [[nodiscard]] std::span<const double> chamber_ways() const { return chamber_ways_; }
  /// What the gas of each block presses beyond the atmosphere [Pa]; valid until the next call.
  [[nodiscard]] std::span<const double> press();

  struct Flows {
    std::vector<double> from_hole;  ///< what owned blocks took from each chamber [kg]
    double vented = 0.0;            ///< what they let into the atmosphere [kg]
  };
  /// Contents have changed since press(), here or on another rank.
  void refresh();
  /// For a time dt [s]. Each way out of a block or chamber has a share of its volume, in proportion
  /// to its conductance, and no flow is larger than what would make the two shares at a way equal:
  /// pressures never cross, none is emptied.
  [[nodiscard]] Flows flow(std::span<const GasChamber> chambers, double dt);
  /// Joints that measure() found wide lose what they hold and hold nothing from now on; the caller
  /// tells the network of them.
  struct Opened {
    std::vector<std::uint32_t> joints;
    double vented = 0.0;  ///< what owned blocks let into the atmosphere so [kg]
  };
  [[nodiscard]] Opened open_wide();

  [[nodiscard]] double pressure(const GasCell& cell) const;  ///< absolute; 0 if empty [Pa]
  [[nodiscard]] double mass() const;                         ///< in owned blocks [kg]
  [[nodiscard]] double greatest_pressure() const;            ///< of owned blocks [Pa]
  [[nodiscard]] double blocks_with_gas() const;              ///< owned ones

 private:
  struct End {  // of a facet; the same until the network changes
    std::uint32_t i, j;
    int hole;  // that it ends in, -1: none
    bool joint;
    bool surfaces;  // ends on a free face
  };
  enum class Keeps : std::uint8_t { unknown, gas, nothing };  // of a broken facet
  struct Crack : End {                                        // a broken facet that gas can reach
    std::uint32_t facet;
    double broken;                                          // area of its broken points [m2]
    double volume;                                          // for each of its blocks [m3]
    double area;                                            // across the flow [m2]
    double way;                                             // conductance: area x passage [m2]
    [[nodiscard]] double end() const { return 0.5 * way; }  // each block has half the aperture
  };
  struct alignas(64) Reservoir {  // gas of a block or a chamber, for the flow
    GasHead head;
    double density;           // [kg/m3]
    double room;              // volume for a way of that conductance [m]
    double entropy_per_mass;  // K
  };
  struct Change {
    double mass = 0.0, entropy = 0.0;
  };

  [[nodiscard]] bool owned(std::size_t b) const { return owned_[b] != 0; }
  [[nodiscard]] End end_of(const FacetNetwork& network, std::size_t f) const;
  [[nodiscard]] bool list_holds(const FacetNetwork& network, const std::vector<char>& fed);
  void mark_reached(const FacetNetwork& network);
  void list_cracks(const FacetNetwork& network);
  void find_pressures();
  void measure_crack(std::size_t c, const OpenJoint& open);
  void count_crack(const Crack& crack);
  template <class Act>
  void each_block(const Crack& crack, const Act& act) const {
    act(std::size_t{crack.i});
    if (crack.joint) act(std::size_t{crack.j});
  }
  /// What would have to flow through a way of conductance 1 for the pressure of both its shares to
  /// be the same [kg/m2].
  [[nodiscard]] static double equalising_mass(double density, double room, double thinning,
                                              double other_room) {
    return density * std::max(0.0, 1.0 - thinning) * room * other_room / (room + other_room);
  }
  void exchange(std::size_t c, double dt);
  [[nodiscard]] Reservoir inlet_of(const GasChamber& chamber) const;
  [[nodiscard]] double feed(std::size_t b, std::size_t c, const Reservoir& inlet, double dt);
  [[nodiscard]] double vent(std::size_t b, std::size_t c, double dt);
  void move(std::size_t b, double mass, double entropy_per_mass) {
    changes_[b].mass += mass;
    changes_[b].entropy += mass * entropy_per_mass;
  }

  Parameters p_;
  CrackFlow flow_;
  GasHead outside_;  // of the atmosphere, but for its density
  std::vector<int> touches_;
  std::vector<GasCell> cells_;
  std::vector<char> owned_;

  // What cracks_ was listed from; it stays right while none of these changes.
  std::size_t intact_ = 0;  // facets
  std::vector<char> fed_, holds_;
  bool listed_ = false;

  std::vector<End> ends_;                           // per facet
  std::vector<Keeps> keeps_;                        // per facet
  std::vector<std::uint32_t> open_to_gas_;          // broken facets
  std::vector<char> reached_;                       // per block: gas is in it or beside it
  std::vector<Crack> cracks_;                       // those of them that gas can reach
  std::vector<LaneSet> crack_facets_;               // of cracks_
  std::vector<OpenJoint> openings_;                 // of cracks_
  std::vector<double> aperture_, width_, passage_;  // of cracks_, for the flow [m], [m], [-]
  std::vector<std::uint32_t> ending_, wide_;        // of cracks_: in a hole or at a surface; wide
  std::vector<Change> changes_;
  std::vector<double> chamber_ways_;
  // Per block, as refresh() found them.
  std::vector<double> density_, entropy_per_mass_, pressure_, root_;
  std::vector<double> gauge_;  // per block: beyond the atmosphere, as press() told it [Pa]
  std::vector<Reservoir> reservoirs_;
};

}  // namespace muckpile
