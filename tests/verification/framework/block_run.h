// SPDX-License-Identifier: GPL-2.0-or-later
// Rigid blocks under one or more facet networks, moved by leapfrog, without the engine.
// Scope: verification programs; one process, all blocks owned, SI units.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "bond/build/facet_builder.h"
#include "bond/build/joint_plane.h"
#include "bond/network/facet_network.h"
#include "geometry/block_model.h"
#include "unit/bond/bond_scene.h"

namespace muckpile::verification {

/// What stands behind a face on the box's wall. `mirror` is the network's own symmetry plane;
/// `even` and `odd` are images of the blocks themselves, so that the box and its reflections fill
/// space: displacement behind the wall is plus or minus the reflected one, and an average strain is
/// possible. `repeat` is the same block again, shifted; for blocks that reach from wall to wall.
/// Facets between a block and its image never break.
enum class Wall { free, fixed, mirror, even, odd, repeat };
using WallRule = std::function<Wall(const Vec3& face_centroid)>;

/// Images behind all walls of a box with one corner at the origin; parity +1 (even) or -1 (odd) of
/// the walls normal to x, y, z.
[[nodiscard]] WallRule walls_with(const Vec3& parity, const Vec3& box);

[[nodiscard]] Mat3 rotation_by(const Vec3& angle);  ///< by its length [rad] about its direction

class BlockRun {
 public:
  /// Every element of `networks` is a facet network of its own over all facets; their forces add.
  BlockRun(const std::vector<Block>& blocks, const std::vector<JointParameters>& networks,
           const WallRule& walls, const NaturalJoints& natural = {},
           Leaning leaning = Leaning::little, std::span<const Hole> holes = {},
           const test::Zones& zones = {});

  [[nodiscard]] std::size_t size() const { return mass_.size(); }
  [[nodiscard]] double mass(std::size_t b) const { return mass_[b]; }
  [[nodiscard]] double volume(std::size_t b) const { return volume_[b]; }
  [[nodiscard]] double total_volume() const;
  [[nodiscard]] const Mat3& inertia(std::size_t b) const { return inertia_[b]; }
  [[nodiscard]] const Vec3& start(std::size_t b) const { return start_[b]; }
  [[nodiscard]] Vec3 displacement(std::size_t b) const { return state_[b].centre - start_[b]; }
  [[nodiscard]] const BlockState& block(std::size_t b) const { return state_[b]; }
  [[nodiscard]] const Vec3& force(std::size_t b) const { return force_[b]; }
  [[nodiscard]] const Vec3& torque(std::size_t b) const { return torque_[b]; }
  [[nodiscard]] FacetNetwork& network(std::size_t k = 0) { return networks_[k]; }
  [[nodiscard]] const FacetNetwork& network(std::size_t k = 0) const { return networks_[k]; }

  /// Position relative to the start, rotation from the start [rad].
  void place(std::size_t b, const Vec3& displacement, const Vec3& rotation);
  void set_motion(std::size_t b, const Vec3& velocity, const Vec3& spin);
  /// Average strain that the images of `even` and `odd` walls follow.
  void set_average_strain(const Mat3& strain) { strain_ = strain; }

  void compute(double dt = 0.0);  ///< forces in the present pose
  /// Kick, drift, forces, kick; compute() must have been called once before.
  void step(double dt);

  /// Of all networks together, by stable_step.h, without breaking [s].
  [[nodiscard]] double stable_step() const;
  [[nodiscard]] double kinetic_energy() const;
  [[nodiscard]] double elastic_energy() const;
  /// Of every block: the mean that the tractions on its faces demand; unbroken rock [Pa].
  [[nodiscard]] std::vector<Mat3> stresses() const;
  /// Average stress that belongs to the average strain: tractions on the walls with images [Pa].
  [[nodiscard]] Mat3 average_stress() const;

 private:
  struct Image {
    std::size_t of;     ///< block
    Vec3 normal, wall;  ///< outward unit normal; the wall's closest point to the origin [m]
    Vec3 start;         ///< [m]
    double parity;
    Mat3 map;  ///< from directions of the block to those of the image
  };
  void make_networks(const std::vector<Block>& blocks, const std::vector<JointParameters>& networks,
                     const WallRule& walls, const NaturalJoints& natural, Leaning leaning,
                     std::span<const Hole> holes, const test::Zones& zones);
  void reflect(std::size_t k);
  void reflect_scalars(std::span<double> values) const;
  void reflect_tensors(std::span<double> values) const;  // nine numbers per block
  void kick(double dt);
  void drift(double dt);

  std::vector<FacetNetwork> networks_;
  std::vector<BlockState> state_;  ///< blocks, then images
  std::vector<Image> images_;
  std::vector<Vec3> force_, torque_;  ///< images included
  std::vector<double> mass_, volume_;
  std::vector<Vec3> start_, angular_momentum_;
  std::vector<Mat3> inertia_, inverse_inertia_;  ///< in the start orientation [kg m2]
  Mat3 strain_ = Mat3::Zero();
};

}  // namespace muckpile::verification
