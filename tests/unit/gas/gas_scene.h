// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks apart at every joint, and the gas between them, without the engine.
// Scope: tests only; blocks stay where the test puts them.
#pragma once

#include <cmath>
#include <vector>

#include "../bond/bond_scene.h"
#include "gas/joint_gas.h"

namespace muckpile::test {

inline constexpr double kGamma = 1.4, kEntropy = 37900.0;  // p = K rho^gamma of the emulsion
inline constexpr double kGasConstant = 370.0;              // [J/(kg K)]
inline constexpr double kOpening = 1e-3;                   // of every joint [m]

inline double density_at(double pressure) { return std::pow(pressure / kEntropy, 1.0 / kGamma); }
inline double pressure_at(double density) { return kEntropy * std::pow(density, kGamma); }
/// Energy of a mass at a pressure and density [J].
inline double energy_of(double mass, double pressure, double density) {
  return mass * pressure / density / (kGamma - 1.0);
}
inline GasChamber chamber_of(double pressure, double mass) {
  const double density = density_at(pressure);
  return {{pressure, density}, mass, kGamma / (kGamma - 1.0) * pressure / density};
}

inline JointParameters weak() {
  JointParameters p = rock(0.0);
  p.tension = p.cohesion = 1e5;
  p.contact_damping = 0.0;
  return p;
}

inline void press(JointGas& gas, FacetNetwork& network) { network.set_gas_pressure(gas.press()); }

/// Opens the wide joints of both; returns what was let into the atmosphere [kg].
inline double open_wide(JointGas& gas, FacetNetwork& network) {
  const JointGas::Opened opened = gas.open_wide();
  for (const std::uint32_t joint : opened.joints) network.release_gas(joint);
  return opened.vented.mass;
}

/// Blocks apart at every joint, and the gas between them.
struct GasScene {
  BondScene scene;
  JointGas gas;
  std::vector<char> fed;
  std::vector<GasChamber> chambers;
  double vented = 0.0;
  std::vector<GasFlow> taken;

  GasScene(const std::vector<Block>& blocks, const JointGas::Parameters& parameters,
           std::size_t holes = 0, const Mat3& apart = Mat3::Identity())
      : scene(blocks, weak()), gas(parameters), fed(holes, 1), chambers(holes), taken(holes) {
    scene.network().keep_gas_in_joints();
    scene.deform(kOpening * apart);  // every joint breaks: its gap counts from here
    scene.compute();
    scene.deform(2.0 * kOpening * apart);
    gas.set_rooms(JointRooms(scene.network()));
  }
  /// Of the temperature that a pressure has on the isentrope, whatever room it has.
  void fill(std::size_t b, double mass, double pressure = 100e6) {
    GasContent& content = gas.cells()[b].content;
    content.mass = mass;
    content.energy = energy_of(mass, pressure, density_at(pressure));
  }
  /// Blocks in the pose of `opening` at every joint, in which the gas has its room, and presses.
  void open(double opening, const Mat3& apart = Mat3::Identity()) {
    scene.deform(opening * apart);
    scene.compute();
    gas.measure(JointRooms(scene.network()), fed);
    press(gas, scene.network());
  }
  double energy() { return gas.contained().energy; }
  double pressure(std::size_t b) { return gas.pressure(gas.cells()[b]); }
  void step(double dt) {
    gas.measure(JointRooms(scene.network()), fed);
    press(gas, scene.network());
    for (std::size_t h = 0; h < chambers.size(); ++h) chambers[h].ways = gas.chamber_ways()[h];
    const JointGas::Flows flows = gas.flow(chambers, dt);
    gas.cool(dt);
    vented += flows.vented.mass + open_wide(gas, scene.network());
    for (std::size_t h = 0; h < taken.size(); ++h) taken[h] += flows.from_hole[h];
  }
  double mass(std::size_t b) { return gas.cells()[b].content.mass; }
};

inline JointGas::Parameters
closed() {  // nothing to the atmosphere, whatever surface the blocks have
  return {.flow = {.gamma = kGamma, .roughness = 1e-4},
          .heat = {.effusivity = 0.0},
          .gas_constant = kGasConstant,
          .joint = {.residual_aperture = 1e-4},
          .ambient = 0.0};
}

/// The blocks of a test row lie free in space: without this their joints would end on a surface.
inline void seal(JointGas& gas) {
  for (int& code : gas.touches()) code = 0;
}

}  // namespace muckpile::test
