// SPDX-License-Identifier: GPL-2.0-or-later
// Names for the small vectors and matrices that all of Muckpile uses.
// Scope: aliases only; coordinates are Cartesian, z up, SI units.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace muckpile {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

}  // namespace muckpile
