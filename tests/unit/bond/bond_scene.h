// SPDX-License-Identifier: GPL-2.0-or-later
// A few blocks, their facet network and a leapfrog integrator, without the engine.
// Scope: tests only; all blocks owned, SI units.
#pragma once

#include <random>
#include <vector>

#include "bond/build/facet_builder.h"
#include "bond/build/joint_plane.h"
#include "bond/linear/stable_step.h"
#include "bond/network/facet_network.h"
#include "geometry/block_model.h"

namespace muckpile::test {

/// E = 50 GPa, 2600 kg/m3, so strong that nothing breaks; tests set what they are about.
JointParameters rock(double poisson_ratio);

/// nx x ny x nz cuboids with edges `edge` [m], first corner at the origin; x runs fastest.
std::vector<Block> cuboids(int nx, int ny, int nz, const Vec3& edge = Vec3::Ones());

/// Cube of the given edge [m] cut into centroidal Voronoi blocks of about 1 m.
std::vector<Block> voronoi_blocks(double edge, unsigned long seed, int sweeps = 30);

/// Cube of the given edge [m] about the origin, cut into blocks of about 1 m by three sets whose
/// faces lean against the lines between centres: dip and dip direction 75 90, 85 0, 10 270 degrees.
std::vector<Block> leaning_blocks(double edge);

/// Rock beside that of a scene.
struct Zones {
  std::vector<JointParameters> rocks;  ///< of the zones from 1
  std::vector<std::uint8_t> of;        ///< zone of each block; none: 0
};

class BondScene {
 public:
  BondScene(
      const std::vector<Block>& blocks, const JointParameters& parameters,
      const SupportRule& support = [](const Vec3&) { return Support::free; },
      const NaturalJoints& natural = {}, Leaning leaning = Leaning::little,
      const Zones& zones = {});

  [[nodiscard]] FacetNetwork& network() { return network_; }
  [[nodiscard]] std::size_t size() const { return mass_.size(); }
  [[nodiscard]] BlockState& block(std::size_t b) { return network_.state()[b]; }
  [[nodiscard]] double mass(std::size_t b) const { return mass_[b]; }
  [[nodiscard]] const Vec3& start(std::size_t b) const { return start_[b]; }

  /// Centres move to (1 + gradient) x start; no rotation.
  void deform(const Mat3& gradient);
  /// The whole body turns about `axis` (its length is the angle [rad]) and shifts.
  void move_rigidly(const Vec3& axis, const Vec3& shift);
  /// Every centre moves by up to `shift` [m] and every block turns by up to `turn` [rad].
  void shake(double shift, double turn, unsigned seed);

  /// Forces in the present pose.
  void compute(double dt = 0.0);
  /// Kick, drift, force, kick; compute() must have been called once before.
  void step(double dt);

  /// Bound for the present pose, after compute() [s].
  [[nodiscard]] double stable_step(Breaking breaking = Breaking::possible);

  [[nodiscard]] double kinetic_energy() const;
  /// Kinetic and elastic energy and all losses, less the work of pressures [J].
  [[nodiscard]] double energy_account();
  /// Force that facet f alone puts on its block i, with the dilatations of the present pose [N].
  [[nodiscard]] Vec3 facet_force(std::size_t f);

 private:
  void kick(double dt);

  std::vector<JointMaterial> zones_;
  FacetNetwork network_;
  std::vector<double> mass_;
  std::vector<Vec3> start_;
  std::vector<Mat3> inertia_;  // in the start orientation [kg m2]
  std::vector<Vec3> angular_momentum_;
};

/// Free leaning blocks with the terms of leaning_faces.h.
BondScene leaning_scene(double edge, const JointParameters& parameters);

struct GradientError {
  double force, torque;  ///< largest, over the largest force and torque
};
/// Of the forces against the slope of the elastic energy, less the work of constant pressures, over
/// `step` [m, rad] about the present pose.
GradientError gradient_error(BondScene& scene, double step);

/// Rotation by the vector's length about its direction.
Mat3 turn(const Vec3& angle);

}  // namespace muckpile::test
