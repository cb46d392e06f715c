// SPDX-License-Identifier: GPL-2.0-or-later
// perf_gas: time of one step of the gas in joints per joint, on one core; prints JSON to standard
// output.
// Scope: core only, no communication: rock whose joints are all broken and open, half of the blocks
// full of gas; what the blocks do with its pressure is not in it.
#include <nlohmann/json.hpp>
#include <vector>

#include "bond_scene.h"
#include "gas/joint_gas.h"
#include "measurement.h"
#include "timing.h"

namespace muckpile::perf {
namespace {

constexpr int kSteps = 100;
constexpr double kStep = 1e-8;     // so short that the gas stays where it is [s]
constexpr double kOpening = 1e-3;  // strain that opens the joints

JointParameters weak_rock() {
  JointParameters rock = test::rock(0.25);
  rock.tension = rock.cohesion = 0.0;
  return rock;
}

/// Two thirds of the pressure range apart, so that gas flows through most joints.
void fill(JointGas& gas) {
  constexpr double kDensity = 100.0, kEnergy = 5.9e5;  // [kg/m3], [J/kg]: 24 MPa
  for (std::size_t b = 0; b < gas.cells().size(); b += 2) {
    const double mass = kDensity * (1.0 + static_cast<double>(b % 7) / 7.0) * kOpening;
    gas.cells()[b].content = {mass, mass * kEnergy, 0.0, 0.0};
  }
}

}  // namespace

nlohmann::ordered_json measure() {
  test::BondScene scene(test::voronoi_blocks(kCubeEdge, 1, kCubeSweeps), weak_rock());
  FacetNetwork& network = scene.network();
  network.keep_gas_in_joints();
  scene.deform(kOpening * Mat3::Identity());
  scene.compute();
  JointGas gas({});
  gas.set_rooms(JointRooms(network));
  fill(gas);
  const auto nanoseconds = [&](const std::function<void()>& body) {
    return 1e9 * least_time(body, kSteps) / static_cast<double>(network.facet_count());
  };
  nlohmann::ordered_json result;
  result["what"] = "cube of Voronoi blocks, all joints broken, half of the blocks full of gas";
  result["target_ns_per_joint"] = 15.0;  // of measure()
  result["joints"] = network.facet_count();
  std::vector<LaneSet> joints;
  for (std::size_t f = 0; f < network.facet_count(); ++f) add_facet(joints, f);
  OpenJoints open;
  result["opening_of_joints"]["ns_per_joint"] =
      nanoseconds([&] { network.open_joints(joints, open); });
  result["measure"]["ns_per_joint"] = nanoseconds([&] { gas.measure(JointRooms(network), {}); });
  result["pressures"]["ns_per_joint"] = nanoseconds([&] { static_cast<void>(gas.press()); });
  result["flow"]["ns_per_joint"] = nanoseconds([&] { static_cast<void>(gas.flow({}, kStep)); });
  result["cool"]["ns_per_joint"] = nanoseconds([&] { gas.cool(kStep); });
  return result;
}

}  // namespace muckpile::perf
