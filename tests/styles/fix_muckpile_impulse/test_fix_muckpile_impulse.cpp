// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/impulse: a lump of rock that a charge breaks in the air. Its impulses are the
// momenta of its blocks; forces of joints and of gas in them cancel; the wave's is that of its
// pulse. Scope: read from the files of fix muckpile/dump.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>

#include "args/csv_table.h"
#include "motion/impulse_sums.h"
#include "provenance/run_files.h"
#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr double kStep = 5e-6;  // [s]

std::map<int, ByPart> impulses_in(const std::filesystem::path& file) {
  const CsvTable table = CsvTable::read(file);
  std::map<int, ByPart> blocks;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    ByPart& of = blocks[table.whole(row, table.column("id"))];
    for (std::size_t k = 0; k < kImpulseParts; ++k) {
      const std::string name(kImpulseNames[k]);
      of.parts[k] = {table.number(row, table.column(name + "_x_N_s")),
                     table.number(row, table.column(name + "_y_N_s")),
                     table.number(row, table.column(name + "_z_N_s"))};
    }
  }
  return blocks;
}

/// A cube without supports around an upright charge, under gravity, that moves off as it starts.
void make_lump(RockScene& scene, const std::filesystem::path& folder, const std::string& joint,
               const std::string& load) {
  scene.command("pair_style muckpile/block");
  scene.command("pair_coeff * *");
  scene.cut("-0.9 0.9 -0.9 0.9 -0.9 0.9",
            "density 2700 size uniform 0.3 block_min 0.2 block_max 0.5 spheres_per_block 3 seed 3 "
            "hole 0 0 -0.4 0 0 0.4 0.15");
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 55e9 poisson_ratio 0.25 density 2700 "
      "friction_angle 50 " +
      joint);
  scene.command(
      "fix load all muckpile/blast explosive emulsion hole_diameter 0.1 poisson_ratio 0.25 " +
      load);
  scene.command("fix impulses all muckpile/impulse");
  scene.command("fix pull all gravity 9.81 vector 0 0 -1");
  scene.command("fix snapshots all muckpile/dump every 1000000 directory " + folder.string());
}

/// Of all blocks: the vector sum, and the sum of magnitudes [N s].
struct Total {
  Vec3 sum = Vec3::Zero();
  double size = 0.0;
};
Total total(const std::map<int, ByPart>& blocks, ImpulsePart part) {
  Total total;
  for (const auto& [tag, of] : blocks) {
    total.sum += of[part];
    total.size += of[part].norm();
  }
  return total;
}

/// Two runs with steps of two lengths; joints break, gas enters them, blocks fly at a floor.
TEST(FixMuckpileImpulse, AddsUpToTheMomentumOfEachBlock) {
  constexpr double kRounding = 1e-8;  // files have ten digits
  const ScratchFolder folder("impulse_lump");
  RockScene scene(MPI_COMM_WORLD, "-9 9 -9 9 -9 9", "* 1 1", "multisphere/muckpile");
  make_lump(scene, folder / "",
            "cohesion 20e6 tension 10e6 fracture_energy_tension 100 fracture_energy_shear 400",
            "venting flow stemming_length 100 crack_delay 0");
  scene.command("fix gas all muckpile/gas");
  scene.command("fix floor all muckpile/wall plane 0 0 -1 0 0 1");
  scene.set_motion([](int, const Vec3&) { return Motion{Vec3(3.0, 1.0, 0.0), Vec3::Zero()}; });
  scene.run(400, kStep);
  scene.run(600, 2.0 * kStep);
  const auto blocks = impulses_in(folder / impulses_name(1000));
  ASSERT_EQ(blocks.size(), scene.blocks().size());
  double worst = 0.0;
  for (const auto& [tag, now] : scene.blocks()) {
    const ByPart& of = blocks.at(tag);
    double size = 0.0;
    for (const Vec3& part : of.parts) size += part.norm();
    worst = std::max(worst, (now.mass * now.velocity - of.sum()).norm() / size);
    EXPECT_NEAR(of[ImpulsePart::weight].z() / (-9.81 * 8e-3 * now.mass), 1.0, kRounding);
    EXPECT_NEAR(of[ImpulsePart::before].x() / (3.0 * now.mass), 1.0, kRounding);
  }
  std::cout << "left, of the sum of all impulses of its block: " << worst << '\n';
  EXPECT_LT(worst, kRounding);
  for (const ImpulsePart part : {ImpulsePart::joint_gas, ImpulsePart::joints}) {
    const Total of = total(blocks, part);
    std::cout << kImpulseNames[static_cast<std::size_t>(part)] << ": " << of.size
              << " N s, of which the vector sum leaves " << of.sum.norm() / of.size << '\n';
    EXPECT_GT(of.size, 100.0);
    EXPECT_LT(of.sum.norm(), kRounding * of.size);
  }
  EXPECT_GT(total(blocks, ImpulsePart::hole_gas).size, 1000.0);
  EXPECT_GT(total(blocks, ImpulsePart::contacts).sum.z(), 1000.0);  // the floor's
}

/// A triangle of 100 MPa over 0.4 ms on the wall of a cylinder, whose blocks make a prism of six
/// sides of the same volume: all of it is the wave's, and it is the pulse times the area.
TEST(FixMuckpileImpulse, TheWaveGivesItsPulseTimesTheWall) {
  constexpr double kPeak = 100e6, kEnd = 4e-4;     // [Pa], [s]
  constexpr double kRadius = 0.15, kLength = 0.8;  // of the crushed zone [m]
  const ScratchFolder folder("impulse_wave");
  RockScene scene(MPI_COMM_WORLD, "-9 9 -9 9 -9 9", "* 1 1", "multisphere/muckpile");
  make_lump(scene, folder / "", "cohesion 1e12 tension 1e12 contact_check no",
            "gas no peak_pressure 100e6 pulse_shape triangular rise_time 1e-4 pulse_end 4e-4");
  scene.run(200, kStep);
  const auto blocks = impulses_in(folder / impulses_name(200));
  double outward = 0.0;  // along the level direction of each push
  for (const auto& [tag, of] : blocks) outward += of[ImpulsePart::wave].head<2>().norm();
  const double side = kRadius * std::sqrt(2.0 * M_PI / (3.0 * std::sqrt(3.0)));  // [m]
  const double expected = 0.5 * kPeak * kEnd * 6.0 * side * kLength;
  std::cout << "the wave's over pulse times wall: " << outward / expected << '\n';
  EXPECT_NEAR(outward / expected, 1.0, 1e-3);
  EXPECT_EQ(total(blocks, ImpulsePart::hole_gas).size, 0.0);
  EXPECT_EQ(total(blocks, ImpulsePart::joint_gas).size, 0.0);
}

}  // namespace
}  // namespace muckpile::test
