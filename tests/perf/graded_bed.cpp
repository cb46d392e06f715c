// SPDX-License-Identifier: GPL-2.0-or-later
// The graded bed: 8,000 blocks of 0.1 m beside 1,000 blocks of 1 m.
// Scope: see the header.
#include "graded_bed.h"

#include <Eigen/Geometry>
#include <random>

namespace muckpile::perf {
namespace {

/// Eight spheres in the corners of a cube and one in the middle, turned at random by up to 0.05.
std::vector<testing::Ball> cube(double size, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const Vec3 axis = Vec3(unit(random), unit(random), unit(random)).normalized();
  const Mat3 turn(Eigen::AngleAxisd(0.05 * unit(random), axis));
  std::vector<testing::Ball> balls{{Vec3::Zero(), 0.5 * size}};
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        balls.push_back({turn * (0.25 * size * Vec3(x, y, z)), 0.25 * size});
  return balls;
}

void add_lattice(std::vector<testing::BlockSpec>& bed, int per_side, double size, double spacing,
                 const Vec3& corner, std::mt19937& random) {
  for (int i = 0; i < per_side; ++i)
    for (int j = 0; j < per_side; ++j)
      for (int k = 0; k < per_side; ++k) {
        testing::BlockSpec block;
        block.tag = static_cast<int>(bed.size()) + 1;
        block.centre = corner + spacing * size * (Vec3(i, j, k) + 0.5 * Vec3::Ones());
        block.mass = 2700.0 * size * size * size;
        block.inertia = block.mass * size * size / 6.0 * Vec3::Ones();
        block.balls = cube(size, random);
        bed.push_back(block);
      }
}

}  // namespace

std::vector<testing::BlockSpec> graded_bed(double spacing) {
  std::mt19937 random(1);
  std::vector<testing::BlockSpec> bed;
  add_lattice(bed, 20, 0.1, spacing, Vec3(-2.2, -1.0, -1.0), random);
  add_lattice(bed, 10, 1.0, spacing, Vec3(0.0, -5.0, -5.0), random);
  return bed;
}

BedSpheres::BedSpheres(const std::vector<testing::BlockSpec>& blocks) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (const testing::Ball& ball : blocks[b].balls) {
      const Vec3 at = blocks[b].centre + ball.offset;
      positions_.insert(positions_.end(), at.data(), at.data() + 3);
      radii_.push_back(ball.radius);
      tags_.push_back(static_cast<int>(tags_.size()) + 1);
      blocks_.push_back(static_cast<int>(b));
    }
  }
}

SphereSet BedSpheres::view() const {
  const int count = static_cast<int>(radii_.size());
  return {positions_.data(), radii_.data(), tags_.data(), blocks_.data(), count, count};
}

}  // namespace muckpile::perf
