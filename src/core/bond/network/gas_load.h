// SPDX-License-Identifier: GPL-2.0-or-later
// The pressure of gas in the broken joints of a facet network: what it presses, and how far the
// joints are open for it.
// Scope: a part of the network that exists only where joints keep gas (FacetTraces::gas); how much
// gas is where is gas/joint_gas.h. One row per block, the ground last; SI units. The gas does not
// enter the dilatations, as the contact of broken points does not.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bond/network/facet_kinematics.h"
#include "bond/network/facet_wide.h"
#include "bond/network/joint_points.h"

namespace muckpile {

/// How far a joint is open for gas: one at a mirror as that between its block and the image.
struct OpenJoint {
  double area = 0.0;     ///< of broken points [m2]
  double opening = 0.0;  ///< mean over them [m]
  double apart = 0.0;    ///< mean over them of how far the two sides are apart, below 0 too [m]
  unsigned points = 0;   ///< bit per point: broken ones, then those of them outside the dilatations
  /// Mean over them of what presses the faces onto each other, by the closed facet's own normal
  /// stiffness, that of uniaxial strain; where no law knows the apertures [Pa].
  double pressure = 0.0;
  /// Means over them, where the joint has a law that knows them; no law is at a mirror.
  std::optional<BrokenApertures> by_law;
  /// Square of how far it has opened or slid, in radii, or turned, in rad, whichever is more [-].
  double parted_squared = 0.0;
};

/// Of each of `facets`, in order, into `open`.
void open_joints(const FacetKinematics& all, std::span<const LaneSet> facets,
                 std::vector<OpenJoint>& open);

class GasLoad {
 public:
  /// More than the atmosphere, of every block [Pa]; it acts until it is set again.
  void set_pressure(std::span<const double> pressure);
  /// Blocks have changed: nothing presses, and no force of the former ones is left, until pressures
  /// are set.
  void clear_pressure() {
    pressure_.clear();
    force_.clear();
    torque_.clear();
  }
  [[nodiscard]] bool presses() const { return !pressure_.empty(); }
  /// In the joints between blocks i and j [Pa]: the mean of the two; on the ground what i has.
  [[nodiscard]] double between(std::size_t i, std::size_t j) const {
    if (!presses()) return 0.0;
    return 0.5 * (pressure_[i] + (j + 1 == pressure_.size() ? pressure_[i] : pressure_[j]));
  }

  [[nodiscard]] std::span<const Vec3> force() const { return force_; }    ///< [N]
  [[nodiscard]] std::span<const Vec3> torque() const { return torque_; }  ///< [N m]

  void clear_forces();
  /// Those of a group's active facets in which gas presses, and how hard [Pa]: a joint has the mean
  /// of its two blocks, a facet of the ground what its block has.
  [[nodiscard]] unsigned pressed_lanes(const FacetKinematics& facets, const LaneSet& active,
                                       FacetRow<double>& pressure) const;
  /// The gas pushes the two sides of each facet apart at its broken points.
  void press(const FacetKinematics& facets, const LaneSet& pressed,
             const FacetRow<double>& pressure, const WidePose& pose);
  void add_forces_to(BlockFields& blocks) const;

  [[nodiscard]] double bytes() const {
    return static_cast<double>(pressure_.capacity() * sizeof(double) +
                               (force_.capacity() + torque_.capacity()) * sizeof(Vec3));
  }

 private:
  std::vector<double> pressure_;
  std::vector<Vec3> force_, torque_;
};

}  // namespace muckpile
