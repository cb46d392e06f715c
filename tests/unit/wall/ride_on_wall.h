// SPDX-License-Identifier: GPL-2.0-or-later
// A sphere on a wall and its energy account, stepped as LIGGGHTS does (leapfrog; forces see the
// velocities between steps).
// Scope: one sphere, as one block.
#pragma once

#include <cmath>
#include <vector>

#include "wall/wall_law.h"
#include "wall/wall_plane.h"

namespace muckpile::test {

inline constexpr double kRadius = 0.5, kMass = 1400.0;               // [m], [kg]
inline constexpr double kInertia = 0.4 * kMass * kRadius * kRadius;  // [kg m2]
inline constexpr double kGravity = 9.81;                             // [m/s2]

inline ContactParameters parameters() {
  ContactParameters p;
  p.youngs_modulus = 1e8;
  p.restitution = 0.4;
  p.friction = 0.5;
  p.rolling_friction = 0.0;
  return p;
}

/// A sphere, its wall, and the books of both.
class Ride {
 public:
  Ride(const WallSurface& wall, const ContactParameters& p, const Vec3& at, double dt,
       bool torsion = false)
      : wall_(wall), law_(p, torsion), dt_(dt) {
    sphere_ = {at, Vec3::Zero(), Vec3::Zero(), kRadius, kMass};
  }
  void push_off(const Vec3& velocity, const Vec3& spin = Vec3::Zero()) {
    sphere_.velocity = velocity;
    sphere_.spin = spin;
    now_ = evaluate(0.0);
  }
  void weigh(const Vec3& gravity) { gravity_ = gravity; }
  void let_turn(bool turns) { turns_ = turns; }

  void step() {
    half_kick();
    sphere_.centre += dt_ * sphere_.velocity;
    now_ = evaluate(dt_);
    friction_ += now_.friction;
    half_kick();
    damping_ += now_.damping;
  }
  void run(double seconds) {
    for (long k = std::lround(seconds / dt_); k > 0; --k) step();
  }

  [[nodiscard]] const WallSphere& sphere() const { return sphere_; }
  [[nodiscard]] const WallPush& now() const { return now_; }
  [[nodiscard]] double kinetic() const {
    return 0.5 * kMass * sphere_.velocity.squaredNorm() +
           0.5 * kInertia * sphere_.spin.squaredNorm();
  }
  /// Of motion, weight, springs, and what was lost [J].
  [[nodiscard]] double energy() const {
    return kinetic() - kMass * gravity_.dot(sphere_.centre) + now_.elastic + friction_ + damping_;
  }
  [[nodiscard]] double friction() const { return friction_; }

 private:
  WallPush evaluate(double memory_step) {
    std::vector<std::size_t> parts;
    WallTouches touches;
    if (wall_.distance(sphere_.centre, 1.2 * kRadius, parts) < kRadius)
      wall_.find_touches(sphere_.centre, kRadius, parts, touches);
    return law_.push(sphere_, touches, dt_, memory_step, contacts_);
  }
  void half_kick() {
    sphere_.velocity += 0.5 * dt_ * (now_.force / kMass + gravity_);
    if (turns_) sphere_.spin += 0.5 * dt_ / kInertia * now_.torque;
  }

  const WallSurface& wall_;
  WallLaw law_;
  double dt_;
  WallSphere sphere_;
  WallPush now_;
  std::vector<WallContact> contacts_;
  Vec3 gravity_ = Vec3::Zero();
  bool turns_ = true;
  double friction_ = 0.0, damping_ = 0.0;
};

inline WallPlane floor_plane() { return WallPlane(Vec3::Zero(), Vec3::UnitZ()); }

}  // namespace muckpile::test
