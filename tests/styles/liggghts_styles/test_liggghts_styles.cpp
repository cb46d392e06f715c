// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS' own commands act on our blocks: fix gravity, fix wall/gran (plane and mesh), region,
// variable, if, dump.
// Scope: one block on a wall, and some dozen blocks in flight.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr double kGravity = 9.81, kDensity = 2600.0;  // [m/s2], [kg/m3]
constexpr double kModulus = 1e7, kPoisson = 0.25;     // of the contact with the wall [Pa], [-]
constexpr double kSide = 0.5, kBottom = 0.3, kStep = 1e-4;  // of the block [m], [m], [s]

struct WallCase {
  const char* name;
  bool mesh;
  double growth;
};

/// The plane z = 0 as two triangles; the block lies within one of them.
void write_plane(const std::filesystem::path& path) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    std::ofstream(path) << "solid plane\n"
                           "facet normal 0 0 1\nouter loop\nvertex -1.9 -1.9 0\nvertex 1.9 -1.9 0\n"
                           "vertex 1.9 1.9 0\nendloop\nendfacet\n"
                           "facet normal 0 0 1\nouter loop\nvertex -1.9 -1.9 0\nvertex 1.9 1.9 0\n"
                           "vertex -1.9 1.9 0\nendloop\nendfacet\nendsolid plane\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

class Walls : public testing::TestWithParam<WallCase> {};

/// One cube with one contact sphere above the wall z = 0, in gravity.
void drop_cube(RockScene& scene, const WallCase& wall, const ScratchFolder& folder) {
  scene.command("pair_style muckpile/block youngs_modulus 1e7");
  scene.command("pair_coeff * *");
  scene.cut("0.6 1.1 -0.8 -0.3 0.3 0.8",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1 "
            "sphere_growth " +
                std::to_string(wall.growth));
  scene.command("fix m1 all property/global youngsModulus peratomtype 1e7");
  scene.command("fix m2 all property/global poissonsRatio peratomtype 0.25");
  scene.command("fix m3 all property/global coefficientRestitution peratomtypepair 1 0.1");
  scene.command("fix m4 all property/global coefficientFriction peratomtypepair 1 0.6");
  if (wall.mesh) {
    write_plane(folder / "plane.stl");
    scene.command("fix floor all mesh/surface file " + (folder / "plane.stl").string() + " type 1");
    scene.command(
        "fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes floor");
  } else {
    scene.command(
        "fix wall all wall/gran model hertz tangential history primitive type 1 zplane 0");
  }
  scene.command("fix pull all gravity 9.81 vector 0 0 -1");
  scene.command("fix ledger all muckpile/ledger");
}

