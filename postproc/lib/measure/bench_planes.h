// SPDX-License-Identifier: GPL-2.0-or-later
// What a bench is measured between: its free face and the planes of the rows of holes.
// Scope: planes hold the direction of y; that of a face goes through the toe x = 0, z = 0 and leans
// back. A face that is no plane is a map of where the rock begins. Holes that throw to several
// sides have a frame each, which then says all but `face`.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>

#include "math/types.h"
#include "measure/face_map.h"
#include "measure/hole_frames.h"

namespace muckpile {

struct BenchPlanes {
  double face_back = 0.0;  // how far the face runs back per height, cotangent of its angle
  double hole_back = 0.0;  // the same of the holes
  // Of the rock that holes stand in, where the rock goes on beside them [m].
  double y_low = -std::numeric_limits<double>::infinity();
  double y_high = std::numeric_limits<double>::infinity();
  double spacing = std::numeric_limits<double>::infinity();  // of the holes, where it is known [m]
  std::shared_ptr<const FaceMap> face{};  // of a face that is no plane, else none
  std::shared_ptr<const HoleFrames> frames{};

  // Level distance behind the face [m]; below the floor the face is upright. Behind a face that is
  // no plane, rock may stand a little in front of the line that its place is told by.
  [[nodiscard]] double behind_face(const Vec3& p) const {
    if (frames != nullptr) return frames->behind_face(p);
    if (face != nullptr) return std::max(0.0, face->x(p.y(), p.z()) - p.x());
    return -p.x() - face_back * std::max(p.z(), 0.0);
  }
  // Before the blast all rock is behind a face that was found from it.
  [[nodiscard]] bool is_behind_face(const Vec3& p) const {
    return face != nullptr || frames != nullptr || behind_face(p) > 0.0;
  }
  // Where the face meets the floor, x [m].
  [[nodiscard]] double toe(double y) const { return face != nullptr ? face->toe(y) : 0.0; }
  // Distance behind the toe at which a hole through the point meets the floor's height [m].
  [[nodiscard]] double row_depth(const Vec3& p) const {
    return frames != nullptr ? frames->row_depth(p) : -p.x() - hole_back * p.z();
  }
  [[nodiscard]] bool abreast(const Vec3& p) const {
    return frames != nullptr ? frames->abreast(p) : p.y() >= y_low && p.y() <= y_high;
  }
  // To where rock is thrown that started there.
  [[nodiscard]] Vec3 outward(const Vec3& start) const {
    return frames != nullptr ? frames->outward(start) : Vec3::UnitX();
  }
  [[nodiscard]] bool beyond_toe(const Vec3& start, const Vec3& end) const {
    return frames != nullptr ? frames->beyond_toe(start, end) : end.x() > toe(end.y());
  }
  // Above the floor, behind the face and in front of the row that stands `depth` [m] behind the
  // toe.
  [[nodiscard]] bool in_front_of(double depth, const Vec3& p) const {
    return p.z() > 0.0 && is_behind_face(p) && row_depth(p) < depth && abreast(p);
  }
};

}  // namespace muckpile
