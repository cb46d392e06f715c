// SPDX-License-Identifier: GPL-2.0-or-later
// A few blocks, their facet network and a leapfrog integrator.
// Scope: see the header.
#include "bond_scene.h"

#include <algorithm>
#include <numbers>

#include "../geometry/shapes.h"
#include "geometry/cut/joint_set_cut.h"

namespace muckpile::test {

JointParameters rock(double poisson_ratio) {
  JointParameters p;
  p.youngs_modulus = 50e9;
  p.poisson_ratio = poisson_ratio;
  p.density = 2600.0;
  p.tension = p.cohesion = 1e30;
  return p;
}

std::vector<Block> cuboids(int nx, int ny, int nz, const Vec3& edge) {
  std::vector<Block> blocks;
  const auto number = [&](int i, int j, int k) {
    const bool inside = i >= 0 && i < nx && j >= 0 && j < ny && k >= 0 && k < nz;
    return inside ? i + nx * (j + ny * k) : kFreeFace;
  };
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        Block block;
        const Vec3 low = edge.cwiseProduct(Vec3(i, j, k));
        block.shape = box(low, low + edge);
        block.mass = mass_properties(block.shape);
        block.neighbour = {number(i - 1, j, k), number(i + 1, j, k), number(i, j - 1, k),
                           number(i, j + 1, k), number(i, j, k - 1), number(i, j, k + 1)};
        blocks.push_back(block);
      }
  return blocks;
}

std::vector<Block> voronoi_blocks(double edge, unsigned long seed, int sweeps) {
  return cube_of_blocks(edge, sweeps, seed).blocks;
}

std::vector<Block> leaning_blocks(double edge) {
  TessellationOptions options;
  options.lo = Vec3::Constant(-0.5 * edge);
  options.hi = Vec3::Constant(0.5 * edge);
  JointSetCut how;
  constexpr double kDegree = std::numbers::pi / 180.0;
  for (const auto& [dip, direction] : {std::pair{75.0, 90.0}, {85.0, 0.0}, {10.0, 270.0}})
    how.sets.push_back({normal_of_dip(dip * kDegree, direction * kDegree)});
  return cut_by_joint_sets(options, how).blocks;
}

BondScene leaning_scene(double edge, const JointParameters& parameters) {
  return {leaning_blocks(edge),
          parameters,
          [](const Vec3&) { return Support::free; },
          {},
          Leaning::much};
}

Mat3 turn(const Vec3& angle) {
  const double size = angle.norm();
  return size > 0.0 ? Mat3(Eigen::AngleAxisd(size, angle / size)) : Mat3(Mat3::Identity());
}

BondScene::BondScene(const std::vector<Block>& blocks, const JointParameters& parameters,
                     const SupportRule& support, const NaturalJoints& natural, Leaning leaning,
                     const Zones& zones)
    : zones_(zones.rocks.begin(), zones.rocks.end()),
      network_(JointMaterial(parameters), natural.classes, zones_),
      angular_momentum_(blocks.size(), Vec3::Zero()) {
  std::vector<BlockConstants> constants;
  for (const Block& block : blocks) {
    const std::uint8_t zone = zones.of.empty() ? std::uint8_t{0} : zones.of[constants.size()];
    const double density = zone == 0 ? parameters.density : zones.rocks[zone - 1u].density;
    mass_.push_back(density * block.mass.volume);
    inertia_.push_back(density * block.mass.inertia);
    start_.push_back(block.mass.centroid);
    constants.push_back(
        {static_cast<int>(constants.size()) + 1, true, block.mass.volume, mass_.back(), {}, zone});
  }
  const auto ground = static_cast<int>(blocks.size());
  FacetSet set = build_facets(blocks, 1, support, leaning, zones.of);
  assign_joint_classes(natural.planes, blocks, 1, set.facets);
  for (Facet& facet : set.facets) {
    facet.i = facet.tag_i - 1;
    facet.j = facet.tag_j == kGroundTag ? ground : facet.tag_j - 1;
  }
  for (BoundaryFace& face : set.faces) face.block = face.tag - 1;
  network_.set(std::move(constants), {std::move(set.facets), {}, std::move(set.faces)});
  for (std::size_t b = 0; b < size(); ++b) block(b).centre = start_[b];
}

void BondScene::deform(const Mat3& gradient) {
  for (std::size_t b = 0; b < size(); ++b) block(b).centre = start_[b] + gradient * start_[b];
}

void BondScene::move_rigidly(const Vec3& axis, const Vec3& shift) {
  const Mat3 rotation = turn(axis);
  for (std::size_t b = 0; b < size(); ++b) {
    block(b).centre = rotation * block(b).centre + shift;
    block(b).rotation = rotation * block(b).rotation;
  }
}

void BondScene::shake(double shift, double angle, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  for (std::size_t b = 0; b < size(); ++b) {
    block(b).centre += shift * vector();
    block(b).rotation = turn(angle * vector()) * block(b).rotation;
  }
}

void BondScene::compute(double dt) { network_.step(dt); }

void BondScene::kick(double dt) {
  for (std::size_t b = 0; b < size(); ++b) {
    BlockState& s = block(b);
    s.velocity += dt / mass_[b] * network_.force()[b];
    angular_momentum_[b] += dt * network_.torque()[b];
    s.spin = s.rotation * inertia_[b].inverse() * s.rotation.transpose() * angular_momentum_[b];
  }
}

