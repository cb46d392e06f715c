// SPDX-License-Identifier: GPL-2.0-or-later
// perf_polyhedra: time of one look at a pair of blocks that touch in their own shape, on one core;
// prints JSON to standard output.
// Scope: core only: Voronoi blocks, turned at random, pressed onto each other by a hundredth of
// their size, and the same as far apart; lists of pairs are not in it.
#include <nlohmann/json.hpp>
#include <random>
#include <utility>
#include <vector>

#include "bond_scene.h"
#include "contact/polyhedra/solid_contact.h"
#include "measurement.h"
#include "timing.h"
#include "tumbling_solids.h"

namespace muckpile::perf {
namespace {

constexpr int kPairs = 2000;
constexpr double kStrain = 0.01;  // of the pressed blocks [-]
constexpr double kTimeStep = 1e-4;

struct Touch {
  SolidBody first, second;
  Vec3 out;   ///< of the second, along which it has come
  Vec3 axis;  ///< that the last look has found
  bool lasts;
  ContactState state;
};

std::vector<Solid> shapes() {
  std::vector<Solid> solids;
  for (const Block& block : test::voronoi_blocks(0.5 * kCubeEdge, 1, kCubeSweeps))
    solids.emplace_back(block.shape, Pose{block.mass.centroid, Mat3::Identity()});
  return solids;
}

/// The second comes along a random direction until the pair is pressed so much.
Touch press(const Solid& first, const Solid& second, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Mat3 one = test::random_turn(random), two = test::random_turn(random);
  const Vec3 out = Vec3(normal(random), normal(random), normal(random)).normalized();
  OverlapFinder finder;
  const Mat3 back = one.transpose();
  double near = 0.0, far = first.radius() + second.radius();
  while (far - near > 1e-6 * far) {
    const double middle = 0.5 * (far + near);
    finder.place(first, second, back * two, middle * (back * out), 1.0);
    Vec3 n = back * out;
    (void)finder.work(n);
    (finder.overlap().largest_strain > kStrain ? near : far) = middle;
  }
  return {{&first, {Vec3::Zero(), one}, Vec3::Zero(), Vec3::Zero(), 1.0},
          {&second, {near * out, two}, Vec3::Zero(), Vec3::Zero(), 1.0},
          out,
          Vec3::Zero(),
          true,
          {}};
}

}  // namespace

nlohmann::ordered_json measure() {
  const std::vector<Solid> solids = shapes();
  std::mt19937 random(1);
  std::vector<Touch> pairs;
  for (std::size_t k = 0; k < kPairs; ++k)
    pairs.push_back(press(solids[k % solids.size()], solids[(7 * k + 3) % solids.size()], random));
  const SolidContactLaw law({});
  SolidContact contact;
  int touching = 0;
  const auto look = [&] {
    touching = 0;
    for (Touch& pair : pairs) {
      SolidResponse response;
      pair.lasts = contact
                       .step(law, pair.first, pair.second, kTimeStep, kTimeStep, !pair.lasts,
                             pair.axis, pair.state, response)
                       .lasts;
      touching += pair.lasts ? 1 : 0;
    }
  };
  nlohmann::ordered_json result;
  result["what"] = "pairs of Voronoi blocks in their own shape";
  result["pairs"] = kPairs;
  look();
  result["touching"]["ns_per_pair"] = 1e9 * least_time(look) / kPairs;
  result["touching"]["pairs_touching"] = touching;
  for (Touch& pair : pairs) pair.second.pose.centre += 2.0 * kStrain * pair.out;
  look();
  result["near"]["ns_per_pair"] = 1e9 * least_time(look) / kPairs;
  result["near"]["pairs_touching"] = touching;
  return result;
}

}  // namespace muckpile::perf
