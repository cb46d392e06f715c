// SPDX-License-Identifier: GPL-2.0-or-later
// Boxes of rock to verify on: uniform, graded and joint-set cuts, elastic constants, plain springs.
// Scope: see the header.
#include "framework/rock_samples.h"

#include <algorithm>
#include <numbers>

#include "bond/build/joint_plane.h"
#include "geometry/cut/joint_set_cut.h"
#include "geometry/cut/tessellation.h"

namespace muckpile::verification {

RockSample uniform_rock(const Vec3& box, unsigned long seed) {
  TessellationOptions options;
  options.hi = box;
  options.seed = seed;
  return {tessellate(options).blocks, box, 1.0};
}

RockSample uniform_rock(const Vec3& box, const std::vector<CutPlane>& planes) {
  TessellationOptions options;
  options.hi = box;
  options.planes = planes;
  return {tessellate(options).blocks, box, 1.0, Leaning::much};
}

RockSample graded_rock(const Vec3& box, const std::pair<Vec3, Vec3>& line, const SizeLaw& size,
                       unsigned long seed) {
  TessellationOptions options;
  options.hi = box;
  options.seed = seed;
  options.fine_axes = {line};
  options.size = size;
  return {tessellate(options).blocks, box, size.at(box.norm())};
}

namespace {

SizeLaw graded_sizes() {
  constexpr double kSmallest = 0.1, kLargest = 1.0, kReach = 5.0;  // [m]
  return SizeLaw::table({{0.0, kSmallest}, {kReach, kLargest}}, {kSmallest, kLargest});
}

}  // namespace

RockSample graded_rock(const Vec3& box, unsigned long seed) {
  return graded_rock(box, {Vec3::Zero(), Vec3(0.0, 0.0, box.z())}, graded_sizes(), seed);
}

RockSample banded_rock(const Vec3& box, const std::vector<Vec2>& sets, bool graded) {
  TessellationOptions options;
  options.hi = box;
  if (graded) {
    options.fine_axes = {{Vec3::Zero(), Vec3(0.0, 0.0, box.z())}};
    options.size = graded_sizes();
  }
  JointSetCut how;
  for (const Vec2& set : sets) {
    const Vec2 radians = set * std::numbers::pi / 180.0;
    how.sets.push_back({normal_of_dip(radians.x(), radians.y())});
  }
  return {cut_by_joint_sets(options, how).blocks, box, 1.0, Leaning::much};
}

RockSample cuboid_rock(const Eigen::Vector3i& number, const Vec3& edge) {
  return {test::cuboids(number.x(), number.y(), number.z(), edge),
          number.cast<double>().cwiseProduct(edge), edge.maxCoeff()};
}

RockSample with_mirror_image(const RockSample& sample) {
  const double wall = sample.box.x();
  const int count = static_cast<int>(sample.blocks.size());
  RockSample both = sample;
  both.box.x() = 2.0 * wall;
  for (std::size_t b = 0; b < sample.blocks.size(); ++b) {
    Block image = sample.blocks[b];
    for (Vec3& vertex : image.shape.vertices) vertex.x() = 2.0 * wall - vertex.x();
    for (std::vector<int>& face : image.shape.faces) std::reverse(face.begin(), face.end());
    image.mass = mass_properties(image.shape);
    for (std::size_t k = 0; k < image.neighbour.size(); ++k) {
      if (image.neighbour[k] >= 0) image.neighbour[k] += count;
      if (image.neighbour[k] != kFreeFace) continue;
      const FaceGeometry face = face_geometry(sample.blocks[b].shape, static_cast<int>(k));
      if (face.normal.x() < 0.5 || face.centroid.x() < wall - 1e-6 * sample.size) continue;
      image.neighbour[k] = static_cast<int>(b);
      both.blocks[b].neighbour[k] = count + static_cast<int>(b);
    }
    both.blocks.push_back(image);
  }
  return both;
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
