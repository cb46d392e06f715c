// SPDX-License-Identifier: GPL-2.0-or-later
// Made-up runs: rock of equal cubes, and a pile or crater built from them cube by cube, so every
// measure is known. Scope: tests only.
#include "synthetic_run.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <sstream>

#include "geometry/files/block_file.h"
#include "geometry/files/panel_mesh.h"

namespace muckpile::testing {
namespace {

// A cube looks the same after a quarter turn, so turned cubes test the rotation without changing
// any measure.
Quat quarter_turn(int which) {
  const Vec3 axes[] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  return Quat(Eigen::AngleAxisd(0.5 * std::numbers::pi, axes[which % 3]));
}

bool in_prism(const StartBlock& block) {
  return block.centroid.x() > -kBurden && block.centroid.x() < 0.0 && block.centroid.z() > 0.0;
}

const char* const kHistory =
    "step,time_s,timestep_s,phase,joints,joints_broken,fastest_block_m_s,kinetic_J,elastic_J,"
    "contact_elastic_J,"
    "gravity_J,blast_work_J,fracture_J,joint_friction_J,joint_damping_J,contact_friction_J,contact_"
    "damping_J,wall_J,"
    "balance_error\n"
    "0,0,1e-5,wave,4000,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n"
    "1000,0.01,1e-5,throw,4000,900,31.5,5,4,3,2,1,0,0,0,0,0,0,-0.002\n"
    "2000,4.5,1e-4,settle,4000,1000,0.001,5,4,3,2,1,0,0,0,0,0,0,0.001\n";

void write_common(const std::filesystem::path& dump, const BenchRun& run) {
  std::filesystem::create_directories(dump);
  write_blocks((dump / "blocks.vtk").string(), run.shapes, 1, kDensity);
  write_text(dump / "history.csv", kHistory);
  write_text(dump / "run.json",
             "{\"blocks\": 1472, \"spheres\": 13248, \"joints\": 4000, \"steps\": 2000, "
             "\"physical_time_s\": 4.5,\n"
             " \"wall_time_s\": 60.0, \"ranks\": 2, \"energy_balance_error\": 0.002, \"still\": "
             "true, \"version\": \"0\"}\n");
  write_snapshot(dump / "blocks_000000000.csv", run.blocks, start_snapshot(run.blocks));
  write_snapshot(dump / "blocks_000002000.csv", run.blocks, run.last);
}

}  // namespace

Block cube_at(const Vec3& low) {
  Block block;
  for (int k = 0; k < 8; ++k)
    block.shape.vertices.push_back(low + kCube * Vec3(k & 1, (k >> 1) & 1, (k >> 2) & 1));
  block.shape.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  block.mass = mass_properties(block.shape);
  block.neighbour.assign(6, 0);
  return block;
}

std::vector<Block> cubes_in(const Vec3& low, const Vec3& high) {
  const auto count = [&](int axis) {
    return static_cast<int>(std::lround((high[axis] - low[axis]) / kCube));
  };
  std::vector<Block> blocks;
  for (int k = 0; k < count(2); ++k) {
    for (int j = 0; j < count(1); ++j) {
      for (int i = 0; i < count(0); ++i) blocks.push_back(cube_at(low + kCube * Vec3(i, j, k)));
    }
  }
  return blocks;
}

std::vector<StartBlock> as_start_blocks(const std::vector<Block>& blocks) {
  std::vector<StartBlock> out;
  for (const Block& b : blocks) {
    out.push_back({static_cast<int>(out.size()) + 1, b.shape, b.mass.centroid, b.mass.volume,
                   std::cbrt(b.mass.volume), kDensity * b.mass.volume, false});
  }
  return out;
}

BenchRun bench_run() {
  BenchRun run{cubes_in({-8.0, -1.0, -1.0}, {0.0, 1.0, kBenchHeight}), {}, {}};
  run.blocks = as_start_blocks(run.shapes);
  run.last = start_snapshot(run.blocks);
  run.last.step = 2000;
  run.last.time = 4.5;
  std::vector<int> placed(4, 0);  // cubes of the pile so far, in each row along y
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    if (!in_prism(run.blocks[b])) continue;
    const double y = run.blocks[b].centroid.y();
    int left = placed[static_cast<size_t>(std::floor((y + 1.0) / kCube))]++;
    int column = 0;
    while (left >= kSteps - column / 2) left -= kSteps - column++ / 2;
    run.last.states[b].centre = {(column + 0.5) * kCube, y, (left + 1) * kLayer - 0.5 * kCube};
    run.last.states[b].rotation = quarter_turn(static_cast<int>(b));
  }
  return run;
}

BenchRun crater_run() {
  BenchRun run{cubes_in({-10.0, -10.0, -5.0}, {10.0, 10.0, 0.0}), {}, {}};
  run.blocks = as_start_blocks(run.shapes);
  run.last = start_snapshot(run.blocks);
  run.last.step = 2000;
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    const Vec3& start = run.blocks[b].centroid;
    if (start.head<2>().norm() < 4.0 && start.z() > -2.0)
      run.last.states[b].centre = {start.x() + 20.0, start.y(), 0.25};
  }
  return run;
}

