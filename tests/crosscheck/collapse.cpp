// SPDX-License-Identifier: GPL-2.0-or-later
// Heaps of loose clumps in Muckpile and in LAMMPS, measured alike: run-out and rest angle over
// seeds. Scope: crosscheck_collapse FOLDER REPORTS SECONDS reads
// FOLDER/<seed>/<code>/{filled,rest}.txt and FOLDER/<seed>/muckpile/start.txt of collapse_*.in;
// clumps of 2 x 2 x 2 spheres of 0.05 m.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "cpu_time.h"
#include "framework/report.h"
#include "measure/pile.h"
#include "text_dump.h"

namespace muckpile::crosscheck {
namespace {

namespace fs = std::filesystem;
using verification::PlotFrame;
using verification::Quantity;
using verification::Report;

constexpr double kEdge = 0.2, kSpacing = 0.1;  // of a clump; of its spheres' centres [m]
constexpr std::size_t kSpheres = 8;

// Heaps as the blocks and poses that postproc measures

struct Pose {
  Vec3 centre;  // [m]
  Mat3 turn;    // from the axes of the clump to those of the heap
  Vec3 velocity;
};

/// The corner of sphere `s` in its clump: -1 or 1 along x, y and z, in the order of the input.
Vec3 corner(std::size_t s) {
  return {(s & 1U) != 0 ? 1.0 : -1.0, (s & 2U) != 0 ? 1.0 : -1.0, (s & 4U) != 0 ? 1.0 : -1.0};
}

/// From the rows id, clump, x, y, z, vx, vy, vz of its eight spheres.
Pose pose_of(const std::vector<const std::vector<double>*>& spheres) {
  Pose pose{Vec3::Zero(), Mat3::Zero(), Vec3::Zero()};
  for (std::size_t s = 0; s < kSpheres; ++s) {
    const std::vector<double>& row = *spheres[s];
    const Vec3 at(row[2], row[3], row[4]);
    pose.centre += at / kSpheres;
    pose.velocity += Vec3(row[5], row[6], row[7]) / kSpheres;
    pose.turn += at * corner(s).transpose() / (0.5 * kSpheres * kSpacing);
  }
  constexpr double kRounded = 1e-3;  // the dumps have six digits
  if (!(pose.turn * pose.turn.transpose()).isIdentity(kRounded) || pose.turn.determinant() < 0.0)
    throw std::runtime_error("a clump is not what it was at the start");
  return pose;
}

std::map<int, Pose> poses(const fs::path& dump) {
  const std::vector<Frame> frames = read_dump(dump, 8);
  std::map<int, std::vector<const std::vector<double>*>> clumps;
  for (const auto& row : frames.back().rows) clumps[static_cast<int>(row[1])].push_back(&row);
  std::map<int, Pose> result;
  for (const auto& [clump, spheres] : clumps) {
    if (spheres.size() != kSpheres)
      throw std::runtime_error(dump.string() + ": spheres of clump " + std::to_string(clump) +
                               " are lost");
    result.emplace(clump, pose_of(spheres));
  }
  return result;
}

/// The cube around the spheres.
StartBlock cube(int id, const Pose& pose) {
  Polyhedron shape;
  for (std::size_t s = 0; s < kSpheres; ++s)
    shape.vertices.push_back(pose.centre + 0.5 * kEdge * (pose.turn * corner(s)));
  shape.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                 {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return {id, shape, pose.centre, std::pow(kEdge, 3), kEdge, 1.0, false};
}

struct Heap {
  double filled_height;  // of the mass centre in the bin [m]
  double height;         // of the mass centre at rest [m]
  double run_out;        // 98 % of the heap lies behind [m]
  double rest_angle;     // [deg]
  double speed;          // root mean square at the end [m/s]
};

double mean_height(const std::map<int, Pose>& all) {
  double sum = 0.0;
  for (const auto& [id, pose] : all) sum += pose.centre.z();
  return sum / static_cast<double>(all.size());
}

Heap heap_of(const std::map<int, Pose>& start, const fs::path& folder) {
  const std::map<int, Pose> filled = poses(folder / "filled.txt"),
                            rest = poses(folder / "rest.txt");
  if (rest.size() != start.size() || filled.size() != start.size())
    throw std::runtime_error(folder.string() + ": clumps are lost");
  std::vector<StartBlock> blocks;
  Snapshot last;
  double square = 0.0;
  for (const auto& [id, pose] : start) {
    const Pose& end = rest.at(id);
    blocks.push_back(cube(id, pose));
    last.states.push_back({end.centre, Quat(Mat3(end.turn * pose.turn.transpose())), end.velocity,
                           Vec3::Zero(), id, 1.0});
    square += end.velocity.squaredNorm();
  }
  const std::vector<char> all(blocks.size(), 1);
  const PileProfile profile = pile_profile(blocks, last, all, 0.25 * kEdge, all);
  const PileShape shape = pile_shape(profile, 0.0, kEdge);
  return {mean_height(filled), mean_height(rest), shape.toe_98,
          shape.rest_angle * 180.0 / std::numbers::pi,
          std::sqrt(square / static_cast<double>(start.size()))};
}

// The comparison

struct Spread {
  double mean = 0.0, deviation = 0.0;
};

using Measure = double Heap::*;

Spread spread(const std::vector<Heap>& heaps, Measure what) {
  const auto count = static_cast<double>(heaps.size());
  Spread result;
  for (const Heap& heap : heaps) result.mean += heap.*what / count;
  for (const Heap& heap : heaps)
    result.deviation += std::pow(heap.*what - result.mean, 2) / (count - 1.0);
  result.deviation = std::sqrt(result.deviation);
  return result;
}

struct Compared {
  std::string name, unit;
  Measure what;
};

std::string scene(const std::vector<Heap>& heaps) {
  return "collapse, " + std::to_string(heaps.size()) + " seeds";
}

void list(const Compared& what, const std::string& code, const std::vector<Heap>& heaps,
          Report& report) {
  const Spread found = spread(heaps, what.what);
  report.measured({scene(heaps), what.name + ", mean, " + code, what.unit, ""}, found.mean);
  report.measured({scene(heaps), what.name + ", standard deviation, " + code, what.unit, ""},
                  found.deviation);
}

/// The means of the seeds may differ by three standard errors of their difference. Those are known
/// from five runs each: equal means are two apart in one of ten comparisons, three in 2 to 3 of a
/// hundred (Student's t, 5 to 8 degrees of freedom).
void require_same(const Compared& what, const std::vector<Heap>& here,
                  const std::vector<Heap>& there, Report& report) {
  const Spread ours = spread(here, what.what), theirs = spread(there, what.what);
  const double error = std::sqrt((std::pow(ours.deviation, 2) + std::pow(theirs.deviation, 2)) /
                                 static_cast<double>(here.size()));
  report.relative({scene(here), what.name + ", mean, Muckpile against LAMMPS", what.unit, "LAMMPS"},
                  ours.mean, theirs.mean, 3.0 * error / theirs.mean);
}

void plot(const std::string& name, int colour, const std::vector<Heap>& heaps, Report& report) {
  PlotCurve curve{name, CurveStyle::kPoints, colour, {}};
  for (const Heap& heap : heaps) curve.points.emplace_back(heap.run_out, heap.rest_angle);
  report.curve({"crosscheck_collapse", "Collapse of loose clumps, one point per seed",
                "run-out [m]", "rest angle [degrees]"},
               curve);
}

void run(const fs::path& folder, Report& report) {
  std::set<fs::path> seeds;
  for (const auto& entry : fs::directory_iterator(folder)) seeds.insert(entry.path());
  if (seeds.size() < 2) throw std::runtime_error(folder.string() + ": fewer than two seeds");
  std::map<std::string, std::vector<Heap>> heaps;
  std::map<std::string, double> seconds;
  for (const fs::path& seed : seeds) {
    const std::map<int, Pose> start = poses(seed / "muckpile" / "start.txt");
    for (const std::string code : {"muckpile", "lammps"}) {
      const Heap heap = heap_of(start, seed / code);
      heaps[code].push_back(heap);
      seconds[code] += cpu_seconds(seed / code);
      std::printf(
          "%s %-8s %zu clumps, mass centre %.4f m, then %.4f m, run-out %.4f m, rest angle "
          "%.3f degrees, speed left %.1e m/s\n",
          seed.filename().c_str(), code.c_str(), start.size(), heap.filled_height, heap.height,
          heap.run_out, heap.rest_angle, heap.speed);
    }
  }
  const std::vector<Heap>&here = heaps["muckpile"], &there = heaps["lammps"];
  const Compared run_out{"run-out", "m", &Heap::run_out};
  const Compared rest_angle{"rest angle", "deg", &Heap::rest_angle};
  for (const Compared& what : {run_out, rest_angle}) require_same(what, here, there, report);
  for (const Compared& what :
       {run_out, rest_angle,
        Compared{"height of the mass centre in the bin", "m", &Heap::filled_height},
        Compared{"height of the mass centre at rest", "m", &Heap::height}}) {
    list(what, "Muckpile", here, report);
    list(what, "LAMMPS", there, report);
  }
  report.measured({scene(here), "CPU time of all runs, Muckpile", "s", ""}, seconds["muckpile"]);
  report.measured({scene(here), "CPU time of all runs, LAMMPS over Muckpile", "-", ""},
                  seconds["lammps"] / seconds["muckpile"]);
  plot("Muckpile", 0, here, report);
  plot("LAMMPS", 1, there, report);
}

}  // namespace
}  // namespace muckpile::crosscheck

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s FOLDER REPORTS SECONDS\n", argv[0]);
    return 2;
  }
  try {
    muckpile::verification::Report report("crosscheck.collapse");
    muckpile::crosscheck::run(argv[1], report);
    report.write(argv[2], std::stod(argv[3]));
    return report.acceptable() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "crosscheck_collapse: %s\n", error.what());
    return 2;
  }
}
