// SPDX-License-Identifier: GPL-2.0-or-later
// create_blocks in the engine: the same blocks on any number of ranks, exact bodies, numbering.
// Scope: some dozen blocks; run with mpirun -np 1, 2 and 4.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/cut/tessellation.h"
#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

const std::string kBox = "-3 3 -2 2 -2 2";
const std::string kRock = "-2 2 -1 1 -1 1";
const std::string kCut =
    "density 2700 size power 0.8 1 block_min 0.3 block_max 0.6 hole 0 0 -0.5 0 0 0.6 0.2 seed 7 "
    "sweeps 5 "
    "spheres_per_block 5 ";

/// Lines in alphabetic order: rows of a snapshot come in any order.
std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) all.push_back(line);
  std::sort(all.begin(), all.end());
  return all;
}

/// The id of a run tells its ranks.
std::string without_run_id(const std::string& text) {
  return std::regex_replace(text, std::regex(" run=[0-9a-f]{16}"), "");
}

/// Blocks file and first snapshot of the scene on the ranks of `comm`.
std::pair<std::string, std::string> files(MPI_Comm comm, const std::filesystem::path& into,
                                          const std::string& more = "",
                                          const std::string& zone = "") {
  RockScene scene(comm, kBox, "* * 1");
  scene.cut(kRock, kCut + more + "file " + (into / "blocks.vtk").string());
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 5e10 poisson_ratio 0.25 density 2700 cohesion "
      "4e6 "
      "friction_angle 50 tension 2e6" +
      zone);
  scene.command("fix snapshots all muckpile/dump every 100 directory " + into.string());
  scene.run(0, 1e-6);
  MPI_Barrier(comm);
  return {without_run_id(content(into / "blocks.vtk")),
          without_run_id(content(into / "blocks_000000000.csv"))};
}

TEST(CreateBlocks, MakesTheSameBlocksOnAnyNumberOfRanks) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const ScratchFolder base("create_blocks");
  const auto [alone_vtk, alone_csv] = files(MPI_COMM_SELF, base / ("alone" + std::to_string(rank)));
  const auto [shared_vtk, shared_csv] = files(MPI_COMM_WORLD, base / "shared");
  ASSERT_GT(alone_vtk.size(), 10000u);
  ASSERT_GT(lines(alone_csv).size(), 50u);
  EXPECT_EQ(alone_vtk, shared_vtk);
  EXPECT_EQ(lines(alone_csv), lines(shared_csv));
}

TEST(CreateBlocks, MakesTheSameBlocksBesideAJointOnAnyNumberOfRanks) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const ScratchFolder base("create_blocks_joint");
  const std::string joint = "joint_plane 1 0 0 80 90 0 ";
  const auto alone = files(MPI_COMM_SELF, base / ("alone" + std::to_string(rank)), joint);
  const auto shared = files(MPI_COMM_WORLD, base / "shared", joint);
  ASSERT_GT(alone.first.size(), 10000u);
  EXPECT_EQ(alone.first, shared.first);
}

TEST(CreateBlocks, MakesTheSameBlocksBetweenSetsOfNaturalJointsOnAnyNumberOfRanks) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const ScratchFolder base("create_blocks_sets");
  const std::string sets =
      "natural_joints 80 90 1 0 fisher 60 natural_joints 20 200 0.8 0 persistence 0.5 0.6 ";
  const auto alone = files(MPI_COMM_SELF, base / ("alone" + std::to_string(rank)), sets);
  const auto shared = files(MPI_COMM_WORLD, base / "shared", sets);
  ASSERT_GT(alone.first.size(), 10000u);
  EXPECT_EQ(alone.first, shared.first);
}

TEST(CreateBlocks, MakesTheSameBlocksInZonesOfOtherSizeOnAnyNumberOfRanks) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const ScratchFolder base("create_blocks_zone_sizes");
  const std::string zones =
      "zone cap 2300 above 0 0 0.4 10 90 size_factor 0.7 zone end 2300 below -1.2 0 0 90 90 "
      "size_factor 0.8 ";
  const std::string words = " zone cap youngs_modulus 4e10 zone end youngs_modulus 4e10";
  const auto alone = files(MPI_COMM_SELF, base / ("alone" + std::to_string(rank)), zones, words);
  const auto shared = files(MPI_COMM_WORLD, base / "shared", zones, words);
  ASSERT_GT(alone.first.size(), 10000u);
  EXPECT_EQ(alone.first, shared.first);
}

