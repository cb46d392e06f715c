// SPDX-License-Identifier: GPL-2.0-or-later
// perf_creation: time to cut a graded bench into blocks and to make facets and spheres of them, on
// one core; prints JSON to standard output.
// Scope: core only. Arguments: numbers of blocks (10000 30000 100000 without any). CPU times.
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "bond/build/facet_builder.h"
#include "bond/build/rigid_body.h"
#include "geometry/cut/relaxation.h"
#include "graded_bench.h"
#include "timing.h"

namespace muckpile::perf {
namespace {

constexpr int kSpheres = 9;          // per block
constexpr double kDensity = 2700.0;  // [kg/m3]
constexpr double kTarget = 15.0;     // per 100,000 blocks, sweeps included [s]
constexpr int kOnce = 1;             // rounds of least_time

/// Where the time goes: each stage by itself, on the relaxed seeds.
nlohmann::ordered_json stages(const TessellationOptions& options, const Tessellation& cut) {
  std::vector<Vec3> seeds;
  for (const Block& block : cut.blocks) seeds.push_back(block.mass.centroid);
  Relaxation relaxation(options, seeds, {}, HoleRings(options));
  const double seeding = least_time([&] { (void)Relaxation(options).seeds(); }, kOnce);
  const double cells = least_time([&] { (void)relaxation.make_blocks(); }, kOnce);
  const double sweep = least_time([&] { relaxation.sweep(); }, kOnce);
  return {{"seeding_s", seeding}, {"one_sweep_s", sweep}, {"final_cells_s", cells}};
}

nlohmann::ordered_json measure(const BenchRock& what) {
  const TessellationOptions options = graded_bench(what);
  Tessellation cut;
  const double cutting = least_time([&] { cut = tessellate(options); }, kOnce);
  FacetSet facets;
  const auto unsupported = [](const Vec3&) { return Support::free; };
  const double facet_time =
      least_time([&] { facets = build_facets(cut.blocks, 1, unsupported); }, kOnce);
  std::size_t spheres = 0;
  const double sphere_time = least_time(
      [&] {
        for (const Block& block : cut.blocks)
          spheres += rigid_body(block, kDensity, {.count = kSpheres}).spheres.size();
      },
      kOnce);
  const auto blocks = static_cast<double>(cut.blocks.size());
  const double total = cutting + facet_time + sphere_time;
  nlohmann::ordered_json result;
  result["blocks"] = cut.blocks.size();
  result["size_ratio"] = what.size_ratio;
  result["holes"] = what.holes;
  result["sweeps"] = options.sweeps;
  result["cut_with_sweeps_s"] = cutting;
  result["facets_s"] = facet_time;
  result["spheres_s"] = sphere_time;
  result["total_s"] = total;
  result["s_per_100000_blocks"] = 1e5 * total / blocks;
  result["of_the_cut"] = stages(options, cut);
  return result;
}

nlohmann::ordered_json measure_all(const std::vector<std::size_t>& counts) {
  nlohmann::ordered_json result;
  result["what"] = "bench with holes, blocks graded around them, 9 spheres each";
  result["processor"] = processor();
  result["target_s_per_100000_blocks"] = kTarget;
  for (const std::size_t blocks : counts) {
    for (const auto& [ratio, holes] : {std::pair(10.0, 1), std::pair(30.0, 1), std::pair(10.0, 50)})
      result["cuts"].push_back(measure({blocks, ratio, holes}));
  }
  return result;
}

}  // namespace
}  // namespace muckpile::perf

int main(int argc, char** argv) {
  std::vector<std::size_t> counts;
  for (int k = 1; k < argc; ++k) counts.push_back(std::strtoul(argv[k], nullptr, 10));
  if (counts.empty()) counts = {10000, 30000, 100000};
  std::cout << muckpile::perf::measure_all(counts).dump(2) << '\n';
  return 0;
}
