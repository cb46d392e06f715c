// SPDX-License-Identifier: GPL-2.0-or-later
// A charge on mirror planes in the engine: halves and quarters of one cut beside the whole.
// Scope: rock that is symmetric by its making; runs on any number of ranks.
#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "geometry/cut/tessellation.h"
#include "geometry/files/block_file.h"
#include "rock_scene.h"

namespace muckpile {
namespace {

using test::RockScene;

constexpr double kStep = 5e-6, kSide = 0.9;  // [s], of the rock's quarter [m]

/// The rock around a quarter of the charge.
std::vector<Block> quarter() {
  TessellationOptions options;
  options.lo = {0.0, 0.0, -kSide};
  options.hi = {kSide, kSide, kSide};
  options.holes = {{{0.0, 0.0, -0.4}, {0.0, 0.0, 0.4}, 0.15}};
  options.size = SizeLaw::uniform(0.26);
  options.seed = 3;
  options.sweeps = 10;
  return tessellate(options).blocks;
}

/// With the images in the plane through the origin at right angles to an axis.
std::vector<Block> with_images(std::vector<Block> blocks, int axis) {
  for (std::size_t b = 0, count = blocks.size(); b < count; ++b) {
    Block image = blocks[b];
    for (Vec3& vertex : image.shape.vertices) vertex[axis] *= -1.0;
    for (std::vector<int>& face : image.shape.faces) std::ranges::reverse(face);
    image.mass = mass_properties(image.shape);
    blocks.push_back(std::move(image));
  }
  return blocks;
}

/// A part of the blast: 1, 2 or 4 of its quarters.
struct Blast {
  RockScene scene;
  int quarters;

  Blast(int of_4, const std::string& joint, const std::string& load)
      : scene(MPI_COMM_WORLD, "-3 3 -3 3 -3 3", "* 1 1", "multisphere/muckpile"), quarters(of_4) {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    std::vector<Block> blocks = quarter();
    if (quarters > 1) blocks = with_images(std::move(blocks), 1);
    if (quarters > 2) blocks = with_images(std::move(blocks), 0);
    const std::string file = "mirrored_charge_" + std::to_string(quarters) + ".vtk";
    if (rank == 0) write_blocks(file, blocks, 1, 2700.0);
    MPI_Barrier(MPI_COMM_WORLD);
    scene.command("region at_x block -1e-6 1e-6 -3 3 -3 3 units box");
    scene.command("region at_y block -3 3 -1e-6 1e-6 -3 3 units box");
    scene.command("pair_style muckpile/block");
    scene.command("pair_coeff * *");
    const std::string side = " 0.9";
    scene.cut((quarters > 2 ? "-0.9" : "0") + side + (quarters > 1 ? " -0.9" : " 0") + side +
                  " -0.9" + side,
              "density 2700 size import " + file +
                  " block_min 0.01 block_max 1 spheres_per_block 3 hole 0 0 -0.4 0 0 0.4 0.15 "
                  "support mirror at_x support mirror at_y");
    scene.command(
        "fix joint all muckpile/joint youngs_modulus 55e9 poisson_ratio 0.25 density "
        "2700 friction_angle 50 " +
        joint);
    scene.command(
        "fix load all muckpile/blast explosive emulsion hole_diameter 0.1 poisson_ratio "
        "0.25 venting flow stemming_length 100 crack_delay 0 " +
        load);
    scene.command("fix gas all muckpile/gas");
    scene.command("fix energy all muckpile/ledger");
  }
  /// f_ID[n] of the whole blast, for what is extensive.
  [[nodiscard]] double whole(const std::string& fix, int n) const {
    return 4.0 / quarters * scene.output(fix, n);
  }
};

const std::string kStrong = "cohesion 1e12 tension 1e12";
const std::string kRock =
    "cohesion 20e6 tension 10e6 fracture_energy_tension 100 "
    "fracture_energy_shear 400";

TEST(MirroredCharge, TheElasticWaveIsThatOfTheWhole) {
  Blast whole(4, kStrong, "");
  whole.scene.run(60, kStep);
  const auto expected = whole.scene.blocks();
  for (const int quarters : {1, 2}) {
    Blast part(quarters, kStrong, "");
    part.scene.run(60, kStep);
    double worst = 0.0, fastest = 0.0;
    for (const auto& [tag, block] : part.scene.blocks()) {
      worst = std::max(worst, (block.velocity - expected.at(tag).velocity).norm());
      fastest = std::max(fastest, block.velocity.norm());
    }
    EXPECT_GT(fastest, 0.5);
    EXPECT_LT(worst, 6e-3 * fastest) << quarters;  // measured 0.0033 and 0.0019
    for (const int n : {3, 4, 9, 10}) {  // swept volume, work, energy and mass of the charge
      EXPECT_NEAR(part.whole("load", n) / whole.whole("load", n), 1.0, 1e-3) << quarters << n;
    }
    EXPECT_NEAR(part.scene.output("load", 2) / whole.scene.output("load", 2), 1.0, 1e-3);  // [Pa]
  }
}

TEST(MirroredCharge, GasDoesItsShareOfTheWork) {
  Blast whole(4, kRock, "crushed_friction 35");
  whole.scene.run(160, kStep);
  EXPECT_GT(whole.whole("gas", 2), 0.1);  // [kg]
  for (const int quarters : {1, 2}) {
    Blast part(quarters, kRock, "crushed_friction 35");
    part.scene.run(160, kStep);
    const auto ratio = [&](const char* fix, int n) {
      return part.whole(fix, n) / whole.whole(fix, n);
    };
    std::cout << quarters << " quarters: gas taken " << ratio("gas", 2) << ", its work "
              << ratio("gas", 4) << ", all work " << ratio("energy", 5) << " of the whole; ledger "
              << part.scene.output("energy", 0) << ", of the whole "
              << whole.scene.output("energy", 0) << '\n';
    // Joints that break a step apart make these differ.
    EXPECT_NEAR(ratio("gas", 2), 1.0, 0.02) << quarters;     // taken
    EXPECT_NEAR(ratio("gas", 4), 1.0, 0.02) << quarters;     // work
    EXPECT_NEAR(ratio("energy", 5), 1.0, 0.02) << quarters;  // of wave and gas
    EXPECT_LT(part.scene.output("energy", 0), 5e-3) << quarters;
    const double audit = part.scene.output("load", 22) / part.scene.output("load", 9);
    EXPECT_LT(std::abs(audit), 0.01) << quarters;
    // All of a charge is in its hole, in joints or in the air.
    const double left = part.scene.output("load", 11) * part.scene.output("load", 10);
    EXPECT_NEAR((left + part.scene.output("gas", 2)) / part.scene.output("load", 10), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace muckpile
