// SPDX-License-Identifier: GPL-2.0-or-later
// perf_post_run FOLDER [BLOCKS [SNAPSHOTS]]: writes the dump/ of a made-up bench run, Voronoi
// blocks thrown to a pile, for measuring how long muckpile-post takes: 200,000 blocks and 30
// snapshots. Scope: files of the right size and form; places are a smooth map of the bench, no
// physics.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "../unit/postproc/synthetic_run.h"
#include "geometry/files/block_file.h"
#include "graded_bench.h"

namespace muckpile::perf {
namespace {

constexpr double kRatio = 3.0, kBurdenOfRun = 3.0, kHeightOfRun = 10.0,
                 kEnd = 6.0;  // [-], [m], [s]
constexpr int kRows = 200;    // of history

bool is_thrown(const StartBlock& block) {
  return block.centroid.x() > -kBurdenOfRun && block.centroid.x() < 0.0 && block.centroid.z() > 0.0;
}

// At a share of the way from the bench to a wedge in front of it.
Snapshot snapshot_at(const std::vector<StartBlock>& blocks, double share) {
  Snapshot all = start_snapshot(blocks);
  all.step = std::lround(1e5 * share);
  all.time = kEnd * share;
  int standing = 0;
  for (size_t b = 0; b < blocks.size(); ++b) {
    BlockState& state = all.states[b];
    const Vec3& from = blocks[b].centroid;
    if (!is_thrown(blocks[b])) {
      if (standing == 0) standing = blocks[b].id;
      state.fragment = standing;
      continue;
    }
    const Vec3 to(0.5 + 1.6 * from.z() + 2.0 * (kBurdenOfRun + from.x()), from.y(),
                  0.35 * from.z());
    state.centre = from + share * (to - from);
    state.rotation =
        Quat(Eigen::AngleAxisd(share * (blocks[b].id % 7), Vec3(1, 2, 3).normalized()));
    state.velocity =
        share < 1.0 ? Vec3((to - from) * (4.0 * share * (1.0 - share))) : Vec3(0, 0, 0);
    state.fragment = blocks[b].id;
    state.broken_fraction = 1.0;
  }
  return all;
}

void write_history(const std::filesystem::path& path) {
  std::string text =
      "step,time_s,timestep_s,phase,joints,joints_broken,fastest_block_m_s,kinetic_J,elastic_J,"
      "contact_elastic_J,gravity_J,blast_work_J,fracture_J,joint_friction_J,joint_damping_J,"
      "contact_friction_J,contact_damping_J,wall_J,balance_error\n";
  for (int row = 0; row <= kRows; ++row) {
    const double share = static_cast<double>(row) / kRows;
    text += std::to_string(500 * row) + "," + std::to_string(kEnd * share) +
            ",6e-5,throw,1400000,900000," + std::to_string(20.0 * (1.0 - share)) +
            ",5,4,3,2,1,0,0,0,0,0,0,0.001\n";
  }
  testing::write_text(path, text);
}

void write_run(const std::filesystem::path& folder, size_t count, int snapshots) {
  TessellationOptions options = graded_bench({count, kRatio, 3});
  options.sweeps = 0;
  options.region = {};  // a box, whose face is as plane as profile wants it
  options.hi.x() = 0.0;
  const std::vector<Block> shapes = tessellate(options).blocks;
  const std::vector<StartBlock> blocks = testing::as_start_blocks(shapes);
  const std::filesystem::path dump = folder / "dump";
  std::filesystem::create_directories(dump);
  write_blocks((dump / "blocks.vtk").string(), shapes, 1, testing::kDensity);
  write_history(dump / "history.csv");
  testing::write_text(
      dump / "run.json",
      "{\"blocks\": " + std::to_string(blocks.size()) +
          ", \"spheres\": 1000000, \"joints\": 1400000, \"steps\": 100000, \"physical_time_s\": "
          "6,\n"
          " \"wall_time_s\": 3600, \"ranks\": 4, \"energy_balance_error\": 0.001, \"still\": true, "
          "\"version\": \"0\"}\n");
  testing::write_text(
      dump / "scene.json",
      "{\"case\": \"bench\", \"bench_height_m\": 10, \"burden_m\": 3, "
      "\"spacing_m\": 4, \"holes\": 3, \"hole_diameter_m\": 0.09,\n \"charge_length_m\": 7.5, "
      "\"stemming_m\": 3, \"subdrill_m\": 0.5}\n");
  for (int k = 0; k < snapshots; ++k) {
    const Snapshot snapshot = snapshot_at(blocks, static_cast<double>(k) / (snapshots - 1));
    char name[40];
    std::snprintf(name, sizeof name, "blocks_%09ld.csv", snapshot.step);
    testing::write_snapshot(dump / name, blocks, snapshot);
  }
  std::printf("%zu blocks and %d snapshots in %s\n", blocks.size(), snapshots, dump.c_str());
}

}  // namespace
}  // namespace muckpile::perf

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("perf_post_run FOLDER [BLOCKS [SNAPSHOTS]]\n", stderr);
    return 2;
  }
  try {
    const size_t blocks = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 200000;
    const int snapshots = argc > 3 ? std::atoi(argv[3]) : 30;
    muckpile::perf::write_run(argv[1], blocks, std::max(2, snapshots));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "perf_post_run: %s\n", error.what());
    return 1;
  }
  return 0;
}
