// SPDX-License-Identifier: GPL-2.0-or-later
// perf_voronoi: the diagram of one Lloyd sweep over a graded bench by other means: our cell cutter,
// voro++'s own container, CGAL's Delaunay triangulation; prints JSON to standard output.
// Scope: needs CGAL and is built on demand only. Relaxed seeds in a box, nothing mirrored. For
// cells CGAL would need its tetrahedra joined to volumes and centroids as well: its time is without
// that. Argument: number of blocks.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>
#include <voro++/voro++.hh>

#include "geometry/cut/cell_cutter.h"
#include "geometry/cut/ground.h"
#include "graded_bench.h"
#include "timing.h"

namespace muckpile::perf {
namespace {

constexpr int kRoundsHere = 3;

double cutter_time(const TessellationOptions& options, const std::vector<Vec3>& seeds) {
  const Ground ground(options);
  return least_time(
      [&] {
        CellCutter cutter(seeds, options.lo, options.hi);
        double volume = 0.0;
        for (std::size_t k = 0; k < seeds.size(); ++k) {
          (void)cutter.cut_fast(static_cast<int>(k), 1.5 * ground.size(seeds[k]));
          const LaneCell::Measure cell = cutter.measure();
          volume += cell.volume + cell.centroid.x();
        }
      },
      kRoundsHere);
}

/// With five points per grid cell on average, as its manual advises.
double container_time(const TessellationOptions& options, const std::vector<Vec3>& seeds) {
  const Vec3 edge = options.hi - options.lo;
  const double cell = std::cbrt(edge.prod() / (static_cast<double>(seeds.size()) / 5.0));
  const Eigen::Vector3i n = (edge / cell).array().ceil().cast<int>();
  return least_time(
      [&] {
        voro::container box(options.lo.x(), options.hi.x(), options.lo.y(), options.hi.y(),
                            options.lo.z(), options.hi.z(), n.x(), n.y(), n.z(), false, false,
                            false, 8);
        for (std::size_t k = 0; k < seeds.size(); ++k)
          box.put(static_cast<int>(k), seeds[k].x(), seeds[k].y(), seeds[k].z());
        voro::c_loop_all loop(box);
        voro::voronoicell_neighbor cell_of;
        double sum = 0.0, x = 0.0, y = 0.0, z = 0.0;
        if (!loop.start()) return;
        do {
          if (!box.compute_cell(cell_of, loop)) continue;
          cell_of.centroid(x, y, z);
          sum += cell_of.volume() + x;
        } while (loop.inc());
      },
      kRoundsHere);
}

double delaunay_time(const std::vector<Vec3>& seeds) {
  using Triangulation =
      CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
  std::vector<Triangulation::Point> points;
  for (const Vec3& p : seeds) points.emplace_back(p.x(), p.y(), p.z());
  return least_time([&] { (void)Triangulation(points.begin(), points.end()).number_of_cells(); },
                    kRoundsHere);
}

nlohmann::ordered_json measure(const BenchRock& what) {
  TessellationOptions options = graded_bench(what);
  std::vector<Vec3> seeds;
  options.sweeps = 5;
  options.region = {};  // without images behind its faces cells there would be slivers
  for (const Block& block : tessellate(options).blocks) seeds.push_back(block.mass.centroid);
  return {{"points", seeds.size()},
          {"size_ratio", what.size_ratio},
          {"cell_cutter_s", cutter_time(options, seeds)},
          {"voro_container_s", container_time(options, seeds)},
          {"cgal_delaunay_s", delaunay_time(seeds)}};
}

}  // namespace
}  // namespace muckpile::perf

int main(int argc, char** argv) {
  const std::size_t blocks = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 30000;
  nlohmann::ordered_json result;
  for (const double ratio : {1.0, 10.0, 30.0})
    result.push_back(muckpile::perf::measure({blocks, ratio, 1}));
  std::cout << result.dump(2) << '\n';
  return 0;
}