void BondScene::step(double dt) {
  // Spins that a test has set count as they are.
  for (std::size_t b = 0; b < size(); ++b) {
    const Mat3& r = block(b).rotation;
    angular_momentum_[b] = r * inertia_[b] * r.transpose() * block(b).spin;
  }
  kick(0.5 * dt);
  for (std::size_t b = 0; b < size(); ++b) {
    BlockState& s = block(b);
    s.centre += dt * s.velocity;
    const Mat3 middle = turn(0.5 * dt * s.spin) * s.rotation;
    s.spin = middle * inertia_[b].inverse() * middle.transpose() * angular_momentum_[b];
    s.rotation = turn(dt * s.spin) * s.rotation;
  }
  compute(dt);
  kick(0.5 * dt);
}

double BondScene::stable_step(Breaking breaking) {
  std::vector<Mat3> inertia;
  for (std::size_t b = 0; b < size(); ++b) {
    const Mat3& r = block(b).rotation;
    inertia.push_back(r * inertia_[b] * r.transpose());
  }
  return muckpile::stable_step(network_, inertia, breaking).seconds;
}

double BondScene::kinetic_energy() const {
  auto& network = const_cast<FacetNetwork&>(network_);
  double energy = 0.0;
  for (std::size_t b = 0; b < size(); ++b) {
    const BlockState& s = network.state()[b];
    const Vec3 spin = s.rotation.transpose() * s.spin;
    energy += 0.5 * (mass_[b] * s.velocity.squaredNorm() + spin.dot(inertia_[b] * spin));
  }
  return energy;
}

double BondScene::energy_account() {
  const JointLosses& lost = network_.losses();
  return kinetic_energy() + network_.elastic_energy() + lost.fracture + lost.friction +
         lost.damping + lost.quiet - network_.pressure_work();
}

Vec3 BondScene::facet_force(std::size_t f) {
  FacetNetwork alone(network_.material(), {}, zones_);
  std::vector<BlockConstants> blocks = network_.blocks();
  blocks.pop_back();  // the ground, which set() appends
  const RankTeam others{.sum = [&](double) { return network_.slanted() ? 1.0 : 0.0; }};
  alone.set(blocks, {{network_.facets()[f]}, {network_.memory(f)}, {}}, others);
  for (std::size_t b = 0; b < size(); ++b) alone.state()[b] = block(b);
  // Its blocks have the dilatations, gradients and stresses that all their facets give them.
  std::vector<std::vector<double>> fields;
  network_.find_stresses({.fill_copies = [&](std::span<double> values, std::size_t) {
    fields.emplace_back(values.begin(), values.end());
  }});
  std::size_t field = 0;
  alone.step(0.0, {.fill_copies = [&](std::span<double> values, std::size_t) {
               std::ranges::copy(fields[field++], values.begin());
             }});
  return alone.force()[static_cast<std::size_t>(network_.facets()[f].i)];
}

namespace {

/// Elastic energy less the work that constant pressures do about the pose `from`.
double potential(BondScene& scene, const std::vector<Mat3>& from) {
  FacetNetwork& network = scene.network();
  network.find_stresses();
  double energy = network.elastic_energy();
  for (const BoundaryFace& face : network.faces()) {
    if (face.pressure == 0.0) continue;
    const auto b = static_cast<std::size_t>(face.block);
    const BlockState& s = network.state()[b];
    const Vec3 moved = s.centre + s.rotation * face.arm - face.start;
    // The face's own displacement by the network; the block's anew, along the normal of `from`,
    // about which the derivative is taken.
    const double own = network.volume_swept(face) - face.rigid_swept;
    energy -= face.pressure * (own - face.area * (from[b] * face.normal).dot(moved));
  }
  return energy;
}

}  // namespace

GradientError gradient_error(BondScene& scene, double step) {
  scene.compute();
  const std::vector<Vec3> force(scene.network().force().begin(), scene.network().force().end());
  const std::vector<Vec3> torque(scene.network().torque().begin(), scene.network().torque().end());
  std::vector<Mat3> from;
  for (std::size_t b = 0; b < scene.size(); ++b) from.push_back(scene.block(b).rotation);
  GradientError error{0.0, 0.0};
  double forces = 0.0, torques = 0.0;
  for (std::size_t b = 0; b < scene.size(); ++b) {
    BlockState& s = scene.block(b);
    const BlockState home = s;
    for (int k = 0; k < 3; ++k) {
      const auto slope = [&](auto&& move) {
        move(step);
        const double up = potential(scene, from);
        s = home;
        move(-step);
        const double down = potential(scene, from);
        s = home;
        return -(up - down) / (2.0 * step);
      };
      const double f = slope([&](double by) { s.centre[k] += by; });
      const double t =
          slope([&](double by) { s.rotation = turn(by * Vec3::Unit(k)) * home.rotation; });
      error.force = std::max(error.force, std::abs(f - force[b][k]));
      error.torque = std::max(error.torque, std::abs(t - torque[b][k]));
    }
    forces = std::max(forces, force[b].norm());
    torques = std::max(torques, torque[b].norm());
  }
  return {error.force / forces, error.torque / torques};
}

}  // namespace muckpile::test
