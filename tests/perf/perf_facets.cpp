// SPDX-License-Identifier: GPL-2.0-or-later
// perf_facets: time of one force computation of the facet network per integration point, on one
// core; prints JSON to standard output.
// Scope: core only, no communication: three passes over intact rock, without and with dashpots,
// over rock cut by leaning joint sets, over rock whose facets are all broken but closed, and over
// rock that has fallen apart; two over joints of Barton and Bandis, intact and broken but closed,
// and two over rock with half of its points broken, without and with decohesion, which are worked
// on one by one.
#include <nlohmann/json.hpp>

#include "bond/law/barton_bandis.h"
#include "bond_scene.h"
#include "measurement.h"
#include "timing.h"

namespace muckpile::perf {
namespace {

constexpr int kSteps = 200;
constexpr double kStep = 1e-6;  // [s]
constexpr double kStrain = 1e-4;
constexpr double kTarget = 8.0;  // per integration point [ns]

JointParameters rock_of(double strength, double damping = 0.0) {
  JointParameters rock = test::rock(0.25);
  rock.tension = rock.cohesion = strength;
  rock.residual_friction_angle = 0.6;
  rock.damping = damping;
  rock.contact_damping = 0.05;
  return rock;
}

test::BondScene cube(const std::vector<Block>& blocks, double strength, double damping = 0.0) {
  return {blocks, rock_of(strength, damping)};
}

/// The same cube with joints of Barton and Bandis between all blocks.
test::BondScene jointed_cube(const std::vector<Block>& blocks, double tension) {
  const BartonBandis law{.initial_stiffness = 1e10,
                         .closure_limit = 1e-4,
                         .roughness = 10.0,
                         .wall_strength = 1e8,
                         .residual_angle = 0.5,
                         .largest_angle = 1.2,
                         .tension = tension,
                         .initial_aperture = 2e-4};
  test::BondScene scene(blocks, rock_of(1e30), [](const Vec3&) { return Support::free; },
                        {{barton_bandis_class(law, 1e11)}, {}});
  FacetLists lists = scene.network().give_up();
  for (Facet& facet : lists.facets) facet.joint_class = 1;
  scene.network().set_facets(std::move(lists));
  return scene;
}

nlohmann::ordered_json time_of(test::BondScene& scene) {
  const double step = least_time([&] { scene.compute(kStep); }, kSteps);
  const auto facets = static_cast<double>(scene.network().facets().size());
  return {{"step_s", step}, {"ns_per_point", 1e9 * step / (facets * kFacetPoints)}};
}

double broken_points(const FacetTraces& traces) {
  double count = 0.0;
  for (std::size_t p = 0; p < kFacetPoints; ++p) count += traces.broken[p] ? 1.0 : 0.0;
  return count;
}

/// Rock whose blocks have turned by so much that half of the points of facets have broken, in most
/// facets some of the three, which soften where there is a fracture energy [J/m2].
nlohmann::ordered_json time_of_transition(const std::vector<Block>& blocks,
                                          double fracture_energy) {
  constexpr double kStrength = 1e6, kTurn = 4.5e-5;  // [Pa], [rad]
  JointParameters rock = rock_of(kStrength);
  rock.fracture_energy_tension = rock.fracture_energy_shear = fracture_energy;
  test::BondScene scene(blocks, rock);
  scene.shake(0.0, kTurn, 1);
  for (int k = 0; k < 3; ++k) scene.compute(kStep);
  nlohmann::ordered_json result = time_of(scene);
  const FacetNetwork& network = scene.network();
  double broken = 0.0, partly = 0.0, softening = 0.0;
  const std::size_t count = network.facet_count();
  for (std::size_t f = 0; f < count; ++f) {
    const double points = broken_points(network.history().traces(f));
    broken += points / kFacetPoints;
    partly += points > 0.0 && points < kFacetPoints ? 1.0 : 0.0;
    softening += network.history().softens(f) ? 1.0 : 0.0;
  }
  const auto facets = static_cast<double>(count);
  result["broken_share_of_points"] = broken / facets;
  result["partly_broken_share"] = partly / facets;
  result["softening_share"] = softening / facets;
  return result;
}

}  // namespace

nlohmann::ordered_json measure() {
  const std::vector<Block> blocks = test::voronoi_blocks(kCubeEdge, 1, kCubeSweeps);
  nlohmann::ordered_json result;
  result["what"] = "cube of Voronoi blocks, three points per facet";
  result["blocks"] = blocks.size();
  result["target_ns_per_point"] = kTarget;

  test::BondScene intact = cube(blocks, 1e30);
  result["facets"] = intact.network().facets().size();
  const double bytes = intact.network().memory_usage();
  result["bytes_per_block"] = bytes / static_cast<double>(blocks.size());
  result["bytes_per_facet"] = bytes / static_cast<double>(intact.network().facets().size());
  for (const FacetNetwork::TableSize& size : intact.network().table_sizes())
    result["bytes_per_block_by_table"][size.table] =
        size.bytes / static_cast<double>(blocks.size());
  intact.deform(-kStrain * Mat3::Identity());
  result["intact"] = time_of(intact);

  test::BondScene damped = cube(blocks, 1e30, 0.05);
  damped.deform(-kStrain * Mat3::Identity());
  result["intact_damped"] = time_of(damped);

  test::BondScene leaning = test::leaning_scene(kCubeEdge, rock_of(1e30));
  leaning.deform(-kStrain * Mat3::Identity());
  result["leaning"] = time_of(leaning);

  test::BondScene broken = cube(blocks, 0.0);
  broken.deform(kStrain * Mat3::Identity());
  broken.compute();
  broken.deform(-kStrain * Mat3::Identity());
  result["broken_closed"] = time_of(broken);
  result["broken_closed"]["broken_share"] =
      broken.network().broken_area(false) / broken.network().broken_area(true);

  broken.deform(0.05 * Mat3::Identity());
  result["open"] = time_of(broken);

  test::BondScene jointed = jointed_cube(blocks, 1e30);
  jointed.deform(-kStrain * Mat3::Identity());
  result["barton_bandis_intact"] = time_of(jointed);

  test::BondScene parted = jointed_cube(blocks, 0.0);
  parted.deform(kStrain * Mat3::Identity());
  parted.compute();
  parted.deform(-kStrain * Mat3::Identity());
  result["barton_bandis_closed"] = time_of(parted);
  result["partly_broken"] = time_of_transition(blocks, 0.0);
  result["softening"] = time_of_transition(blocks, 1e4);
  return result;
}

}  // namespace muckpile::perf