void shear(std::vector<Block>& blocks, double degrees) {
  const double back = 1.0 / std::tan(degrees * std::numbers::pi / 180.0);
  for (Block& block : blocks) {
    for (Vec3& p : block.shape.vertices) p.x() -= back * p.z();
    block.mass = mass_properties(block.shape);
  }
}

void mark_with_run(const std::filesystem::path& path, const std::string& id) {
  std::istringstream in(text_of(path));
  std::string text, line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (path.extension() == ".json" && number == 1) {
      line.insert(line.find('{') + 1, "\"run_id\": \"" + id + "\", ");
    } else if (path.filename() == "history.csv") {
      line += number == 1 ? ",run_id" : "," + id;
    } else if (number == (path.extension() == ".vtk" ? 2 : 1)) {
      line += " run=" + id;
    }
    text += line + '\n';
  }
  write_text(path, text);
}

void write_snapshot(const std::filesystem::path& path, const std::vector<StartBlock>& blocks,
                    const Snapshot& snapshot) {
  std::FILE* out = std::fopen(path.c_str(), "w");
  if (out == nullptr) throw std::runtime_error("cannot write " + path.string());
  std::fprintf(out, "# step=%ld time_s=%.9g\n", snapshot.step, snapshot.time);
  std::fputs(
      "id,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,fragment_id,"
      "broken_fraction\n",
      out);
  for (size_t k = blocks.size(); k-- > 0;) {  // any order is allowed
    const BlockState& s = snapshot.states[k];
    std::fprintf(out, "%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,0,0,0,%d,%.9g\n",
                 blocks[k].id, s.centre.x(), s.centre.y(), s.centre.z(), s.rotation.w(),
                 s.rotation.x(), s.rotation.y(), s.rotation.z(), s.velocity.x(), s.velocity.y(),
                 s.velocity.z(), s.fragment, s.broken_fraction);
  }
  std::fclose(out);
}

void write_bench(const std::filesystem::path& folder) {
  const BenchRun run = bench_run();
  write_common(folder / "dump", run);
  write_text(folder / "dump" / "scene.json",
             "{\"case\": \"bench\", \"bench_height_m\": 10.5, \"burden_m\": 5.0, \"spacing_m\": "
             "2.0, \"holes\": 1,\n"
             " \"hole_diameter_m\": 0.1, \"charge_length_m\": 9.0, \"stemming_m\": 2.5, "
             "\"subdrill_m\": 1.0}\n");
  Snapshot middle = start_snapshot(run.blocks);
  middle.step = 1000;
  middle.time = 0.01;
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    if (!in_prism(run.blocks[b])) continue;
    middle.states[b].velocity = Vec3(run.blocks[b].centroid.x() > -1.0 ? 14.0 : 6.0, 0.0, 0.0);
  }
  write_snapshot(folder / "dump" / "blocks_000001000.csv", run.blocks, middle);
}

void put_on_slope(const std::filesystem::path& folder, double fall) {
  BenchRun run = bench_run();
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    Vec3& centre = run.last.states[b].centre;
    if (in_prism(run.blocks[b])) centre.z() -= fall * centre.x();
  }
  write_snapshot(folder / "dump" / "blocks_000002000.csv", run.blocks, run.last);
  const Panel floor{
      {Vec3(0, -50, 0), Vec3(100, -50, -100 * fall), Vec3(100, 50, -100 * fall), Vec3(0, 50, 0)}};
  const Panel under{{Vec3(-50, -50, -3), Vec3(0, -50, -3), Vec3(0, 50, -3), Vec3(-50, 50, -3)}};
  write_text(folder / "dump" / "floor.stl", stl_text("floor", std::vector{floor}) +
                                                stl_text("under_the_rock", std::vector{under}));
  std::string scene = text_of(folder / "dump" / "scene.json");
  scene.insert(scene.find('{') + 1, "\"floor_survey\": 1, \"floor_front_m\": 0.001, ");
  write_text(folder / "dump" / "scene.json", scene);
}

void write_crater(const std::filesystem::path& folder) {
  write_common(folder / "dump", crater_run());
  write_text(folder / "dump" / "scene.json",
             "{\"case\": \"crater\", \"burial_depth_m\": 2.0, \"charge_mass_kg\": 10.0, "
             "\"hole_diameter_m\": 0.2}\n");
}

void write_heap(const std::filesystem::path& folder) {
  const BenchRun bench = bench_run();
  BenchRun heap;
  for (size_t b = 0; b < bench.blocks.size(); ++b) {
    if (!in_prism(bench.blocks[b])) continue;
    heap.shapes.push_back(bench.shapes[b]);
    heap.last.states.push_back(bench.last.states[b]);
  }
  heap.blocks = as_start_blocks(heap.shapes);
  heap.last.step = 2000;
  heap.last.time = 4.5;
  write_common(folder / "dump", heap);
  write_text(folder / "dump" / "scene.json", "{\"case\": \"heap\"}\n");
}

}  // namespace muckpile::testing
