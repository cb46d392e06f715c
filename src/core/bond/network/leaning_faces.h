// SPDX-License-Identifier: GPL-2.0-or-later
// Leaning faces: the terms of bonded facets where the lines between the centres of blocks do not
// cross the faces at right angles.
// Scope: a part of the network that exists only where a cut with Leaning::much (facet_builder.h)
// has such facets, on this rank or on another. Rows per facet and per block; tensors are of block
// averages, SI units.
//
// The springs 2G/h hold the jump u = F d of a homogeneous gradient F with 2G F d/h, which is the
// continuum's 2G F m only where the line of centres d has the direction of m. A block's own share
// of the energy that is exact for every F is that of its gradient and of what departs from it,
//   G V F:F + sum of A (G/2h) |u - F d|^2,   F = sum of A u (x) m/2 / V,
// never negative, and F exact as m makes it. With d/h = m + g that is the springs' energy plus
//   G V (F:F Q - 2 F:E),   E = sum of A u (x) g/2 / V,   Q = sym sum of A d (x) g/2 / V:
// nothing at all where g = 0. So t gets [T_i m_i - 2G F_i g_i + T_j m_j - 2G F_j g_j]/2 with
// T = 2G (F Q - E) of each block. In a homogeneous strain the whole traction is then the
// continuum's times the mean of m_i and m_j, which facet_openings.cpp makes n. Of a compliant joint
// only the part of u that strains rock counts, so that the energy stays above 0. m and g turn with
// the mean of the two blocks, Q with its block. Kin: the stabilised correspondence models of
// peridynamics (Silling 2017).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bond/network/facet_kinematics.h"
#include "bond/network/joint_books.h"

namespace muckpile {

/// How a facet leans.
struct FacetLean {
  std::array<Vec3, 2> lean{Vec3::Zero(), Vec3::Zero()};  ///< g of both blocks, in the start [-]
  /// Of the jump that strains rock over that along the normal; 0 for a mirror [-].
  double shear_share = 1.0;
};

class LeaningFaces {
 public:
  /// Whether a facet of this rank leans.
  [[nodiscard]] static bool exist_in(const FacetTables& tables);

  /// Room for the gradients and stresses of so many blocks, where facets of other ranks lean.
  void reset_blocks(std::size_t blocks);
  /// Facets are placed and derived; none of them need lean.
  void set(const FacetTables& tables, std::size_t blocks);
  /// Moments of all blocks from the bonded points of their facets.
  void count_moments(const FacetTables& tables, const FacetHistory& history,
                     const BlockFields& blocks);
  /// A facet of this rank leans.
  [[nodiscard]] bool any() const { return !facets_.empty(); }

  [[nodiscard]] const FacetLean& facet(std::size_t f) const { return facets_[f]; }
  /// Of the whole facet, by the last pull() [Pa].
  [[nodiscard]] const Vec3& traction(std::size_t f) const { return tractions_[f]; }
  /// Nine numbers of each of the first `blocks` blocks, displacement gradients [-] and stresses T
  /// [Pa]; right for owned blocks after stretch(), to be filled in for copies.
  [[nodiscard]] std::span<double> gradients(std::size_t blocks);
  [[nodiscard]] std::span<double> stresses(std::size_t blocks);
  /// Q of a block that has turned by `rotation` [-].
  [[nodiscard]] Mat3 moment(std::size_t b, const Mat3& rotation) const {
    return rotation * blocks_[b].moment * rotation.transpose();
  }

  /// Gradients of all blocks, and the stresses of those that are owned.
  void stretch(const FacetKinematics& facets, const std::vector<LaneSet>& bonded);
  /// Tractions of leaning facets, and what turns blocks beside them.
  void pull(const FacetKinematics& facets, const std::vector<LaneSet>& working,
            std::vector<Vec3>& torque);
  /// Of a block [J].
  [[nodiscard]] double energy(std::size_t b, const BlockFields& blocks) const;

  /// Point of a facet that breaks: what its blocks lose.
  struct LostPoint {
    Vec3 lost;   ///< jump that leaves the dilatations [m]
    bool slips;  ///< stays in the dilatations
  };
  void drop(const FacetKinematics& facets, std::size_t f, const LostPoint& point);
  /// Takes out what broke in this step and books what the energy loses by it; what blocks of other
  /// ranks lose is booked there.
  void book(const BlockFields& blocks, JointLosses& losses);

  [[nodiscard]] double bytes() const;

 private:
  struct BlockLean {  // sums over the bonded facets of a block that leans, over its volume
    Mat3 excess = Mat3::Zero();  // E [-]
    Mat3 moment = Mat3::Zero();  // Q, in the start [-]
  };
  struct LostLean {  // by breaking in this step
    Mat3 gradient = Mat3::Zero(), excess = Mat3::Zero(), moment = Mat3::Zero();
  };

  [[nodiscard]] Mat3 point_moment(const FacetTables& tables, std::size_t f, int side) const;
  [[nodiscard]] Mat3 stress(std::size_t b, const BlockFields& blocks) const;
  [[nodiscard]] Vec3 moment_torque(std::size_t b, const Mat3& rotation, double volume,
                                   double shear_modulus) const;

  std::vector<FacetLean> facets_;  // empty where no facet of this rank leans
  std::vector<Vec3> tractions_;    // per facet, to a whole group
  std::vector<BlockLean> blocks_;
  std::vector<LostLean> lost_;              // per block
  std::vector<Mat3> gradients_, stresses_;  // per block
};

}  // namespace muckpile
