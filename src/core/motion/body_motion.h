// SPDX-License-Identifier: GPL-2.0-or-later
// The step of rigid bodies made of spheres: forces of the spheres summed, bodies kicked, moved and
// turned side by side, spheres placed.
// Scope: one rank's bodies in rows of numbers as LIGGGHTS has them. What becomes of a body does not
// depend on those beside it. Leapfrog: half a kick, move and turn, forces, half a kick.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/types.h"
#include "motion/rows.h"

namespace muckpile {

/// Three numbers per body each, four of quaternions; nothing is owned.
struct BodyRows {
  double *centre, *velocity, *force;         ///< [m], [m/s], [N]
  double *angular_momentum, *torque, *spin;  ///< in space [kg m2/s], [N m], [rad/s]
  double *x_axis, *y_axis, *z_axis;          ///< principal axes of inertia in space
  double* quaternion;                        ///< of these axes, real part first
};

/// Three numbers per sphere each; nothing is owned.
struct SphereRows {
  double *positions, *velocities, *spins;  ///< [m], [m/s], [rad/s]
  const double *forces, *torques;          ///< [N], [N m]
};

struct BodyConstants {
  double mass = 0.0;            ///< [kg]
  Vec3 inertia = Vec3::Zero();  ///< principal moments [kg m2]; about an axis with 0 none turns
  std::array<bool, 3> moves{true, true, true}, turns{true, true, true};  ///< along x, y, z
};

struct BodySphere {
  int body = 0, sphere = 0;          ///< numbers of rows
  Vec3 displacement = Vec3::Zero();  ///< from the body's centre, along its axes [m]
  Vec3 image = Vec3::Zero();         ///< added to its position: of a periodic box [m]
  bool counts = true;                ///< false: another image of it brings the force
};

struct BodyStep {
  double time = 0.0;       ///< [s]
  double half_kick = 0.0;  ///< half the time, in units that make force over mass an acceleration
};

class BodyMotion {
 public:
  BodyMotion() = default;
  /// Spheres in any order.
  BodyMotion(std::span<const BodyConstants> bodies, std::span<const BodySphere> spheres);

  /// The bodies with a 1 stay as they are; empty: none does. Until told otherwise.
  void let_rest(std::span<const char> rests);

  /// Half a kick, a step of place and rotation with the spin of mid-step, spheres placed. Those of
  /// resting bodies only if `place_resting`.
  void advance(const BodyRows& bodies, const SphereRows& spheres, const BodyStep& step,
               bool place_resting) const;
  /// Adds the forces of the spheres and of `gravity` [m/s2] to those on the bodies; not to
  /// resting ones.
  void sum_forces(const BodyRows& bodies, const SphereRows& spheres, const Vec3& gravity) const;
  /// sum_forces(), then half a kick, with the spin that follows.
  void finish(const BodyRows& bodies, const SphereRows& spheres, const Vec3& gravity,
              const BodyStep& step) const;

 private:
  /// Groups moved before their spheres are placed: what was written one by one number is not yet in
  /// the cache when it is read in other pieces right away, and so many the fastest cache holds.
  static constexpr std::size_t kStretch = 32 / kBodyLanes;
  using Row = std::array<double, kBodyLanes>;
  using Bits = std::uint8_t;  ///< one per body of a group
  /// As many bodies as a vector has lanes. Lanes behind the last body weigh something and do not
  /// move.
  struct Group {
    alignas(64) Row mass;
    std::array<Row, 3> inverse_inertia;
    std::array<Bits, 3> moves, turns;
    bool constrained;  ///< some do not move or turn in all directions
  };
  struct Placed {
    std::array<double, 3> displacement;
    std::int64_t sphere;
  };
  /// Where a body's spheres begin, and those of them that do not count.
  struct Part {
    std::uint32_t first, uncounted;
  };
  /// Of the spheres of a group of bodies, four numbers a row: force, torque about their own
  /// centres, and the force times their displacement along each axis of their body.
  struct Sums {
    alignas(64) std::array<double, 4 * kBodyLanes> force, own_torque;
    std::array<std::array<double, 4 * kBodyLanes>, 3> along;
  };
  struct Moving {
    BodyVectors velocity, momentum;
  };
  struct Acting {
    BodyVectors force, torque;
  };

  void sort_spheres(std::span<const BodySphere> spheres);
  [[nodiscard]] Bits resting_of(std::size_t group) const {
    return resting_.empty() ? Bits{0} : resting_[group];
  }
  [[nodiscard]] bool rests(std::size_t body) const {
    return (resting_of(body / kBodyLanes) >> body % kBodyLanes & 1u) != 0;
  }
  [[nodiscard]] bool all_rest(std::size_t group) const {
    return resting_of(group) == (1u << bodies_of(group)) - 1u;
  }
  [[nodiscard]] std::size_t bodies_of(std::size_t group) const {
    return std::min(kBodyLanes, count_ - kBodyLanes * group);
  }
  template <class Work>
  void on_group(std::size_t group, const BodyRows& bodies, const Work& work) const;
  static void move(const Group& group, const BodyRows& at, const BodyStep& step);
  void place(std::size_t first, std::size_t end, const BodyRows& bodies, const SphereRows& to,
             bool place_resting) const;
  void sum(std::size_t group, const SphereRows& spheres, Sums& sums) const;
  static Acting add_forces(const Group& group, const BodyRows& at, const Sums& sums,
                           const Vec3& gravity);
  static void add_and_kick(const Group& group, const BodyRows& at, const Sums& sums,
                           const Vec3& gravity, double half_kick);
  static Moving kick(const Group& group, const BodyRows& at, const Acting& acting,
                     double half_kick);

  std::size_t count_ = 0;
  std::vector<Group> groups_;
  std::vector<Part> parts_;      ///< one more than bodies
  std::vector<Placed> spheres_;  ///< body by body
  std::vector<Vec3> images_;     ///< of spheres_; empty: none has one
  std::vector<Bits> resting_;    ///< per group; empty: none rests
};

}  // namespace muckpile
