// SPDX-License-Identifier: GPL-2.0-or-later
// Boxes of rock to verify on: uniform, graded and joint-set cuts, elastic constants, plain springs.
// Scope: see the header.
#include "framework/rock_samples.h"

#include "geometry/tessellation.h"

namespace muckpile::verification {

RockSample uniform_rock(const Vec3& box, unsigned long seed) {
  TessellationOptions options;
  options.hi = box;
  options.seed = seed;
  return {tessellate(options).blocks, box, 1.0};
}

RockSample graded_rock(const Vec3& box, unsigned long seed) {
  constexpr double kSmallest = 0.1, kLargest = 1.0, kReach = 5.0;  // [m]
  TessellationOptions options;
  options.hi = box;
  options.seed = seed;
  options.fine_axes = {{Vec3::Zero(), Vec3(0.0, 0.0, box.z())}};
  options.size = SizeLaw::table({{0.0, kSmallest}, {kReach, kLargest}}, {kSmallest, kLargest});
  return {tessellate(options).blocks, box, kLargest};
}

RockSample cuboid_rock(const Eigen::Vector3i& number, const Vec3& edge) {
  return {test::cuboids(number.x(), number.y(), number.z(), edge),
          number.cast<double>().cwiseProduct(edge), edge.maxCoeff()};
}

std::vector<JointParameters> plain_springs(double poisson_ratio) {
  const JointMaterial material(rock(poisson_ratio));
  JointParameters equal = rock(0.0),
                  normal = rock(0.0);  // at nu = 0 the network is springs: 2G = E
  equal.youngs_modulus = 2.0 * material.shear_modulus();
  if (poisson_ratio == 0.0) return {equal};
  normal.youngs_modulus = material.lame_lambda();
  normal.shear_stiffness = 1e-12 * normal.youngs_modulus;  // in series: no shear [Pa/m]
  return {equal, normal};
}

}  // namespace muckpile::verification
