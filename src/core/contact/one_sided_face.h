// SPDX-License-Identifier: GPL-2.0-or-later
// A sphere whose centre has come behind the face of a solid: by how much, and what a contact law
// that pushes centres away from a face must be shown, so that it pushes this one back out.
// Scope: one sphere; faces come from the engine.
#pragma once

#include "math/types.h"

namespace muckpile {

struct Ball {
  Vec3 centre;
  double radius = 0.0;  // [m]
};

/// Of several faces the nearest is the way out: at a corner a centre lies behind both.
class WayOut {
 public:
  /// `depth` of the centre behind a face [m], > 0; `normal` points out of the solid.
  void consider(double depth, const Vec3& normal) {
    if (known_ && depth >= depth_) return;
    known_ = true;
    depth_ = depth;
    normal_ = normal;
  }
  [[nodiscard]] bool known() const { return known_; }

  /// The ball with the same lowest point, and so with the overlap radius + depth, whose centre lies
  /// before the face, by so little that its size hardly differs: it joins on to balls before it.
  [[nodiscard]] Ball before_face(const Ball& ball) const {
    constexpr double kBefore = 0.01;  // of the radius
    const double lift = depth_ + kBefore * ball.radius;
    return {ball.centre + lift * normal_, ball.radius + lift};
  }

 private:
  bool known_ = false;
  double depth_ = 0.0;
  Vec3 normal_ = Vec3::Zero();
};

}  // namespace muckpile
