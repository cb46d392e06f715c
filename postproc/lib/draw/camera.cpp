// SPDX-License-Identifier: GPL-2.0-or-later
// A perspective or parallel view of space: from points to pixels and back.
// Scope: pinhole without distortion.
#include "draw/camera.h"

#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

// Right and up of a view along `forward`; a view straight down has its up along +y.
void axes_of_view(const Vec3& forward, Vec3& right, Vec3& up) {
  const Vec3 upright = std::abs(forward.z()) > 0.999 ? Vec3::UnitY() : Vec3::UnitZ();
  right = forward.cross(upright).normalized();
  up = right.cross(forward);
}

}  // namespace

Camera Camera::perspective(const Vec3& eye, const Vec3& target, double opening, int width,
                           int height) {
  Camera camera;
  camera.eye_ = eye;
  camera.forward_ = (target - eye).normalized();
  axes_of_view(camera.forward_, camera.right_, camera.up_);
  camera.scale_ = 0.5 * height / std::tan(0.5 * opening);
  camera.middle_ = {0.5 * width, 0.5 * height};
  return camera;
}

Camera Camera::parallel(const Vec3& direction, const Vec3& target, double radius, int size) {
  Camera camera;
  camera.perspective_ = false;
  camera.forward_ = direction.normalized();
  camera.eye_ = target - radius * camera.forward_;
  axes_of_view(camera.forward_, camera.right_, camera.up_);
  camera.scale_ = 0.5 * size / radius;
  camera.middle_ = {0.5 * size, 0.5 * size};
  return camera;
}

Vec2 Camera::place(const Vec3& p) const {
  const Vec3 d = p - eye_;
  const double scale = perspective_ ? scale_ / forward_.dot(d) : scale_;
  return middle_ + scale * Vec2(right_.dot(d), -up_.dot(d));
}

std::vector<Vec3> Camera::clipped(const std::vector<Vec3>& polygon) const {
  if (std::ranges::all_of(polygon, [this](const Vec3& p) { return sees(p); })) return polygon;
  std::vector<Vec3> part;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (sees(a)) part.push_back(a);
    if (sees(a) != sees(b))
      part.push_back(a + (b - a) * ((kNear - depth(a)) / (depth(b) - depth(a))));
  }
  return part;
}

Vec3 Camera::point(const Vec2& place, double nearness) const {
  const double depth = perspective_ ? 1.0 / nearness : -nearness;
  const double scale = perspective_ ? depth / scale_ : 1.0 / scale_;
  const Vec2 d = scale * (place - middle_);
  return eye_ + depth * forward_ + d.x() * right_ - d.y() * up_;
}

Vec3 Camera::nearness_of_plane(const Vec3& p, const Vec3& normal) const {
  const double distance = normal.dot(p - eye_);
  const double nr = normal.dot(right_) / scale_, nu = -normal.dot(up_) / scale_,
               nf = normal.dot(forward_);
  // Perspective: the point at depth w is w (forward + X right - Y up) with X, Y per focal length,
  // so 1/w = n.(forward + X right - Y up) / n.(p - eye). Parallel: w = (n.(p - eye) - X n.right + Y
  // n.up) / n.forward.
  const Vec3 about_middle = perspective_ ? Vec3(nf / distance, nr / distance, nu / distance)
                                         : Vec3(-distance / nf, nr / nf, nu / nf);
  return {about_middle.x() - about_middle.y() * middle_.x() - about_middle.z() * middle_.y(),
          about_middle.y(), about_middle.z()};
}

}  // namespace muckpile
