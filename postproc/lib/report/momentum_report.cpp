// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command momentum: what gave the rock its speed, by cause, over time.
// Scope: runs with fix muckpile/impulse; the cone and the surface over a crater's charge, the
// burden of a bench.
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "io/impulses_file.h"
#include "io/snapshot_reader.h"
#include "measure/momentum.h"
#include "provenance/run_files.h"
#include "report/bench_scene.h"
#include "report/burial_depth.h"
#include "report/momentum_plot.h"
#include "report/not_measurable.h"
#include "report/reports.h"

namespace muckpile {
namespace {

constexpr const char* kColumns =
    "part,direction,time_s,start_radius_m,mass_kg,speed_m_s,before_m_s,wave_m_s,hole_gas_m_s,"
    "joint_gas_m_s,joints_m_s,contacts_m_s,weight_m_s,left_m_s";

RockPart burden_of(const ResultFolder& folder, const std::vector<StartBlock>& blocks) {
  const BenchScene bench = bench_scene(folder, blocks);
  RockPart part{"burden", std::numeric_limits<double>::quiet_NaN()};
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& start = blocks[b].centroid;
    if (blocks[b].image != 0 || !bench.planes.in_front_of(bench.burden, start)) continue;
    part.mass += blocks[b].mass;
    part.blocks.push_back(b);
    part.outward.push_back(bench.planes.outward(start));
  }
  return part;
}

// What is measured: a main part, the first, and rings of the surface beyond it, which a burden has
// not.
struct Parts {
  std::vector<RockPart> all;
  double depth = 0.0;  // of the charge under the surface [m]
};

Parts parts_of(const ResultFolder& folder) {
  const std::string scene = folder.scene_word("case");
  Parts parts;
  if (scene == "crater") {
    parts.depth = burial_depth(folder);
    parts.all = crater_parts(folder.rock(), parts.depth, 0.25 * parts.depth);
  } else if (scene == "bench") {
    parts.all = {burden_of(folder, folder.rock())};
  } else {
    refuse_to_measure(folder, "momentum",
                      "the run must be a bench or a crater, got '" + scene + "'");
  }
  if (parts.all.empty() || parts.all.front().blocks.empty() || parts.all.front().name == "surface")
    refuse_to_measure(folder, "momentum", "no block lies over the charge or in front of it");
  return parts;
}

// Of the snapshots that have impulses, each with its budgets in the order of the parts.
struct Instant {
  double time;
  std::vector<PartBudget> budgets;
};

std::vector<Instant> instants_of(const ResultFolder& folder, const std::vector<RockPart>& parts) {
  std::vector<Instant> instants;
  SnapshotReader reader(folder.blocks(), {}, StateParts::kVelocity);
  for (const auto& file : folder.snapshots()) {
    const auto impulses_path = folder.dump(impulses_name(snapshot_step(file.filename().string())));
    if (!std::filesystem::exists(impulses_path)) continue;
    const Snapshot& snapshot = reader.read(file);
    const std::vector<ByPart> impulses =
        read_impulses(impulses_path, folder.blocks(), folder.run_id());
    Instant& now = instants.emplace_back(Instant{snapshot.time, {}});
    for (const RockPart& part : parts)
      now.budgets.push_back(budget_of(part, folder.blocks(), snapshot, impulses));
  }
  return instants;
}

std::vector<double> row_of(const RockPart& part, int symmetry, double time, const Budget& budget) {
  std::vector<double> row{time, part.radius, symmetry * part.mass, budget.speed};
  row.insert(row.end(), budget.by_cause.begin(), budget.by_cause.end());
  row.push_back(budget.left());
  return row;
}

void write_table(const ResultFolder& folder, const std::vector<RockPart>& parts,
                 const std::vector<Instant>& instants) {
  CsvWriter csv(folder.file("momentum.csv"), kColumns);
  const auto write = [&](size_t p, const char* direction, Budget PartBudget::*of) {
    for (const Instant& now : instants)
      csv.row({parts[p].name, direction},
              row_of(parts[p], folder.symmetry(), now.time, now.budgets[p].*of));
  };
  for (size_t p = 0; p < parts.size(); ++p) {
    write(p, "outward", &PartBudget::outward);
    write(p, "upward", &PartBudget::upward);
  }
}

BudgetCurves curves_of(const std::vector<Instant>& instants, size_t part, const std::string& title,
                       Budget PartBudget::*of) {
  BudgetCurves curves{title};
  for (const Instant& now : instants) {
    curves.time.push_back(now.time);
    curves.budgets.push_back(now.budgets[part].*of);
  }
  return curves;
}

// The ring of the surface that began nearest to this distance from the axis [m]; 0 where there is
// none.
size_t ring_at(const std::vector<RockPart>& parts, double radius) {
  size_t nearest = 0;
  for (size_t p = 1; p < parts.size(); ++p) {
    const auto off = [&](size_t k) { return std::abs(parts[k].radius - radius); };
    if (nearest == 0 || off(p) < off(nearest)) nearest = p;
  }
  return nearest;
}

// The main part both ways, then two rings of the surface.
Canvas picture_of(const Parts& parts, const std::vector<Instant>& instants) {
  const std::string& name = parts.all.front().name;
  std::vector<BudgetCurves> curves{curves_of(instants, 0, name + ", outward", &PartBudget::outward),
                                   curves_of(instants, 0, name + ", upward", &PartBudget::upward)};
  size_t before = 0;
  for (const double share : {0.4, 0.9}) {
    const size_t ring = ring_at(parts.all, share * parts.depth);
    if (ring == before) continue;
    before = ring;
    curves.push_back(curves_of(instants, ring,
                               "surface at " + spelled(parts.all[ring].radius, 2) + " m, outward",
                               &PartBudget::outward));
  }
  return draw_momentum(curves);
}

}  // namespace

void report_momentum(const ResultFolder& folder) {
  const Parts parts = parts_of(folder);
  const std::vector<Instant> instants = instants_of(folder, parts.all);
  if (instants.empty())
    refuse_to_measure(folder, "momentum",
                      "needs impulses_<step>.csv, which fix muckpile/dump writes behind a fix "
                      "muckpile/impulse (-var impulses 1)");
  write_table(folder, parts.all, instants);
  write_png(picture_of(parts, instants), folder.file("momentum.png"));
  folder.merge_into_summary(common_keys(folder), {refusal_key("momentum")});
}

}  // namespace muckpile
