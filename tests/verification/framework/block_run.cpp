// SPDX-License-Identifier: GPL-2.0-or-later
// Rigid blocks under one or more facet networks, moved by leapfrog, without the engine.
// Scope: see the header.
#include "framework/block_run.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bond/build/wall_facets.h"
#include "bond/linear/stable_step.h"

namespace muckpile::verification {
namespace {

Mat3 reflection(const Vec3& normal) { return Mat3::Identity() - 2.0 * normal * normal.transpose(); }

bool has_image(Wall wall) {
  return wall == Wall::even || wall == Wall::odd || wall == Wall::repeat;
}

Support support_of(Wall wall) {
  if (wall == Wall::free) return Support::free;
  return wall == Wall::fixed ? Support::fixed : Support::mirror;
}

}  // namespace

Mat3 rotation_by(const Vec3& angle) {
  const double size = angle.norm();
  return size > 0.0 ? Mat3(Eigen::AngleAxisd(size, angle / size)) : Mat3(Mat3::Identity());
}

WallRule walls_with(const Vec3& parity, const Vec3& box) {
  return [=](const Vec3& at) {
    for (int a = 0; a < 3; ++a) {
      const double slack = 1e-6 * box[a];
      if (at[a] > slack && at[a] < box[a] - slack) continue;
      return parity[a] > 0.0 ? Wall::even : Wall::odd;
    }
    return Wall::free;
  };
}

BlockRun::BlockRun(const std::vector<Block>& blocks, const std::vector<JointParameters>& networks,
                   const WallRule& walls, const NaturalJoints& natural, Leaning leaning,
                   std::span<const Hole> holes, const test::Zones& zones)
    : angular_momentum_(blocks.size(), Vec3::Zero()) {
  for (const Block& block : blocks) {
    const std::uint8_t zone = zones.of.empty() ? std::uint8_t{0} : zones.of[mass_.size()];
    const double density = zone == 0 ? networks.front().density : zones.rocks[zone - 1u].density;
    mass_.push_back(density * block.mass.volume);
    volume_.push_back(block.mass.volume);
    inertia_.push_back(density * block.mass.inertia);
    inverse_inertia_.push_back(inertia_.back().inverse());
    start_.push_back(block.mass.centroid);
    state_.push_back({Mat3::Identity(), block.mass.centroid, Vec3::Zero(), Vec3::Zero()});
  }
  make_networks(blocks, networks, walls, natural, leaning, holes, zones);
  force_.assign(state_.size(), Vec3::Zero());
  torque_.assign(state_.size(), Vec3::Zero());
}

void BlockRun::make_networks(const std::vector<Block>& blocks,
                             const std::vector<JointParameters>& networks, const WallRule& walls,
                             const NaturalJoints& natural, Leaning leaning,
                             std::span<const Hole> holes, const test::Zones& zones) {
  FacetSet set = build_facets(
      blocks, 1, [&](const Vec3& at) { return support_of(walls(at)); }, leaning, zones.of);
  fit_walls(blocks, 1, holes, set);
  assign_joint_classes(natural.planes, blocks, 1, set.facets);
  const auto zone_of = [&](std::size_t b) {
    return zones.of.empty() ? std::uint8_t{0} : zones.of[b];
  };
  std::vector<BlockConstants> constants;
  for (std::size_t b = 0; b < size(); ++b) {
    constants.push_back({static_cast<int>(b) + 1, true, volume_[b], mass_[b], {}, zone_of(b)});
  }
  std::vector<Facet*> grounded;
  for (Facet& facet : set.facets) {
    facet.i = facet.tag_i - 1;
    facet.j = facet.tag_j - 1;
    if (facet.tag_j != kGroundTag) continue;
    const auto b = static_cast<std::size_t>(facet.i);
    const Vec3 at = start_[b] + facet.arm_i;
    const Wall wall = walls(at);
    if (!has_image(wall)) {
      grounded.push_back(&facet);
      continue;
    }
    const Vec3 from = wall == Wall::repeat ? facet.arm_i : at;  // half a shift is half a block
    const Vec3 plane = facet.normal.dot(from) * facet.normal;
    const Vec3 image = start_[b] + 2.0 * facet.normal.dot(facet.arm_i) * facet.normal;
    const Mat3 map = wall == Wall::repeat ? Mat3::Identity() : reflection(facet.normal);
    images_.push_back({b, facet.normal, plane, image, wall == Wall::odd ? -1.0 : 1.0, map});
    state_.push_back({Mat3::Identity(), image, Vec3::Zero(), Vec3::Zero()});
    facet.kind = FacetKind::joint;
    facet.joint_class = static_cast<std::uint8_t>(natural.classes.size() + 1);
    facet.j = static_cast<int>(constants.size());
    facet.tag_j = facet.j + 1;
    facet.arm_j = at - image;
    facet.opening_j = (wall == Wall::repeat ? 1.0 : -1.0) * map * facet.opening_i;
    facet.slanted[1] = facet.slanted[0];
    facet.weight = 0.5;  // the other half belongs to the reflected rock
    constants.push_back({facet.tag_j, false, volume_[b], mass_[b], {}, zone_of(b)});
  }
  for (BoundaryFace& face : set.faces) face.block = face.tag - 1;
  for (Facet* facet : grounded) facet->j = static_cast<int>(constants.size());
  std::vector<JointClass> classes = natural.classes;
  for (const JointParameters& parameters : networks) {
    classes.resize(natural.classes.size());
    classes.push_back({1e30, 1e30, 0.0, 0.0, parameters.normal_stiffness,
                       parameters.shear_stiffness});  // of joints with images: they hold
    networks_.emplace_back(JointMaterial(parameters), classes,
                           std::vector<JointMaterial>(zones.rocks.begin(), zones.rocks.end()));
    networks_.back().set(constants, {set.facets, {}, set.faces});
  }
}

double BlockRun::total_volume() const {
  return std::accumulate(volume_.begin(), volume_.end(), 0.0);
}

void BlockRun::place(std::size_t b, const Vec3& displacement, const Vec3& rotation) {
  state_[b].centre = start_[b] + displacement;
  state_[b].rotation = rotation_by(rotation);
}

void BlockRun::set_motion(std::size_t b, const Vec3& velocity, const Vec3& spin) {
  const Mat3& r = state_[b].rotation;
  state_[b].velocity = velocity;
  state_[b].spin = spin;
  angular_momentum_[b] = r * inertia_[b] * r.transpose() * spin;
}

/// A displacement is a polar vector, a rotation an axial one.
void BlockRun::reflect(std::size_t k) {
  const Image& image = images_[k];
  const BlockState& from = state_[image.of];
  const Mat3& map = image.map;
  const double axial = image.parity * map.determinant();
  BlockState& to = state_[size() + k];
  to.centre = image.start + image.parity * map * (from.centre - start_[image.of]) +
              2.0 * strain_ * image.wall;
  to.velocity = image.parity * map * from.velocity;
  to.spin = axial * map * from.spin;
  to.rotation = map * (image.parity > 0.0 ? from.rotation : from.rotation.transpose()) * map;
}

void BlockRun::reflect_scalars(std::span<double> values) const {
  for (std::size_t k = 0; k < images_.size(); ++k) {
    values[size() + k] = images_[k].parity * values[images_[k].of];
  }
}

void BlockRun::reflect_tensors(std::span<double> values) const {
  for (std::size_t k = 0; k < images_.size(); ++k) {
    const Image& image = images_[k];
    Eigen::Map<Mat3>(values.data() + 9 * (size() + k)) =
        image.parity * image.map * Eigen::Map<const Mat3>(values.data() + 9 * image.of) *
        image.map.transpose();
  }
}

void BlockRun::compute(double dt) {
  for (std::size_t k = 0; k < images_.size(); ++k) reflect(k);
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  std::fill(torque_.begin(), torque_.end(), Vec3::Zero());
  for (FacetNetwork& network : networks_) {
    std::copy(state_.begin(), state_.end(), network.state().begin());
    network.step(dt, {.fill_copies = [this](std::span<double> values, std::size_t width) {
                   if (width == 1) reflect_scalars(values);
                   if (width == 9) reflect_tensors(values);
                 }});
    for (std::size_t b = 0; b < state_.size(); ++b) {
      force_[b] += network.force()[b];
      torque_[b] += network.torque()[b];
    }
  }
}

void BlockRun::kick(double dt) {
  for (std::size_t b = 0; b < size(); ++b) {
    state_[b].velocity += dt / mass_[b] * force_[b];
    angular_momentum_[b] += dt * torque_[b];
  }
}

/// Turns by the spin at mid-step, which a first half turn predicts.
void BlockRun::drift(double dt) {
  const auto spin = [&](std::size_t b, const Mat3& r) -> Vec3 {
    return r * (inverse_inertia_[b] * (r.transpose() * angular_momentum_[b]));
  };
  for (std::size_t b = 0; b < size(); ++b) {
    BlockState& s = state_[b];
    s.centre += dt * s.velocity;
    const Mat3 middle = rotation_by(0.5 * dt * spin(b, s.rotation)) * s.rotation;
    s.rotation = rotation_by(dt * spin(b, middle)) * s.rotation;
  }
}

void BlockRun::step(double dt) {
  kick(0.5 * dt);
  drift(dt);
  compute(dt);
  kick(0.5 * dt);
  for (std::size_t b = 0; b < size(); ++b) {
    const Mat3& r = state_[b].rotation;
    state_[b].spin = r * (inverse_inertia_[b] * (r.transpose() * angular_momentum_[b]));
  }
}

double BlockRun::stable_step() const {
  std::vector<Mat3> inertia;
  for (std::size_t b = 0; b < size(); ++b) {
    const Mat3& r = state_[b].rotation;
    inertia.push_back(r * inverse_inertia_[b].inverse() * r.transpose());
  }
  double sum = 0.0;
  for (const FacetNetwork& network : networks_)
    sum += std::pow(muckpile::stable_step(network, inertia, Breaking::none).seconds, -2.0);
  return 1.0 / std::sqrt(sum);
}

double BlockRun::kinetic_energy() const {
  double energy = 0.0;
  for (std::size_t b = 0; b < size(); ++b) {
    energy += 0.5 * (mass_[b] * state_[b].velocity.squaredNorm() +
                     state_[b].spin.dot(angular_momentum_[b]));
  }
  return energy;
}

double BlockRun::elastic_energy() const {
  double energy = 0.0;
  for (const FacetNetwork& network : networks_) energy += network.elastic_energy();
  return energy;
}

std::vector<Mat3> BlockRun::stresses() const {
  std::vector<Mat3> sum(state_.size() + 1,
                        Mat3::Zero());  // images and the ground are left out below
  for (const FacetNetwork& network : networks_) {
    for (std::size_t f = 0; f < network.facets().size(); ++f) {
      const Facet& facet = network.facets()[f];
      const Vec3 force = facet.area * network.mean_traction(f);
      sum[static_cast<std::size_t>(facet.i)] += force * facet.arm_i.transpose();
      sum[static_cast<std::size_t>(facet.j)] -= force * facet.arm_j.transpose();
    }
    for (const BoundaryFace& face : network.faces()) {
      sum[static_cast<std::size_t>(face.block)] -=
          face.pressure * face.area * face.normal * face.arm.transpose();
    }
  }
  sum.resize(size());
  for (std::size_t b = 0; b < size(); ++b)
    sum[b] = 0.5 * (sum[b] + sum[b].transpose()).eval() / volume_[b];
  return sum;
}

Mat3 BlockRun::average_stress() const {
  Mat3 sum = Mat3::Zero();
  for (std::size_t k = 0; k < images_.size(); ++k) {
    sum -= force_[size() + k] * images_[k].wall.transpose();
  }
  return 0.5 * (sum + sum.transpose()) / total_volume();
}

}  // namespace muckpile::verification