/// The rock of kCut, cut without the engine.
Tessellation rock() {
  TessellationOptions options;
  options.lo = {-2, -1, -1};
  options.hi = {2, 1, 1};
  options.holes = {{{0, 0, -0.5}, {0, 0, 0.6}, 0.2}};
  options.size = SizeLaw::power({0.8, 1.0}, {0.3, 0.6});
  options.seed = 7;
  options.sweeps = 5;
  return tessellate(options);
}

TEST(CreateBlocks, BodiesHaveTheMassPropertiesOfTheirPolyhedra) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  scene.cut(kRock, kCut);
  const Tessellation cut = rock();
  const auto bodies = scene.blocks();
  ASSERT_EQ(bodies.size(), cut.blocks.size());
  EXPECT_EQ(scene.spheres(), 5.0 * static_cast<double>(cut.blocks.size()));
  for (const auto& [tag, body] : bodies) {
    const MassProperties& exact = cut.blocks.at(static_cast<std::size_t>(tag - 1)).mass;
    EXPECT_NEAR(body.mass / (2700.0 * exact.volume), 1.0, 1e-12) << tag;  // rounding
    EXPECT_LT((body.centre - exact.centroid).norm(), 1e-12) << tag;
    EXPECT_LT((body.inertia / 2700.0 - exact.inertia).norm(), 1e-12 * exact.inertia.norm()) << tag;
    EXPECT_EQ(body.velocity.norm(), 0.0);
  }
}

TEST(CreateBlocks, FreeBodyTurnsAsItsInertiaSays) {
  // Euler's equations of a block without forces, by fourth-order Runge-Kutta: if the engine had the
  // spheres' inertia instead of the polyhedron's, the spin would take another path.
  RockScene scene(MPI_COMM_WORLD, kBox);
  scene.cut(kRock, kCut);
  const Vec3 spin(3, 40, 5);
  scene.command("pair_style none");
  scene.set_motion([&](int, const Vec3&) { return Motion{Vec3::Zero(), spin}; });
  const auto start = scene.blocks();
  scene.run(2000, 2e-5);
  double changed = 0.0;
  for (const auto& [tag, now] : scene.blocks()) {
    const Mat3& inertia = start.at(tag).inertia;
    Vec3 w = spin;  // in the body's frame
    Mat3 r = Mat3::Identity();
    const auto slope = [&](const Vec3& at) {
      return Vec3(inertia.inverse() * (inertia * at).cross(at));
    };
    constexpr double h = 2e-5;
    for (int k = 0; k < 2000; ++k) {
      const Vec3 a = slope(w), b = slope(w + 0.5 * h * a), c = slope(w + 0.5 * h * b),
                 d = slope(w + h * c);
      const Vec3 middle = w + 0.5 * h * b, angle = h * middle;
      r = r * Mat3(Eigen::AngleAxisd(angle.norm(), angle.normalized()));
      w += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    changed = std::max(changed, (now.spin - spin).norm());
    EXPECT_LT((now.spin - r * w).norm(), 1e-3 * spin.norm())
        << tag;  // both second order in 8e-4 rad
    EXPECT_LT((now.angular_momentum - start.at(tag).angular_momentum).norm(),
              1e-12 * now.angular_momentum.norm());
  }
  EXPECT_GT(changed, 1.0);
}

TEST(CreateBlocks, SecondRockIsNumberedAfterTheFirst) {
  RockScene scene(MPI_COMM_WORLD, kBox);
  scene.cut("-2 -1 -1 1 -1 1",
            "density 2700 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 2");
  const auto first = scene.blocks();
  scene.command("region more block 1 2 -1 1 -1 1 units box");
  scene.command(
      "create_blocks more density 3000 size uniform 0.5 block_min 0.5 block_max 0.5 "
      "spheres_per_block 2");
  const auto both = scene.blocks();
  ASSERT_GT(both.size(), first.size());
  double mass = 0.0;
  int tag = 0;
  for (const auto& [id, body] : both) {
    EXPECT_EQ(id, ++tag);
    EXPECT_EQ(body.centre.x() > 0.0, id > static_cast<int>(first.size()));
    mass += body.mass;
  }
  EXPECT_NEAR(mass / (4.0 * 2700.0 + 4.0 * 3000.0), 1.0, 1e-9);  // blocks fill the volume to 1e-9
  EXPECT_EQ(scene.spheres(), 2.0 * static_cast<double>(both.size()));
}

}  // namespace
}  // namespace muckpile::test
