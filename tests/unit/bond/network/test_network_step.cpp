// SPDX-License-Identifier: GPL-2.0-or-later
// A step of the facet network gets from other ranks what it needs, in the order in which it does.
// Scope: one rank, whose exchange looks at the values or changes them.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "bond_scene.h"

namespace muckpile {
namespace {

/// What a step of the scene has exchanged, in order; all of it of every block but the ground.
std::vector<std::string> exchanged(test::BondScene& scene) {
  FacetNetwork& network = scene.network();
  std::vector<std::string> order;
  network.step(0.0, {.fill_copies = [&](std::span<double> values, std::size_t width) {
                 EXPECT_EQ(values.size(), width * scene.size());
                 if (values.data() == network.theta().data()) {
                   order.emplace_back("theta");
                 } else if (values.data() == network.bulk_stress().data()) {
                   order.emplace_back("bulk stress");
                 } else {
                   order.push_back(std::to_string(width) + " numbers");
                 }
               }});
  return order;
}

TEST(NetworkStep, ExchangesDilatationsBeforeBulkStresses) {
  test::BondScene cuboids(test::cuboids(2, 2, 1), test::rock(0.25));
  EXPECT_EQ(exchanged(cuboids), (std::vector<std::string>{"theta", "bulk stress"}));
}

TEST(NetworkStep, ExchangesTensorsWhereAFacetOfAnyRankLeans) {
  test::BondScene cuboids(test::cuboids(2, 2, 1), test::rock(0.25));
  const std::vector<std::string> all = {"theta", "9 numbers", "9 numbers", "bulk stress"};
  FacetNetwork& network = cuboids.network();
  auto blocks = network.blocks();
  blocks.pop_back();  // the ground
  network.set(std::move(blocks), network.give_up(),
              {.sum = [](double mine) { return mine + 1.0; }});  // another rank's facet leans
  EXPECT_EQ(exchanged(cuboids), all);
  EXPECT_EQ(cuboids.network().leaning(), nullptr);
  test::BondScene leaning = test::leaning_scene(3.0, test::rock(0.25));
  EXPECT_EQ(exchanged(leaning), all);
  EXPECT_NE(leaning.network().leaning(), nullptr);
}

TEST(NetworkStep, BulkStressesAreThoseOfTheExchangedDilatations) {
  test::BondScene pair(test::cuboids(2, 1, 1), test::rock(0.25));
  FacetNetwork& network = pair.network();
  constexpr double kTheta = 1e-6;
  bool first = true;
  network.step(0.0, {.fill_copies = [&](std::span<double> values, std::size_t) {
                 if (std::exchange(first, false)) values[1] = kTheta;
               }});
  // p = lambda theta + D A h (theta - theta of the neighbour) / (V s), cubes of 1 m: A h/V = 1, and
  // s = 1 + phi lambda/(2G) with phi = 5 free faces x 1/2; lambda = G at this Poisson ratio.
  const JointMaterial& rock = network.material();
  const double lambda = rock.lame_lambda(), s = 1.0 + 2.5 * lambda / (2.0 * rock.shear_modulus());
  const double d = kSharpening * (2.0 * lambda + rock.shear_modulus()) / 6.0;
  EXPECT_NEAR(network.bulk_stress()[0] / (-d * kTheta / s), 1.0, 1e-12);
  EXPECT_NEAR(network.bulk_stress()[1] / (lambda * kTheta + d * kTheta / s), 1.0, 1e-12);
}

}  // namespace
}  // namespace muckpile
