// SPDX-License-Identifier: GPL-2.0-or-later
// Natural joints as planes: which facets lie in one, and so have its stiffness and strength.
// Scope: facets that the cut has put into the plane; a plane makes no cut itself.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "bond/facet.h"
#include "bond/law/joint_material.h"
#include "geometry/block_model.h"

namespace muckpile {

/// A disc, several discs of one radius, or the whole plane.
struct JointPlane {
  Vec3 point = Vec3::Zero();     ///< on the plane, centre of the disc [m]
  Vec3 normal = Vec3::UnitZ();   ///< of any length but 0
  std::uint8_t joint_class = 1;  ///< see Facet
  double radius = std::numeric_limits<double>::infinity();  ///< [m]
  std::vector<Vec3>
      centres{};  ///< of the discs, all in the plane; none: one disc about `point` [m]
};

/// Upward normal of a plane by its dip and dip direction [rad]: x is east, y is north, z is up; the
/// dip direction is counted from north over east.
[[nodiscard]] Vec3 normal_of_dip(double dip, double dip_direction);

struct NaturalJoints {
  std::vector<JointClass> classes;  ///< from 1 on, as FacetNetwork takes them
  std::vector<JointPlane> planes;
};

/// Gives facets between blocks the class of the first plane that contains them: centroid and normal
/// in the plane to rounding. Tags are first_tag + block number. Returns how many got one.
std::size_t assign_joint_classes(const std::vector<JointPlane>& planes,
                                 const std::vector<Block>& blocks, int first_tag,
                                 std::vector<Facet>& facets);

}  // namespace muckpile
