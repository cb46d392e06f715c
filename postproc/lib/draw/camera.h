// SPDX-License-Identifier: GPL-2.0-or-later
// A perspective or parallel view of space: from points to pixels and back.
// Scope: z up in the world, y down in the picture.
#pragma once

#include "math/types.h"
#include "measure/scan_polygon.h"

namespace muckpile {

// `depth` is the distance along the view axis [m]. `nearness` grows towards the eye and is linear
// over the picture of a plane, which is what a depth buffer needs: 1/depth in perspective, -depth
// in a parallel view.
class Camera {
 public:
  // Perspective. `opening` is the vertical angle of view [rad]; the picture has width x height
  // samples.
  static Camera perspective(const Vec3& eye, const Vec3& target, double opening, int width,
                            int height);
  // Parallel, seen along `direction`, showing the sphere about `target` of this radius [m] in size
  // x size samples.
  static Camera parallel(const Vec3& direction, const Vec3& target, double radius, int size);

  [[nodiscard]] bool sees(const Vec3& p) const { return !perspective_ || depth(p) > kNear; }
  // The part of a convex polygon in front of the eye; all of it in a parallel view.
  [[nodiscard]] std::vector<Vec3> clipped(const std::vector<Vec3>& polygon) const;
  [[nodiscard]] double depth(const Vec3& p) const { return forward_.dot(p - eye_); }
  [[nodiscard]] Vec2 place(const Vec3& p) const;  // [samples]
  [[nodiscard]] double nearness(const Vec3& p) const {
    return perspective_ ? 1.0 / depth(p) : -depth(p);
  }
  // The point of space seen at a place of the picture with a nearness.
  [[nodiscard]] Vec3 point(const Vec2& place, double nearness) const;

  // Nearness over the picture of the plane through `p` with this normal is a + b x + c y; (a, b,
  // c).
  [[nodiscard]] Vec3 nearness_of_plane(const Vec3& p, const Vec3& normal) const;
  [[nodiscard]] bool faces_eye(const Vec3& p, const Vec3& normal) const {
    return (perspective_ ? normal.dot(eye_ - p) : -normal.dot(forward_)) > 0.0;
  }
  // Samples that one metre covers at this depth.
  [[nodiscard]] double samples_per_metre(double at_depth) const {
    return perspective_ ? scale_ / at_depth : scale_;
  }

 private:
  static constexpr double kNear = 0.01;  // [m]
  Vec3 eye_, forward_, right_, up_;
  double scale_ = 1.0;  // perspective: focal length [samples]; parallel: samples per metre
  Vec2 middle_;
  bool perspective_ = true;
};

}  // namespace muckpile
