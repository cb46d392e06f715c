// SPDX-License-Identifier: GPL-2.0-or-later
// The rigid body of a block.
// Scope: see the header.
#include "bond/build/rigid_body.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace muckpile {

RigidBody rigid_body(const Block& block, double density, const SphereRule& spheres) {
  RigidBody body;
  body.volume = block.mass.volume;
  body.mass = density * block.mass.volume;
  body.centre = block.mass.centroid;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(density * block.mass.inertia);
  body.inertia = solver.eigenvalues();
  body.axes = solver.eigenvectors();
  if (body.axes.determinant() < 0.0) body.axes.col(2) *= -1.0;
  body.spheres = contact_spheres(block.shape, block.mass.centroid, spheres);
  return body;
}

double largest_overlap(const std::vector<Block>& blocks, const std::vector<RigidBody>& bodies) {
  double largest = 0.0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (int other : blocks[b].neighbour) {
      if (other <= static_cast<int>(b)) continue;
      for (const Sphere& one : bodies[b].spheres) {
        for (const Sphere& two : bodies[static_cast<std::size_t>(other)].spheres) {
          const double overlap = one.radius + two.radius - (one.centre - two.centre).norm();
          largest = std::max(largest, overlap / std::min(one.radius, two.radius));
        }
      }
    }
  }
  return largest;
}

}  // namespace muckpile
