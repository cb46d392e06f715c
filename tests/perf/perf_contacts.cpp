// SPDX-License-Identifier: GPL-2.0-or-later
// perf_contacts: time of one rebuild of the contact list and of one step of contact forces on the
// graded bed, on one core; prints JSON to standard output.
// Scope: the list by itself (core) and the whole pair style inside LIGGGHTS; CPU times.
#include <mpi.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "graded_bed.h"
#include "timing.h"

namespace muckpile::perf {
namespace {

constexpr double kSkin = 0.02;       // [m], as in inputs with blocks of 0.1 m
constexpr double kTarget = 0.15;     // of a rebuild, one core [s]
constexpr double kTouching = 0.985;  // spacing at which most neighbours touch [-]
constexpr double kApart = 1.03;      // and at which none do, but all are candidates [-]
constexpr int kSteps = 200;          // rounds of a step

struct Candidates {
  double block_pairs = 0.0, sphere_pairs = 0.0;
};

/// The three parts of a rebuild, by the core classes alone.
nlohmann::ordered_json core_rebuild(const std::vector<testing::BlockSpec>& bed, Candidates& found) {
  const BedSpheres spheres(bed);
  BlockContactList list;
  std::vector<int> dropped;
  const double group =
      least_time([&] { list.group(spheres.view(), static_cast<int>(bed.size())); });
  const double search = least_time([&] { list.find_block_pairs(0.5 * kSkin); });
  const double look = least_time([&] {
    list.find_block_pairs(0.5 * kSkin);
    for (BlockPair& pair : list.block_pairs()) list.look_up(pair, spheres.view(), dropped);
  });
  found.block_pairs = static_cast<double>(list.block_pairs().size());
  for (const BlockPair& pair : list.block_pairs()) found.sphere_pairs += pair.count;
  return {{"group_s", group},
          {"block_search_s", search},
          {"sphere_search_s", look - search},
          {"total_s", group + look},
          {"block_pairs", found.block_pairs},
          {"candidate_sphere_pairs", found.sphere_pairs}};
}

/// One step of the pair style inside LIGGGHTS, and what a rebuild takes there.
nlohmann::ordered_json engine_step(const std::vector<testing::BlockSpec>& bed,
                                   const Candidates& candidates) {
  testing::BlockScene scene(MPI_COMM_WORLD, kHalfBox, kSkin, "youngs_modulus 5e8");
  scene.add(bed);
  double rebuild = 1e30;
  for (int round = 0; round < kRounds; ++round) {
    const double before = scene.sum("rebuild_s"), count = scene.sum("rebuilds");
    scene.run(0, 1e-6);
    rebuild = std::min(
        rebuild, (scene.sum("rebuild_s") - before) / std::max(scene.sum("rebuilds") - count, 1.0));
  }
  const double step = least_time([&] { scene.compute_contacts(); }, kSteps);
  scene.watch_contacts();
  scene.run(0, 1e-6);
  const double watched = least_time([&] { scene.compute_contacts(); }, kSteps);
  return {{"rebuild_wall_s", rebuild},
          {"contact_step_s", step},
          {"contact_step_with_energy_account_s", watched},
          {"contacts", scene.sum("contacts")},
          {"contact_step_ns_per_candidate_pair", 1e9 * step / candidates.sphere_pairs}};
}

nlohmann::ordered_json measure() {
  nlohmann::ordered_json result;
  result["what"] = "8,000 blocks of 0.1 m beside 1,000 of 1 m, nine spheres each";
  result["processor"] = processor();
  result["ranks"] = 1;
  result["rebuild_target_s"] = kTarget;
  for (const auto& [name, spacing] :
       {std::pair("touching", kTouching), std::pair("apart", kApart)}) {
    const auto bed = graded_bed(spacing);
    Candidates candidates;
    result[name]["core_rebuild"] = core_rebuild(bed, candidates);
    result[name]["engine"] = engine_step(bed, candidates);
  }
  return result;
}

}  // namespace
}  // namespace muckpile::perf

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  std::cout << muckpile::perf::measure().dump(2) << '\n';
  MPI_Finalize();
  return 0;
}
