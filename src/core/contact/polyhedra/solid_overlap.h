// SPDX-License-Identifier: GPL-2.0-or-later
// What two convex solids that overlap do to each other: a pressure field in
// each, integrated over the surface of the other. Scope: unit pressure; exact
// up to rounding, no allocation. Seen from the first solid's centre, in its
// axes.
//
// Each solid carries a strain e that falls from 1 at its centre to 0 on its
// surface, along straight lines: e = min over faces of (1 - n.x / c), c the
// depth of the centre below the face (a pressure field as in Elandt,
// Drumwright, Sherman and Ruina 2019). Energy is the integral of e over the
// shared part, once for the e of either solid; force and moment are its slope:
// minus the integral of e n over the surface that moves. So the contact is
// conservative, whatever touches whatever.
#pragma once

#include <array>
#include <cstddef>

#include "contact/polyhedra/lane_outline.h"
#include "contact/polyhedra/solid_gap.h"

namespace muckpile {

/// For unit pressure: times a modulus they are force, moment, energy,
/// stiffness.
struct SolidOverlap {
  double volume = 0.0;          ///< shared [m3]
  double energy = 0.0;          ///< integral of both strains over it [m3]
  double stiffness = 0.0;       ///< no shift changes the force by more, over its length [m]
  double mean_square = 0.0;     ///< of the distance from `point`, by stiffness [m2]
  double largest_strain = 0.0;  ///< [-]
  Vec3 push = Vec3::Zero();     ///< on the first solid [m2]
  Vec3 moment = Vec3::Zero();   ///< on the first solid about its centre [m3]
  double pressed = 0.0;         ///< integral of the strains over the surface [m2]
  Vec3 point = Vec3::Zero();    ///< centre of pressure [m]
  Mat3 spread = Mat3::Zero();   ///< mean of r r^T over the pressure, r from the centre [m2]
  double arm = 0.0;             ///< root mean square of r [m]
};

/// Surfaces share volume in a slab only: that between the lowest corner of the second solid and the
/// highest of the first along a direction. Only planes with corners in the slab are worked on: the
/// others neither bound what is shared nor, with both centres outside of the slab, have the least
/// strain anywhere in it.
class OverlapFinder {
 public:
  /// Bodies whose strain is nowhere more than this touch, to rounding, and
  /// share nothing [-].
  static constexpr double kTouch = 1e-8;

  /// Puts both where the first sees them. `turn` takes the second's axes to the
  /// first's, `between` [m] the first's centre to the second's in the first's
  /// axes. Both are drawn in to the share `size` of their sizes.
  void place(const Solid& first, const Solid& second, const Mat3& turn, const Vec3& between,
             double size);
  /// Of those placed. Gap [m] between them if it is above 0, along `n` (unit,
  /// from the first to the second); else they overlap as said in overlap(), or
  /// touch without a gap that is found. `n` is first what they are apart or pressed along, about:
  /// the nearer, the less work.
  [[nodiscard]] double work(Vec3& n);
  /// The greatest gap above a plane of either [m], or, if there is none, one that is found from `n`
  /// on; not above 0: none is found.
  [[nodiscard]] double search_gap(Vec3& n);
  [[nodiscard]] const SolidOverlap& overlap() const { return overlap_; }
  [[nodiscard]] const PlacedSolid& first() const { return first_; }
  [[nodiscard]] const PlacedSolid& second() const { return second_; }

  [[nodiscard]] bool touching() const { return overlap_.pressed > 0.0; }

  /// For tests: one corner after the other, also where outlines go through lanes.
  void take_corners_one_by_one() { in_lanes_ = false; }

 private:
  static constexpr std::size_t kRoom = 3 * Solid::kMostPlanes + Solid::kMostCorners;
  struct Outline {
    std::array<Vec3, kRoom> corner;
    std::size_t count = 0;
  };
  /// Of one solid's surface in the other.
  struct Side {
    const PlacedSolid &of, &into;
    const OutsideBits& bits;
    double sign;    ///< of the push of the first solid
    bool strictly;  ///< surface in a plane of both counts for the first solid
                    ///< only
  };
  struct Sums {
    double depth_area = 0.0;   ///< distance of the face from origin_ times area [m3]
    double depth_press = 0.0;  ///< distance of the face from the other's centre
                               ///< times pressure [m3]
  };
  /// How far inside the planes the corners of an outline lie.
  struct Depths {
    alignas(64) std::array<double, Solid::kMostPlanes> least, most;  ///< [m]
  };

  void clear();
  void place_planes_in_slab(const Vec3& n);
  [[nodiscard]] Sums press_faces(const Side& side);
  /// As press_face(); false: nothing done.
  [[nodiscard]] bool press_face_in_lanes(const Side& side, std::size_t plane,
                                         const Solid::Face& face, Sums& sums);
  [[nodiscard]] bool press_parts(const PlacedSolid& into, const LaneOutline& outline,
                                 const OutlineVec& normal, LaneSums& sums);
  [[nodiscard]] std::size_t list_nearest(const PlacedSolid& into, const LaneOutline& outline);
  /// Adds what lane_sums_ has to the sums.
  void sum_lanes();
  void press_face(const Side& side, std::size_t plane, const Solid::Face& face, Sums& sums);
  [[nodiscard]] bool cut_face(const Side& side, const Solid::Face& face);
  [[nodiscard]] bool cut_outline(const Side& side, std::size_t plane);
  void find_depths(const PlacedSolid& into);
  [[nodiscard]] double press_outline(const PlacedSolid& into, const Vec3& normal, double sign);
  [[nodiscard]] std::size_t list_nearest(const PlacedSolid& into);
  [[nodiscard]] const Outline& nearest_part(const PlacedSolid& into, std::size_t own,
                                            std::size_t count);
  [[nodiscard]] double press_part(const Outline& part, const PlacedSolid& into, std::size_t plane,
                                  const Vec3& normal, double sign);
  void press_triangle(const std::array<Vec3, 3>& corners, const std::array<double, 3>& strains,
                      double area, double weight, Vec3& moment);
  void finish();

  PlacedSolid first_, second_;
  Mat3 turn_ = Mat3::Identity();
  AlongDirection along_first_, along_second_;
  OutsideBits bits_first_, bits_second_;
  SolidOverlap overlap_;
  std::array<Outline, 2> faces_;  // what is left of a face, and what it was
  std::size_t outline_ = 0;       // which of them is left
  std::array<Outline, 2> spare_;  // work space of parts
  Depths depths_;
  std::array<double, kRoom> value_;
  std::array<int, Solid::kMostPlanes> nearest_;
  Vec3 pressed_at_ = Vec3::Zero();      // pressure times place [m3]
  Mat3 pressed_square_ = Mat3::Zero();  // pressure times place place^T [m4]
  Vec3 origin_ = Vec3::Zero();  // a point of the shared surface, so that small volumes are exact
  bool has_origin_ = false;
  double weight_ = 0.0,
         weight_square_ = 0.0;  // of stiffness, and times place squared
  Vec3 weight_at_ = Vec3::Zero();
  LaneSums lane_sums_;
  bool in_lanes_ = kLaneOutlines;
};

}  // namespace muckpile
