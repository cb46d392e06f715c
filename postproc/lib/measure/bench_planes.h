// SPDX-License-Identifier: GPL-2.0-or-later
// The planes that a bench is measured between: its free face and those of the rows of holes.
// Scope: both hold the direction of y; the face goes through the toe x = 0, z = 0 and leans back.
#pragma once

#include <algorithm>
#include <limits>

#include "math/types.h"

namespace muckpile {

struct BenchPlanes {
  double face_back = 0.0;  // how far the face runs back per height, cotangent of its angle
  double hole_back = 0.0;  // the same of the holes
  // Of the rock that holes stand in, where the rock goes on beside them [m].
  double y_low = -std::numeric_limits<double>::infinity();
  double y_high = std::numeric_limits<double>::infinity();

  // Level distance behind the face [m]; below the floor the face is upright.
  [[nodiscard]] double behind_face(const Vec3& p) const {
    return -p.x() - face_back * std::max(p.z(), 0.0);
  }
  // Distance behind the toe at which a hole through the point meets the floor's height [m].
  [[nodiscard]] double row_depth(const Vec3& p) const { return -p.x() - hole_back * p.z(); }
  [[nodiscard]] bool abreast(const Vec3& p) const { return p.y() >= y_low && p.y() <= y_high; }
  // Above the floor, behind the face and in front of the row that stands `depth` [m] behind the
  // toe.
  [[nodiscard]] bool in_front_of(double depth, const Vec3& p) const {
    return p.z() > 0.0 && behind_face(p) > 0.0 && row_depth(p) < depth && abreast(p);
  }
};

}  // namespace muckpile
