// SPDX-License-Identifier: GPL-2.0-or-later
// The load that a hole's pressure puts on the blocks around it: p times the true area, no net
// force. Scope: the pressure laws together with the facet network, without the engine.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bond/network/facet_network.h"
#include "explosive/blast_load.h"

namespace muckpile {
namespace {

constexpr int kSides = 14;
constexpr double kRadius = 0.135;  // [m]
constexpr double kLength = 2.0;    // [m]
constexpr double kDepth = 0.3;     // radial size of a block [m]

double angle_of(int side) { return 2.0 * std::numbers::pi * (side + 0.5) / kSides; }
double side_width() { return 2.0 * kRadius * std::sin(std::numbers::pi / kSides); }
double apothem() { return kRadius * std::cos(std::numbers::pi / kSides); }

/// A closed ring of free blocks around a hole along z, one flat face each on the hole. The blocks
/// are turned by `turn` about z from their start orientation, as a normal that did not turn along
/// would show.
FacetNetwork ring(double turn) {
  FacetNetwork network(JointMaterial({.youngs_modulus = 50e9,
                                      .poisson_ratio = 0.25,
                                      .density = 2700.0,
                                      .tension = 1e6,
                                      .cohesion = 1e6}));
  std::vector<BlockConstants> blocks;
  std::vector<BoundaryFace> faces;
  for (int i = 0; i < kSides; ++i) {
    const double volume = side_width() * kLength * kDepth;
    blocks.push_back({.tag = i + 1, .volume = volume, .mass = 2700.0 * volume});
    const Vec3 outward(std::cos(angle_of(i)), std::sin(angle_of(i)), 0.0);  // from the hole
    BoundaryFace face;
    face.tag = i + 1;
    face.block = i;
    face.hole = 0;
    face.normal = -outward;
    face.arm = -0.5 * kDepth * outward;
    face.start = apothem() * outward;
    face.area = side_width() * kLength;
    faces.push_back(face);
  }
  network.set(blocks, {{}, {}, faces});
  const Mat3 rotation = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
  for (int i = 0; i < kSides; ++i) {
    const Vec3 outward(std::cos(angle_of(i)), std::sin(angle_of(i)), 0.0);
    network.state()[static_cast<std::size_t>(i)] = {
        .rotation = rotation,
        .centre = rotation * ((apothem() + 0.5 * kDepth) * outward),
        .velocity = Vec3::Zero(),
        .spin = Vec3::Zero()};
  }
  return network;
}

double load_ring(FacetNetwork& network) {
  const BlastLoad load({.wave_peak = 227e6,
                        .pulse = {.rise_time = 1e-4},
                        .charge_volume = 0.01,
                        .vent_time = 0.0,
                        .vent_decay = 1.0});
  const double pressure = load.pressure(0.7e-4, 0.0);
  for (BoundaryFace& face : network.faces()) face.pressure = pressure;
  network.step(1e-6);
  return pressure;
}

constexpr double kRounding = 1e-14;  // of some 14 products and sums

TEST(WallResultant, EachFaceCarriesPressureTimesItsTrueArea) {
  FacetNetwork network = ring(0.4);
  const double pressure = load_ring(network);
  double sum = 0.0;
  for (const Vec3& force : network.force()) sum += force.norm();
  const double area = kSides * side_width() * kLength;
  EXPECT_NEAR(sum / (pressure * area), 1.0, kRounding);
}

TEST(WallResultant, AClosedRingFeelsNoNetForceAndNoNetTorque) {
  FacetNetwork network = ring(0.4);
  const double pressure = load_ring(network);
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (std::size_t i = 0; i < network.force().size(); ++i) {
    force += network.force()[i];
    torque += network.torque()[i] + network.state()[i].centre.cross(network.force()[i]);
  }
  const double scale = pressure * kSides * side_width() * kLength;
  EXPECT_LT(force.norm(), kRounding * scale);
  EXPECT_LT(torque.norm(), kRounding * scale * (apothem() + kDepth));
}

TEST(WallResultant, HalfTheRingIsPushedByPressureTimesTheChord) {
  FacetNetwork network = ring(0.0);
  const double pressure = load_ring(network);
  Vec3 force = Vec3::Zero();
  for (int i = 0; i < kSides / 2; ++i) force += network.force()[static_cast<std::size_t>(i)];
  // 14 sides from angle 0: the upper seven end on the chord of length 2 r along x
  EXPECT_NEAR(force.y() / (pressure * 2.0 * kRadius * kLength), 1.0, kRounding);
  EXPECT_LT(std::abs(force.x()), kRounding * force.y());
}

}  // namespace
}  // namespace muckpile
