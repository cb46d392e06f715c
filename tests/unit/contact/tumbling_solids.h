// SPDX-License-Identifier: GPL-2.0-or-later
// A few polyhedral bodies that move by leapfrog under gravity and their contacts, for tests.
// Scope: all pairs are looked at in every step; bodies of infinite mass stand still.
#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "contact/polyhedra/solid_contact.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile::test {

inline constexpr double kHeavy = 1e300;  // mass of what stands still [kg]

struct TumblingBody {
  Solid solid;
  double volume;
  Mat3 inertia_per_mass;  // in body axes [m2]
  SolidBody state;
  Vec3 momentum;  // angular [kg m2/s]
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();

  [[nodiscard]] bool moves() const { return state.mass < kHeavy; }
  [[nodiscard]] Mat3 inertia() const {
    return state.mass * state.pose.axes * inertia_per_mass * state.pose.axes.transpose();
  }
  [[nodiscard]] double kinetic() const {
    return moves() ? 0.5 * (state.mass * state.velocity.squaredNorm() + momentum.dot(state.spin))
                   : 0.0;
  }
};

/// A box [-edge/2, edge/2] without what a few random planes cut off.
inline Polyhedron random_solid(std::mt19937& random, const Vec3& edges, int planes) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> depth(0.3, 0.5);
  ConvexCell cell = box_cell(-0.5 * edges, 0.5 * edges);
  for (int k = 0; k < planes; ++k) {
    const Vec3 n = Vec3(normal(random), normal(random), normal(random)).normalized();
    if (auto halves = divided(cell, depth(random) * edges.minCoeff() * n, n, k))
      cell = std::move(halves->below);
  }
  return cell.shape;
}

inline Mat3 random_turn(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Quat(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

class TumblingSolids {
 public:
  TumblingSolids(const ContactParameters& parameters, double time_step)
      : law_(parameters), time_step_(time_step) {}

  Vec3 gravity = Vec3::Zero();  // [m/s2]

  int add(const Polyhedron& shape, double density, const Pose& pose,
          const Vec3& velocity = Vec3::Zero(), const Vec3& spin = Vec3::Zero()) {
    const MassProperties mass = mass_properties(shape);
    TumblingBody body{Solid(shape, {mass.centroid, Mat3::Identity()}),
                      mass.volume,
                      mass.inertia / mass.volume,
                      {nullptr, pose, velocity, spin, density * mass.volume},
                      Vec3::Zero()};
    body.momentum = body.inertia() * spin;
    bodies_.push_back(body);
    return static_cast<int>(bodies_.size()) - 1;
  }
  int add_fixed(const Polyhedron& shape, const Pose& pose) {
    const int body = add(shape, 1.0, pose);
    bodies_.back().state.mass = kHeavy;
    return body;
  }

  void step() {
    find_forces();
    for (TumblingBody& body : bodies_) {
      if (!body.moves()) continue;
      SolidBody& s = body.state;
      s.velocity += time_step_ * (body.force / s.mass + gravity);
      body.momentum += time_step_ * body.moment;
      s.pose.centre += time_step_ * s.velocity;
      turn(body);
    }
    // Velocities of full steps are half a kick on: energy() and the like use those of mid-step.
  }

  void find_forces() {
    elastic_ = 0.0;
    touching_ = 0;
    for (TumblingBody& body : bodies_) body.force = body.moment = Vec3::Zero();
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      for (std::size_t b = a + 1; b < bodies_.size(); ++b)
        if (bodies_[a].moves() || bodies_[b].moves()) touch(a, b);
  }

  std::vector<TumblingBody>& bodies() { return bodies_; }
  [[nodiscard]] double elastic() const { return elastic_; }
  [[nodiscard]] int touching() const { return touching_; }
  [[nodiscard]] double friction_loss() const { return friction_loss_; }
  [[nodiscard]] double damping_loss() const { return damping_loss_; }
  [[nodiscard]] double kinetic() const {
    double sum = 0.0;
    for (const TumblingBody& body : bodies_) sum += body.kinetic();
    return sum;
  }
  [[nodiscard]] Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (const TumblingBody& body : bodies_)
      if (body.moves()) sum += body.state.mass * body.state.velocity;
    return sum;
  }
  [[nodiscard]] Vec3 angular_momentum() const {
    Vec3 sum = Vec3::Zero();
    for (const TumblingBody& body : bodies_)
      if (body.moves())
        sum += body.momentum + body.state.mass * body.state.pose.centre.cross(body.state.velocity);
    return sum;
  }

 private:
  struct Memory {
    bool lasts = false;
    Vec3 axis = Vec3::Zero();
    ContactState state{};
  };

  void touch(std::size_t a, std::size_t b) {
    TumblingBody &first = bodies_[a], &second = bodies_[b];
    first.state.solid = &first.solid;
    second.state.solid = &second.solid;
    Memory& memory = memory_[{a, b}];
    SolidResponse r;
    memory.lasts = contact_
                       .step(law_, first.state, second.state, time_step_, time_step_, !memory.lasts,
                             memory.axis, memory.state, r)
                       .lasts;
    if (!memory.lasts) return;
    ++touching_;
    elastic_ += r.elastic_energy;
    friction_loss_ += r.friction_loss;
    damping_loss_ += r.damping_loss;
    first.force += r.force;
    first.moment += r.moment;
    second.force -= r.force;
    second.moment -= r.moment - (second.state.pose.centre - first.state.pose.centre).cross(r.force);
  }

  // Angular momentum is kept in space; the spin is that of the orientation in mid-step.
  void turn(TumblingBody& body) const {
    const Mat3 start = body.state.pose.axes;
    for (int k = 0; k < 4; ++k) {
      const Vec3 half = 0.5 * time_step_ * body.state.spin;
      const Mat3 middle = rotation(half) * start;
      body.state.spin = body.state.mass > 0.0
                            ? Vec3(middle * body.inertia_per_mass.inverse() * middle.transpose() *
                                   body.momentum / body.state.mass)
                            : Vec3(Vec3::Zero());
    }
    body.state.pose.axes = rotation(time_step_ * body.state.spin) * start;
    body.state.pose.axes = Quat(body.state.pose.axes).normalized().toRotationMatrix();
    const Mat3& now = body.state.pose.axes;
    body.state.spin =
        now * body.inertia_per_mass.inverse() * now.transpose() * body.momentum / body.state.mass;
  }
  static Mat3 rotation(const Vec3& by) {
    const double angle = by.norm();
    return angle > 0.0 ? Eigen::AngleAxisd(angle, by / angle).toRotationMatrix()
                       : Mat3(Mat3::Identity());
  }

  SolidContactLaw law_;
  SolidContact contact_;
  double time_step_;
  std::vector<TumblingBody> bodies_;
  std::map<std::pair<std::size_t, std::size_t>, Memory> memory_;
  double elastic_ = 0.0, friction_loss_ = 0.0, damping_loss_ = 0.0;
  int touching_ = 0;
};

}  // namespace muckpile::test