TEST_P(Walls, BlockFallsAndComesToRestWhereTheWallCarriesItsWeight) {
  const ScratchFolder folder(std::string("wall_") + GetParam().name);
  RockScene scene(MPI_COMM_WORLD, "-2 2 -2 2 -1 3");
  drop_cube(scene, GetParam(), folder);
  ASSERT_EQ(scene.blocks().size(), 1u);
  const double radius = scene.all_spheres().at(1).radius;
  EXPECT_NEAR(radius, 0.5 * kSide * GetParam().growth, 0.01 * kSide);
  constexpr int kFall = 2000;  // 0.2 s; the wall is 0.24 s away, or more
  scene.run(kFall, kStep);
  EXPECT_NEAR(scene.blocks().at(1).velocity.z(), -kGravity * kFall * kStep, 1e-9);
  scene.run(20000, kStep);
  const auto block = scene.blocks().at(1);
  // Hertz: m g = 4/3 E* sqrt(R) d^1.5 with 1/E* = 2 (1 - nu^2) / E, so d = 10 mm.
  const double weight = kDensity * std::pow(kSide, 3) * kGravity;
  const double contact = kModulus / (2.0 * (1.0 - kPoisson * kPoisson));
  const double sunk = std::pow(0.75 * weight / (contact * std::sqrt(radius)), 2.0 / 3.0);
  EXPECT_NEAR(scene.all_spheres().at(1).centre.z(), radius - sunk, 1e-3 * sunk);
  EXPECT_LT(block.velocity.norm(), 1e-5);
  // What gravity gave the wall has taken.
  EXPECT_NEAR(scene.output("ledger", 11) / -scene.output("ledger", 4), 1.0, 1e-3);
  EXPECT_LT(scene.output("ledger", 0), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(LiggghtsStyles, Walls,
                         testing::Values(WallCase{"plane", false, 1.0},
                                         WallCase{"plane_grown", false, 1.2},
                                         WallCase{"mesh", true, 1.0},
                                         WallCase{"mesh_grown", true, 1.2}),
                         [](const auto& one) { return std::string(one.param.name); });

const std::string kCut =
    "density 2600 size uniform 0.35 block_min 0.35 block_max 0.35 spheres_per_block 3 seed 4";

TEST(LiggghtsStyles, RegionsOfAnyShapeAreCut) {
  struct Case {
    std::string words;
    double volume;
  };
  const double pi = std::numbers::pi;
  for (const Case& one : {Case{"cylinder z 0 0 1 -0.8 0.8 units box", 1.6 * pi},
                          Case{"sphere 0 0 0 1 units box", 4.0 / 3.0 * pi}}) {
    RockScene scene(MPI_COMM_WORLD, "-2 2 -2 2 -2 2");
    scene.command("region rock " + one.words);
    scene.command("create_blocks rock " + kCut);
    double volume = 0.0;
    for (const auto& [tag, block] : scene.blocks()) {
      volume += block.mass / kDensity;
      EXPECT_LT(std::hypot(block.centre.x(), block.centre.y()), 1.0) << one.words;
    }
    EXPECT_NEAR(volume / one.volume, 1.0, 0.1) << one.words;
  }
}

TEST(LiggghtsStyles, GroupOfARegionIsPushedAlone) {
  RockScene scene(MPI_COMM_WORLD, "-2 2 -2 2 -2 2");
  scene.cut("-1 1 -0.5 0.5 -0.5 0.5",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1 seed 4");
  scene.command("region right block 0 2 -2 2 -2 2 units box");
  scene.command("group right region right");
  scene.command("fix push right addforce 0 0 100");
  scene.run(100, kStep);
  const auto spheres = scene.all_spheres();
  for (const auto& [tag, block] : scene.blocks()) {
    // The bodies' forces at the start of a run are summed before fix addforce has its say.
    const double kick = 100.0 / block.mass * 99.5 * kStep;
    EXPECT_NEAR(block.velocity.z(), spheres.at(tag).centre.x() > 0.0 ? kick : 0.0, 1e-12) << tag;
  }
}

/// Some 40 blocks that burst.
void burst(RockScene& scene) {
  scene.cut("-0.8 0.8 -0.8 0.8 -0.5 0.5", kCut);
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 cohesion "
      "4e6 friction_angle 50 tension 2e6 contact_check no");
  scene.command("fix ledger all muckpile/ledger");
  const Vec3 spin(4, -6, 20);
  scene.set_motion([&](int, const Vec3& at) {
    return Motion{spin.cross(at) + 0.5 * Vec3(std::sin(3 * at.y()), std::cos(2 * at.z()), 0), spin};
  });
}

TEST(LiggghtsStyles, VariablesAndIfReadOurResults) {
  RockScene scene(MPI_COMM_WORLD, "-4 4 -4 4 -4 4");
  burst(scene);
  scene.command("variable share equal f_joint[2]/f_joint[1]");
  scene.command("variable kinetic equal f_ledger[1]");
  const std::string decide = "if \"${share} > 0.3\" then \"timestep 2e-6\" else \"timestep 1e-6\"";
  scene.run(0, 1e-5);
  scene.command(decide);
  EXPECT_EQ(scene.time_step(), 1e-6);
  scene.run(1000, 1e-5);
  const double share = scene.output("joint", 2) / scene.output("joint", 1);
  ASSERT_GT(share, 0.3);
  EXPECT_EQ(scene.variable("share"), share);
  EXPECT_EQ(scene.variable("kinetic"), scene.output("ledger", 1));
  scene.command(decide);
  EXPECT_EQ(scene.time_step(), 2e-6);
}

struct DumpRow {
  SphereNow sphere;
  int type = 0;
};

/// Rows of a dump of `id type x y z vx vy vz radius`, by id.
std::map<int, DumpRow> read_dump(const std::filesystem::path& path) {
  std::map<int, DumpRow> rows;
  std::istringstream in(content(path));
  std::string line;
  while (std::getline(in, line) && line.rfind("ITEM: ATOMS", 0) != 0) {
  }
  int id = 0;
  for (DumpRow row; in >> id;) {
    in >> row.type;
    for (Vec3* v : {&row.sphere.centre, &row.sphere.velocity}) in >> (*v)[0] >> (*v)[1] >> (*v)[2];
    in >> row.sphere.radius;
    EXPECT_TRUE(rows.emplace(id, row).second) << "sphere " << id << " twice";
  }
  return rows;
}

TEST(LiggghtsStyles, DumpHoldsTheSpheresOfEveryBlock) {
  const ScratchFolder folder("dump");
  RockScene scene(MPI_COMM_WORLD, "-4 4 -4 4 -4 4");
  burst(scene);
  scene.command("dump spheres all custom 400 " + (folder / "spheres_*.txt").string() +
                " id type x y z vx vy vz radius");
  scene.command("dump_modify spheres format \"%d %d %.12g %.12g %.12g %.12g %.12g %.12g %.12g\"");
  scene.run(800, 1e-5);
  scene.command("undump spheres");
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(read_dump(folder / "spheres_400.txt").size(), scene.all_spheres().size());
  const auto rows = read_dump(folder / "spheres_800.txt");
  const auto blocks = scene.blocks();
  ASSERT_EQ(rows.size(), 3 * blocks.size());
  for (const auto& [id, row] : rows) {
    const SphereNow& held = scene.all_spheres().at(id);
    EXPECT_EQ(row.type, 1);
    EXPECT_NEAR(row.sphere.radius, held.radius, 1e-11);  // twelve digits
    EXPECT_LT((row.sphere.centre - held.centre).norm(), 1e-10);
    // The sphere moves with its block: v = v_b + w x r.
    const BlockNow& block = blocks.at((id - 1) / 3 + 1);
    const Vec3 carried = block.velocity + block.spin.cross(row.sphere.centre - block.centre);
    EXPECT_LT((row.sphere.velocity - carried).norm(), 1e-9 * carried.norm()) << id;
  }
}

}  // namespace
}  // namespace muckpile::test
