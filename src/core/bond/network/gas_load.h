// SPDX-License-Identifier: GPL-2.0-or-later
// The pressure of gas in the broken joints of a facet network: what it presses, and how far the
// joints are open for it.
// Scope: a part of the network that exists only where joints keep gas (FacetTraces::gas); how much
// gas is where is gas/joint_gas.h. One row per block, the ground last; SI units. The gas does not
// enter the dilatations, as the contact of broken points does not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bond/network/facet_kinematics.h"
#include "bond/network/facet_wide.h"
#include "bond/network/joint_points.h"

namespace muckpile {

/// How far joints are open for gas, one after the other: one at a mirror as that between its block
/// and the image. Means are over the broken points of a joint.
struct OpenJoints {
  std::vector<double> area;     ///< of broken points [m2]
  std::vector<double> opening;  ///< mean [m]
  std::vector<double> apart;  ///< mean parting of the two sides since the start, with its sign [m]
  /// Mean of what presses the faces onto each other, by the closed facet's own normal stiffness,
  /// that of uniaxial strain; where no law knows the apertures [Pa].
  std::vector<double> pressure;
  /// Square of how far it has opened or slid, in radii, or turned, in rad, whichever is more [-].
  std::vector<double> parted_squared;
  std::vector<std::uint8_t> points;  ///< bit per point: broken ones, then those out of dilatations
  struct ByLaw {
    std::size_t joint;  ///< its place
    BrokenApertures apertures;
  };
  std::vector<ByLaw> by_law;  ///< of joints whose law knows them, means; no law is at a mirror

  void resize(std::size_t joints);
};

/// Of each of `facets`, in order, into `open`.
void open_joints(const FacetKinematics& all, std::span<const LaneSet> facets, OpenJoints& open);

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
