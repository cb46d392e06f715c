// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command momentum: what gave the rock its speed, by cause, over time.
// Scope: runs with fix muckpile/impulse; the cone and the surface over a crater's charge, the burden
// of a bench.
#include <algorithm>
#include <cmath>
#include <limits>

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

std::vector<RockPart> parts_of(const ResultFolder& folder) {
  const std::string scene = folder.scene_word("case");
  if (scene == "crater") {
    const double depth = burial_depth(folder);
    return crater_parts(folder.rock(), depth, 0.25 * depth);
  }
  if (scene == "bench") return {burden_of(folder, folder.rock())};
  refuse_to_measure(folder, "momentum", "the run must be a bench or a crater, got '" + scene + "'");
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
    const auto impulses_path =
        folder.dump(impulses_name(snapshot_step(file.filename().string())));
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

void write_table(const ResultFolder& folder, const std::vector<RockPart>& parts,
                 const std::vector<Instant>& instants) {
  CsvWriter csv(folder.file("momentum.csv"), kColumns);
  for (size_t p = 0; p < parts.size(); ++p) {
    for (const auto& [direction, of] :
         {std::pair("outward", &PartBudget::outward), std::pair("upward", &PartBudget::upward)}) {
      for (const Instant& now : instants) {
        const Budget& budget = now.budgets[p].*of;
        std::vector<double> row{now.time, parts[p].radius, folder.symmetry() * parts[p].mass,
                                budget.speed};
        row.insert(row.end(), budget.by_cause.begin(), budget.by_cause.end());
        row.push_back(budget.left());
        csv.row({parts[p].name, direction}, row);
      }
    }
  }
}

// The first part both ways, then two rings of the surface.
Canvas picture_of(const std::vector<RockPart>& parts, const std::vector<Instant>& instants,
                  double depth) {
  std::vector<BudgetCurves> curves;
  const auto add = [&](size_t p, const std::string& title, Budget PartBudget::*of) {
    BudgetCurves curve{title};
    for (const Instant& now : instants) {
      curve.time.push_back(now.time);
      curve.budgets.push_back(now.budgets[p].*of);
    }
    curves.push_back(std::move(curve));
  };
  add(0, parts[0].name + ", outward", &PartBudget::outward);
  add(0, parts[0].name + ", upward", &PartBudget::upward);
  for (const double share : {0.4, 0.9}) {
    const auto ring = std::ranges::min_element(parts.begin() + 1, parts.end(), {}, [&](const RockPart& part) {
      return std::abs(part.radius - share * depth);
    });
    if (ring != parts.end())
      add(static_cast<size_t>(ring - parts.begin()),
          "surface at " + spelled(ring->radius, 2) + " m, outward", &PartBudget::outward);
  }
  return draw_momentum(curves);
}

}  // namespace

void report_momentum(const ResultFolder& folder) {
  const std::vector<RockPart> parts = parts_of(folder);
  const std::vector<Instant> instants = instants_of(folder, parts);
  if (instants.empty() || parts.empty())
    refuse_to_measure(folder, "momentum",
                      "needs impulses_<step>.csv, which fix muckpile/dump writes behind a fix "
                      "muckpile/impulse (-var impulses 1)");
  const bool crater = folder.scene_word("case") == "crater";
  write_table(folder, parts, instants);
  write_png(picture_of(parts, instants, crater ? burial_depth(folder) : 0.0),
            folder.file("momentum.png"));
  folder.merge_into_summary(common_keys(folder), {refusal_key("momentum")});
}

}  // namespace muckpile
