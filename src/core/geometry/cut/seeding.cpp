// SPDX-License-Identifier: GPL-2.0-or-later
// Random seeds whose number density is 1 / size^3, by halving the box down to the local size.
// Scope: rounding the running sum of the density along the tree walk (systematic sampling) keeps
// the total within one of the integral and the density even on every scale above a block.
#include "geometry/cut/seeding.h"

#include <cmath>

#include "math/random.h"

namespace muckpile {
namespace {

constexpr int kTries = 64;  // to hit rock in a leaf that the surface cuts

struct Cuboid {
  Vec3 lo, hi;
  [[nodiscard]] Vec3 centre() const { return 0.5 * (lo + hi); }
  [[nodiscard]] Vec3 at(double u, double v, double w) const {
    return lo + Vec3(u, v, w).cwiseProduct(hi - lo);
  }
};

// Expected number of seeds in a leaf: mean of 1 / size^3 over eight points, rock only.
double leaf_count(const Cuboid& leaf, const Ground& ground) {
  const double part = (leaf.hi - leaf.lo).prod() / 8.0;
  double count = 0.0;
  for (int k = 0; k < 8; ++k) {
    const Vec3 p = leaf.at((k & 1) ? 0.75 : 0.25, (k & 2) ? 0.75 : 0.25, (k & 4) ? 0.75 : 0.25);
    if (ground.is_rock(p)) count += part / std::pow(ground.size(p), 3);
  }
  return count;
}

// Calls visit(leaf) for cuboids no longer than the smallest block in them; visit says whether to
// go on. Returns false once visit has.
template <class Visitor>
bool walk_leaves(const Cuboid& cuboid, const Ground& ground, const Visitor& visit) {
  const Vec3 edge = cuboid.hi - cuboid.lo;
  Eigen::Index longest = 0;
  const double length = edge.maxCoeff(&longest);
  if (length <= ground.smallest_size_near(cuboid.centre(), 0.5 * edge.norm())) {
    return visit(cuboid);
  }
  Cuboid lower = cuboid, upper = cuboid;
  lower.hi[longest] = upper.lo[longest] = cuboid.centre()[longest];
  return walk_leaves(lower, ground, visit) && walk_leaves(upper, ground, visit);
}

}  // namespace

double integrate_density(const TessellationOptions& options, const Ground& ground, double give_up) {
  double sum = 0.0;
  walk_leaves({options.lo, options.hi}, ground, [&](const Cuboid& leaf) {
    sum += leaf_count(leaf, ground);
    return sum <= give_up;
  });
  return sum;
}

std::vector<Vec3> scatter_seeds(const TessellationOptions& options, const Ground& ground) {
  std::vector<Vec3> seeds;
  Random random(options.seed);
  double sum = random.uniform();
  walk_leaves({options.lo, options.hi}, ground, [&](const Cuboid& leaf) {
    const double before = std::floor(sum);
    sum += leaf_count(leaf, ground);
    for (double k = before; k < std::floor(sum); ++k) {
      for (int tries = 0; tries < kTries; ++tries) {
        const double u = random.uniform(), v = random.uniform(), w = random.uniform();
        if (!ground.is_rock(leaf.at(u, v, w))) continue;
        seeds.push_back(leaf.at(u, v, w));
        break;
      }
    }
    return true;
  });
  return seeds;
}

}  // namespace muckpile
